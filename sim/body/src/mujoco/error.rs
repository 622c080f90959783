//! Errors of the dynamic simulator.

use core::fmt;

/// The reason why a [`Model`](super::Model) cannot be built.
#[derive(Clone, Debug, PartialEq)]
pub enum Error {
    /// A parameter of the physics is not finite or outside its range.
    Physics {
        /// Name of the parameter.
        name: &'static str,
        /// Rejected value.
        value: f32,
        /// Minimum and maximum.
        range: (f32, f32),
    },
    /// MuJoCo rejects the model.
    Model(String),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Physics { name, value, range: (least, most) } => {
                write!(f, "`{name}` is {value}, outside of its range {least} to {most}")
            }
            Self::Model(error) => write!(f, "MuJoCo rejects the model: {error}"),
        }
    }
}

impl core::error::Error for Error {}
