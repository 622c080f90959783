//! Leg angles for level feet under the torso.

use glam::Affine3A;

use crate::kinematics::{YawFrom, legs_angles};
use crate::limbs::LegAngles;
use crate::model::RobotModel;
use crate::pose::Pose2;

/// Pose of a level sole. Frame: on the ground under the middle between the hips, x as the torso faces.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Foot {
    /// Point under the ankle, and heading of the foot.
    pub pose: Pose2,
    /// Height of the sole over the ground, m.
    pub lift: f32,
}

/// Leg angles, left first, for two level feet, with the middle of the hips `hip_height` m over the ground and the torso
/// rolled by `roll` rad (positive to the right).
///
/// The mean heading of the feet should equal the torso's: the shared hip yaw-pitch turns both feet symmetrically.
#[must_use]
pub fn level_legs<M: RobotModel>(feet: &[Foot; 2], hip_height: f32, roll: f32) -> [LegAngles; 2] {
    let torso = Affine3A::from_rotation_x(-roll);
    let [left, right] = feet.map(|foot| {
        let place = foot.pose.position.extend(foot.lift + M::DIMENSIONS.foot_height - hip_height);
        torso * Affine3A::from_translation(place) * Affine3A::from_rotation_z(foot.pose.heading)
    });
    legs_angles::<M>(&left, &right, YawFrom::Mean)
}
