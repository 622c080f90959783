//! What can be written in the macros: grammar, model, rules and the wording of every message.
//!
//! Nothing here knows of `proc_macro` or of generated code: a tool that reads or edits the same source text can use the
//! same rules.

pub(crate) mod component;
pub(crate) mod number;
pub(crate) mod params;
pub(crate) mod report;
pub(crate) mod text;
pub(crate) mod tree;
pub(crate) mod types;
pub(crate) mod wording;
