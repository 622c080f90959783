//! The log of a run: lines that components write with the macros of the crate [`log`].

mod lines;
mod logger;
mod waiting;

pub(crate) use lines::Lines;
