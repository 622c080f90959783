//! Joint angles within the limits and the maximum speeds of a robot.

use crate::bounds::clamp;
use crate::joints::{Joint, Joints};
use crate::model::RobotModel;

impl Joints<f32> {
    /// Clamps every joint to its range in [`RobotModel::LIMITS`].
    #[must_use]
    pub fn clamp_to_limits<M: RobotModel>(&self) -> Self {
        let mut clamped = *self;
        for joint in Joint::ALL {
            clamped[joint] = M::LIMITS[joint].clamp(self[joint]);
        }
        clamped
    }

    /// Whether every joint is within its range in [`RobotModel::LIMITS`].
    #[must_use]
    pub fn within_limits<M: RobotModel>(&self) -> bool {
        Joint::ALL.into_iter().all(|joint| M::LIMITS[joint].contains(self[joint]))
    }

    /// Angles after `dt` seconds of motion to `targets`, each joint at most at its maximum speed ([`RobotModel::MAX_SPEEDS`]).
    ///
    /// A joint with a NaN target does not move; no joint moves if `dt` is negative or NaN.
    #[must_use]
    pub fn moved_toward<M: RobotModel>(&self, targets: &Self, dt: f32) -> Self {
        let mut moved = *self;
        for joint in Joint::ALL {
            let most = M::MAX_SPEEDS[joint] * dt;
            let way = targets[joint] - self[joint];
            if most > 0.0 && !way.is_nan() {
                moved[joint] += clamp(way, -most, most);
            }
        }
        moved
    }
}
