//! Leg angles for level feet under the torso.

use glam::Affine3A;

use crate::kinematics::{YawFrom, legs_angles};
use crate::limbs::LegAngles;
use crate::model::RobotModel;
use crate::pose::Pose2;
use crate::side::Side;

/// Pose of a level sole. Frame: on the ground under the middle between the hips, x as the torso faces.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Foot {
    /// Point under the ankle, and heading of the foot.
    pub pose: Pose2,
    /// Height of the sole over the ground, m.
    pub lift: f32,
}

/// A tilt of the whole robot about its support foot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Tilt {
    /// Support side.
    pub(crate) support: Side,
    /// Roll, rad; positive leans to the right.
    pub(crate) roll: f32,
    /// Pitch, rad; positive leans forward.
    pub(crate) pitch: f32,
}

impl Tilt {
    /// Turns the swing foot back about the support foot, so that it meets the ground level where it was planned.
    fn level(&self, [left, right]: [Affine3A; 2]) -> [Affine3A; 2] {
        let (support, swing) = if self.support == Side::Left { (left, right) } else { (right, left) };
        let back = Affine3A::from_rotation_x(-self.roll) * Affine3A::from_rotation_y(-self.pitch);
        let at = Affine3A::from_translation(support.translation.into());
        let swing = at * back * at.inverse() * swing;
        if self.support == Side::Left { [support, swing] } else { [swing, support] }
    }
}

/// Leg angles, left first, for two level feet, with the middle of the hips `hip_height` m over the ground and the torso
/// rolled by `roll` rad (positive to the right).
///
/// The mean heading of the feet should equal the torso's: the shared hip yaw-pitch turns both feet symmetrically.
#[must_use]
pub fn level_legs(model: &RobotModel, feet: &[Foot; 2], hip_height: f32, roll: f32) -> [LegAngles; 2] {
    tilted_legs(model, feet, hip_height, roll, None)
}

/// As [`level_legs`], with a swing foot that is level while the robot tilts.
pub(crate) fn tilted_legs(
    model: &RobotModel,
    feet: &[Foot; 2],
    hip_height: f32,
    roll: f32,
    tilt: Option<Tilt>,
) -> [LegAngles; 2] {
    let torso = Affine3A::from_rotation_x(-roll);
    let poses = feet.map(|foot| {
        let place = foot.pose.position.extend(foot.lift + model.dimensions.foot_height - hip_height);
        torso * Affine3A::from_translation(place) * Affine3A::from_rotation_z(foot.pose.heading)
    });
    let [left, right] = tilt.map_or(poses, |tilt| tilt.level(poses));
    legs_angles(model, &left, &right, YawFrom::Mean)
}
