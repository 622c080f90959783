//! Shared basis of the command-line tools: output for people and for programs, errors, exit codes, signals, and many runs
//! in parallel.

mod batch;
mod console;
mod failure;
mod folder;
pub mod interrupt;
mod outcome;
pub mod statistics;

pub use batch::{Batch, STACK_BYTES};
pub use console::{Console, Style};
pub use failure::Failure;
pub use folder::make_folder;
pub use outcome::Outcome;
