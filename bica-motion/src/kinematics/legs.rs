//! Inverse kinematics of both legs.
//!
//! Both legs share the motor of the hip yaw-pitch, so a pair of foot poses generally requires two values of it. One value
//! is chosen and both legs are solved with it. Places and sole normals stay exact; only the yaw of the feet deviates. The
//! legs of a robot with two hip yaws are independent.

use glam::Affine3A;

use crate::joints::Joint;
use crate::limbs::LegAngles;
use crate::model::RobotModel;
use crate::side::Side;

/// Choice of the shared hip yaw-pitch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum YawFrom {
    /// Mean of the values that both legs require: the yaw between the feet is exact.
    Mean,
    /// The value that one leg requires: the pose of that foot is exact.
    Leg(Side),
    /// This angle, rad.
    Angle(f32),
}

/// Angles of both legs, left first, for the poses of both feet, with the shared hip yaw-pitch chosen by `yaw`.
///
/// Poses as in [`RobotModel::leg_angles`]. With two hip yaws, `yaw` has no meaning. The hip yaw-pitch is clamped to its range.
#[must_use]
pub fn legs_angles(model: &RobotModel, left: &Affine3A, right: &Affine3A, yaw: YawFrom) -> [LegAngles; 2] {
    if !model.leg.shares_hip_yaw() {
        return [model.leg_angles(Side::Left, left), model.leg_angles(Side::Right, right)];
    }
    let of_left = || model.leg_angles(Side::Left, left).hip_yaw_pitch;
    let of_right = || model.leg_angles(Side::Right, right).hip_yaw_pitch;
    let shared = match yaw {
        YawFrom::Mean => 0.5 * (of_left() + of_right()),
        YawFrom::Leg(Side::Left) => of_left(),
        YawFrom::Leg(Side::Right) => of_right(),
        YawFrom::Angle(angle) => angle,
    };
    let shared = model.limits[Joint::LHipYawPitch].clamp(shared);
    [model.leg_angles_at(Side::Left, left, shared), model.leg_angles_at(Side::Right, right, shared)]
}
