//! Bearings relative to the head.

use bica_motion::model::RobotModel;
use glam::{Vec2, Vec3};
use libm::{atan2f, hypotf};

/// Direction from the head, relative to an upright torso.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, postcard_schema::Schema)]
pub struct Bearing {
    /// Angle to the left, rad.
    pub pan: f32,
    /// Angle below the horizon, rad.
    pub down: f32,
}

impl Bearing {
    /// The bearing of a direction vector (ground frame: x forward, y left, z up).
    #[must_use]
    pub fn of(direction: Vec3) -> Self {
        Self { pan: atan2f(direction.y, direction.x), down: atan2f(-direction.z, hypotf(direction.x, direction.y)) }
    }

    /// The bearing of a point at height `height`, m, above a position on the ground, m, from a camera of this model.
    #[must_use]
    pub fn of_ground(model: &RobotModel, place: Vec2, height: f32) -> Self {
        Self::of(place.extend(height - model.camera_height))
    }
}
