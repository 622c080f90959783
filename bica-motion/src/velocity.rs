//! Velocity of a robot over the ground.

/// Velocity over the ground in the robot's frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize, postcard_schema::Schema)]
pub struct Velocity {
    /// Forward speed, m/s; negative is backward.
    pub forward: f32,
    /// Speed to the left, m/s; negative is to the right.
    pub left: f32,
    /// Turn rate, rad/s, counter-clockwise.
    pub turn: f32,
}

impl Velocity {
    /// Standing still.
    pub const ZERO: Self = Self::new(0.0, 0.0, 0.0);

    /// A velocity from its components.
    #[must_use]
    pub const fn new(forward: f32, left: f32, turn: f32) -> Self {
        Self { forward, left, turn }
    }

    /// Whether every component is zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.forward == 0.0 && self.left == 0.0 && self.turn == 0.0
    }
}
