//! The forward on a microcontroller, for any board.
//!
//! The microcontroller runs the activation tree. The world is on the other end of a serial link with the messages of
//! `bica-wire`. There is no heap: an image that allocates does not link.
//!
//! The program of a board implements [`Board`], calls [`init`] in its `main` and [`run`] in its task, and [`handle_panic`] in its
//! panic handler. `docs/firmware-port.md` describes a port step by step.
#![no_std]

mod board;
mod controller;
mod crash_log;
mod faults;
mod image;
mod init;
mod link;
mod meter;
#[cfg(feature = "monitor")]
mod monitor_line;
mod no_line;
mod panic;
mod run;
mod stack;
mod tree;

pub use board::{Board, Links};
pub use init::{Robot, init};
pub use no_line::NoLine;
pub use panic::handle_panic;
pub use run::run;
