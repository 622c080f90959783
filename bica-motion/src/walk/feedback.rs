//! Feedback of the walk.

use glam::Vec3;

use crate::joints::Joints;
use crate::robot::{FootPressure, Inertial, Sensors};
use crate::side::Side;

/// Measurements that walk and kicks use.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Feedback {
    /// Angular velocity of the torso, rad/s, torso frame.
    pub gyro: Vec3,
    /// Roll of the torso, rad; positive leans to the right.
    pub roll: f32,
    /// Pitch of the torso, rad; positive leans forward.
    pub pitch: f32,
    /// Pressure under the left sole.
    pub left_foot: FootPressure,
    /// Pressure under the right sole.
    pub right_foot: FootPressure,
    /// Measured joint angles, rad; `None` if not measured.
    pub joints: Option<Joints>,
}

impl From<&Sensors<'_>> for Feedback {
    fn from(sensors: &Sensors<'_>) -> Self {
        Self::new(&sensors.inertial, &sensors.left_foot, &sensors.right_foot, &sensors.angles)
    }
}

impl Feedback {
    /// Feedback from the inertial unit, both feet and the measured joint angles.
    #[must_use]
    pub const fn new(
        inertial: &Inertial,
        left_foot: &FootPressure,
        right_foot: &FootPressure,
        angles: &Joints,
    ) -> Self {
        let Inertial { gyro, roll, pitch, .. } = *inertial;
        Self { gyro, roll, pitch, left_foot: *left_foot, right_foot: *right_foot, joints: Some(*angles) }
    }

    /// Force on a foot, N.
    pub(super) fn force(&self, side: Side) -> f32 {
        match side {
            Side::Left => self.left_foot.total(),
            Side::Right => self.right_foot.total(),
        }
    }

    /// Force on both feet, N.
    pub(super) fn weight(&self) -> f32 {
        self.left_foot.total() + self.right_foot.total()
    }
}
