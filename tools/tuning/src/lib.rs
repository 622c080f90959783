//! Parameters of a robot in layers.
//!
//! The values of a tree's parameters come from several places. Each one states only what differs from the ones before it:
//!
//! 1. the defaults in the source,
//! 2. `tune/<kind>.toml`: for all robots of a kind, or for a simulated world,
//! 3. `tune/<robot>.toml`: for one robot,
//! 4. assignments `Component.name=value` on the command line.
//!
//! [`Layers`] reads them and applies them to a tree as one batch; [`write()`] writes a tune file and keeps the comments that a
//! person wrote in it. Wrong names, kinds and values are errors that name file, line and remedy.

mod comments;
mod file;
mod layers;
mod write;

pub use layers::{Layers, Value};
pub use write::{key, render, write};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
