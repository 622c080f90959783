//! Firmware image in QEMU as a robot controller that exchanges messages with a program.
//!
//! [`Emulator`] starts QEMU and connects a [`Link`] to the image. [`Controller`] runs the microcontroller in lockstep
//! with a world: one sense-think-act cycle for each set of sensor values. One instruction takes one nanosecond of the
//! microcontroller's time, so a measured time is a number of instructions, equal on every computer.

mod controller;
mod link;
mod messages;
mod qemu;

use std::fmt::Display;
use std::io;

use bica_wire::model::Invalid;

pub use controller::{Controller, CycleReport, command_bits};
pub use link::{Link, Rx, Tx};
pub use messages::{MESSAGES, SensorsMessage, decode_command};
pub use qemu::{Emulator, Transport};

fn error(what: impl Into<String>) -> Invalid {
    Invalid::new(what, "`cargo xtask firmware` installs what is needed, builds the image and tests it")
}

fn disconnected(cause: &io::Error) -> Invalid {
    error(format!("the emulator disconnected: {cause}"))
}

pub(crate) fn unexpected(message: impl Display) -> Invalid {
    error(format!("unexpected message from the robot: {message}"))
}
