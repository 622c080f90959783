//! Targets of legs and arms over given feet.

use crate::feet::{Foot, Tilt, tilted_legs};
use crate::limbs::{ArmAngles, Limbs};
use crate::model::{Parameters, RobotModel};
use crate::pose::Pose2;
use crate::side::Side;

impl Parameters {
    /// Both feet side by side under the hips.
    #[must_use]
    pub fn together(&self) -> [Foot; 2] {
        Side::BOTH.map(|side| Foot { pose: Pose2::new(0.0, side.sign() * self.half_spacing, 0.0), lift: 0.0 })
    }

    /// Stand in which this gait begins and ends.
    #[must_use]
    pub fn stand(&self, model: &RobotModel) -> Limbs {
        self.limbs(model, &self.together(), 0.0, None)
    }

    /// Arms and legs over the given feet, with the torso rolled by `roll` rad, and the swing foot levelled against a `tilt`.
    /// The arms swing opposite to the legs.
    pub(super) fn limbs(&self, model: &RobotModel, feet: &[Foot; 2], roll: f32, tilt: Option<Tilt>) -> Limbs {
        let behind = feet.map(|mut foot| {
            foot.pose.position.x -= self.torso_offset;
            foot
        });
        let arm = |side: Side| {
            let opposite = feet[side.other().index()].pose.position.x;
            ArmAngles::hanging(model, side, -self.arm_swing_gain * opposite, self.arm_roll)
        };
        Limbs { legs: tilted_legs(model, &behind, self.hip_height, roll, tilt), arms: Side::BOTH.map(arm) }
    }
}
