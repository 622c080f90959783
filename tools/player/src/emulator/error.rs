//! Errors of an emulated robot.

use std::path::PathBuf;
use std::{fmt, io};

/// Error of an emulated robot.
#[derive(Debug)]
pub enum Error {
    /// The image file does not exist.
    ImageMissing(PathBuf),
    /// QEMU cannot be started.
    QemuUnavailable(io::Error),
    /// The emulator ended, or its link closed.
    Disconnected(io::Error),
    /// The image was built with another schema; the value is its hash.
    SchemaMismatch(u64),
    /// The image was built with other types of sensor values or commands; the value is the hash of their schemas.
    MessagesMismatch(u64),
    /// The robot sent an unexpected message, or none.
    UnexpectedMessage(String),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::ImageMissing(path) => write!(
                f,
                "the firmware image `{}` does not exist: build it with `cargo xtask firmware --build`",
                path.display()
            ),
            Self::QemuUnavailable(error) => {
                write!(f, "cannot start qemu-system-arm ({error}): install QEMU for Arm")
            }
            Self::Disconnected(error) => write!(f, "the emulator disconnected: {error}"),
            Self::SchemaMismatch(schema) => write!(
                f,
                "the image has schema {schema:016x}, this program {:016x}: rebuild it with `cargo xtask firmware --build`",
                bica_wire::SCHEMA
            ),
            Self::MessagesMismatch(messages) => write!(
                f,
                "the image has other sensor values or commands ({messages:016x}, this program {:016x}): rebuild it with \
                 `cargo xtask firmware --build`",
                super::MESSAGES
            ),
            Self::UnexpectedMessage(message) => write!(f, "unexpected message from the robot: {message}"),
        }
    }
}

impl std::error::Error for Error {}
