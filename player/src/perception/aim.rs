//! Directions as the head knows them.

use glam::{Vec2, Vec3};
use libm::{atan2f, hypotf};

/// How high the cameras are over the ground, m, in a walking robot.
const EYE_HEIGHT: f32 = 0.48;

/// A direction from the head, seen from an upright torso.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Direction {
    /// Rad to the left.
    pub pan: f32,
    /// Rad below the horizon.
    pub down: f32,
}

impl Direction {
    /// Of what lies along `way` (ground frame: x forward, y left, z up).
    #[must_use]
    pub fn of(way: Vec3) -> Self {
        Self { pan: atan2f(way.y, way.x), down: atan2f(-way.z, hypotf(way.x, way.y)) }
    }

    /// Of a point on the ground, m, `height` m over it.
    #[must_use]
    pub fn of_ground(point: Vec2, height: f32) -> Self {
        Self::of(point.extend(height - EYE_HEIGHT))
    }
}
