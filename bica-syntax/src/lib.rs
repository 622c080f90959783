//! What can be written in the macros of BICA: grammar, model, rules and the wording of every message.
//!
//! Nothing here knows of the compiler's `proc_macro` or of generated code: a tool that reads or edits the same source text
//! uses the same rules. Parsers and checks collect mistakes in a [`Report`](report::Report), each pinned to tokens; outside of a
//! macro `proc-macro2` with its feature `span-locations` gives the place of each in the text.

pub mod code;
mod comma;
pub mod component;
pub mod number;
pub mod params;
pub mod plain_item;
pub mod report;
pub mod role;
pub mod table;
pub mod text;
pub mod tree;
mod types;
mod wording;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
