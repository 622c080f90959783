//! Joint angles within the limits and the maximum speeds of a robot.

use crate::bounds::clamp;
use crate::joints::{Joint, Joints};
use crate::model::RobotModel;

impl Joints<f32> {
    /// Clamps every joint to its range in [`RobotModel::limits`].
    #[must_use]
    pub fn clamp_to_limits(&self, model: &RobotModel) -> Self {
        let mut clamped = *self;
        for joint in Joint::ALL {
            clamped[joint] = model.limits[joint].clamp(self[joint]);
        }
        clamped
    }

    /// Whether every joint is within its range in [`RobotModel::limits`].
    #[must_use]
    pub fn within_limits(&self, model: &RobotModel) -> bool {
        Joint::ALL.into_iter().all(|joint| model.limits[joint].contains(self[joint]))
    }

    /// Angles after `dt` seconds of motion to `targets`, each joint at most at its maximum speed ([`RobotModel::max_speeds`]).
    ///
    /// A joint with a NaN target does not move; no joint moves if `dt` is negative or NaN.
    #[must_use]
    pub fn moved_toward(&self, model: &RobotModel, targets: &Self, dt: f32) -> Self {
        let mut moved = *self;
        for joint in Joint::ALL {
            let most = model.max_speeds[joint] * dt;
            let way = targets[joint] - self[joint];
            if most > 0.0 && !way.is_nan() {
                moved[joint] += clamp(way, -most, most);
            }
        }
        moved
    }
}
