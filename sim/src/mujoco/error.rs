//! Errors of the dynamic simulator.

use core::fmt;

use crate::setup::SetupError;

/// The reason why a [`MujocoWorld`](super::MujocoWorld) cannot be built.
#[derive(Clone, Debug, PartialEq)]
pub enum Error {
    /// The setup is invalid.
    Setup(SetupError),
    /// The physics are invalid, or MuJoCo rejects the model.
    Body(bica_body::mujoco::Error),
    /// No renderer is available.
    Camera(String),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Setup(error) => error.fmt(f),
            Self::Body(error) => error.fmt(f),
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

impl From<bica_body::mujoco::Error> for Error {
    fn from(error: bica_body::mujoco::Error) -> Self {
        Self::Body(error)
    }
}
