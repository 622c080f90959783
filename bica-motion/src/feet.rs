//! Feet flat on or over the ground under an upright torso.

use glam::Affine3A;

use crate::dimensions::FOOT_HEIGHT;
use crate::kinematics::{LegAngles, YawFrom, legs_angles};
use crate::pose::Pose2;

/// Where a level sole is. Frame: on the ground under the middle between the hips, x as the torso faces.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Foot {
    /// The point under the ankle and the foot's heading.
    pub pose: Pose2,
    /// Height of the sole over the ground, m.
    pub lift: f32,
}

/// The leg angles, left first, for both level feet with the hips' middle `hip_height` m over the ground and the torso
/// rolled by `roll` rad, positive to the right, else upright.
///
/// The feet's mean heading should be the torso's: both legs share a motor, which can only turn them apart.
#[must_use]
pub fn level_legs(feet: &[Foot; 2], hip_height: f32, roll: f32) -> [LegAngles; 2] {
    let torso = Affine3A::from_rotation_x(-roll);
    let [left, right] = feet.map(|foot| {
        let place = foot.pose.position.extend(foot.lift + FOOT_HEIGHT - hip_height);
        torso * Affine3A::from_translation(place) * Affine3A::from_rotation_z(foot.pose.heading)
    });
    legs_angles(&left, &right, YawFrom::Mean)
}
