//! Why there is no such world.

use core::fmt;

use crate::setup::SetupError;

/// Why a [`MujocoWorld`](super::MujocoWorld) cannot be made.
#[derive(Clone, Debug, PartialEq)]
pub enum Error {
    /// The setup makes no world.
    Setup(SetupError),
    /// A parameter of the physics is no number or out of its range.
    Physics {
        /// The parameter's name.
        name: &'static str,
        /// What it was.
        value: f32,
        /// Its least and its greatest value.
        range: (f32, f32),
    },
    /// MuJoCo does not take the model.
    Model(String),
    /// Nothing can be drawn.
    Camera(String),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Setup(error) => error.fmt(f),
            Self::Physics { name, value, range: (least, most) } => {
                write!(f, "`{name}` cannot be {value}: it goes from {least} to {most}")
            }
            Self::Model(error) => write!(f, "MuJoCo does not take the model: {error}"),
            Self::Camera(error) => {
                write!(f, "nothing can be drawn: {error}; `cargo xtask mujoco` installs what that needs")
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
