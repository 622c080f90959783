//! The firmware image in QEMU, as a robot's mind that a program can talk to.
//!
//! [`Emulator`] starts QEMU and carries messages; [`Mind`] senses, thinks and acts with the microcontroller in lockstep
//! with a world. One instruction is one nanosecond of the microcontroller's time, so what it measures is a count of
//! instructions, the same on every computer.

mod emulator;
mod error;
mod line;
mod mind;

pub use emulator::{Carrier, Emulator};
pub use error::Error;
pub use line::{Ear, Line, Mouth};
pub use mind::{Mind, Thought, bits};
