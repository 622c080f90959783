//! Sensors of a robot.

/// What a robot measures besides joint angles, angular velocity and acceleration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Senses {
    /// Whether the soles have pressure sensors.
    pub soles: bool,
    /// Whether the inertial unit estimates roll and pitch.
    pub tilt: bool,
}

impl Senses {
    /// Soles and tilt.
    pub const ALL: Self = Self { soles: true, tilt: true };
    /// Neither.
    pub const NONE: Self = Self { soles: false, tilt: false };
}
