//! What can go wrong with an emulated robot.

use std::path::PathBuf;
use std::{fmt, io};

/// What can go wrong with an emulated robot.
#[derive(Debug)]
pub enum Error {
    /// There is no image.
    NoImage(PathBuf),
    /// QEMU cannot be started.
    NoEmulator(io::Error),
    /// The emulator ended, or its pipe did.
    Gone(io::Error),
    /// The image speaks another schema than this program.
    OtherSchema(u64),
    /// The robot said something that nobody could expect there, or nothing.
    Unexpected(String),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoImage(path) => {
                write!(f, "there is no firmware image `{}`: `cargo xtask firmware --build` makes it", path.display())
            }
            Self::NoEmulator(error) => write!(f, "cannot start qemu-system-arm ({error}): install QEMU for Arm"),
            Self::Gone(error) => write!(f, "the emulator has gone: {error}"),
            Self::OtherSchema(schema) => write!(
                f,
                "the image speaks schema {schema:016x}, this program {:016x}: build it again with `cargo xtask firmware --build`",
                bica_wire::SCHEMA
            ),
            Self::Unexpected(what) => write!(f, "the robot said something unexpected: {what}"),
        }
    }
}

impl std::error::Error for Error {}
