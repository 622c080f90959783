//! Range and speed of the head.

/// Pitch range of the head at one yaw, degrees. The same to both sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeadPitchLimit {
    /// Magnitude of the yaw.
    pub yaw: f32,
    /// Minimum pitch (up) at this yaw.
    pub min: f32,
    /// Maximum pitch (down) at this yaw.
    pub max: f32,
}

impl HeadPitchLimit {
    /// A limit from its three angles in degrees.
    #[must_use]
    pub const fn degrees(yaw: f32, min: f32, max: f32) -> Self {
        Self { yaw, min, max }
    }
}

/// Maximum speeds of the head.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeadSpeed {
    /// Maximum yaw rate, rad/s.
    pub yaw: f32,
    /// Maximum pitch rate, rad/s.
    pub pitch: f32,
}
