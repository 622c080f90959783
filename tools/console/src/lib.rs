//! What the command-line tools of BICA share.

mod console;
mod folder;
pub mod interrupt;
mod outcome;
mod progress;
pub mod statistics;

pub use console::{Console, Style};
pub use folder::make_folder;
pub use outcome::{Failure, Outcome};
pub use progress::Progress;

/// Room for a forward on the stack, bytes: it holds a whole image, and is made there before it moves to the heap.
pub const STACK: usize = 32 << 20;
