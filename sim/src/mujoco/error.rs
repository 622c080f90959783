//! Errors of the dynamic simulator.

use core::fmt;

use crate::setup::SetupError;

/// The reason why a [`MujocoWorld`](super::MujocoWorld) cannot be built.
#[derive(Clone, Debug, PartialEq)]
pub enum Error {
    /// The setup is invalid.
    Setup(SetupError),
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
    /// No renderer is available.
    Camera(String),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Setup(error) => error.fmt(f),
            Self::Physics { name, value, range: (least, most) } => {
                write!(f, "`{name}` is {value}, outside of its range {least} to {most}")
            }
            Self::Model(error) => write!(f, "MuJoCo rejects the model: {error}"),
            Self::Camera(error) => {
                write!(
                    f,
                    "camera images cannot be rendered: {error}; `cargo xtask mujoco` installs the required libraries"
                )
            }
        }
    }
}

impl core::error::Error for Error {}

impl From<SetupError> for Error {
    fn from(error: SetupError) -> Self {
        Self::Setup(error)
    }
}
