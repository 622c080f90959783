//! Ground frame.
//!
//! The *ground* frame lies in the plane of the support sole. Its origin is midway between both soles (the lifted one
//! projected to the plane), its x axis points along the mean heading of both feet, z is the normal of the plane. In stand it
//! lies between the feet, facing as the robot does.

use glam::{Affine3A, Mat3A, Vec3, Vec3A};
use libm::{atan2f, sincosf};

use crate::joints::Joints;
use crate::kinematics::sole;
use crate::model::RobotModel;
use crate::side::Side;

/// Pose of the robot frame in the ground frame, with the sole of the `support` side flat on the ground.
///
/// Its inverse maps points of the ground frame to the robot frame. Multiplied by [`camera`](super::camera) it is the pose of
/// a camera over the ground.
#[must_use]
pub fn ground_from_robot(model: &RobotModel, support: Side, angles: &Joints) -> Affine3A {
    ground_from_soles(support, &sole(model, Side::Left, angles), &sole(model, Side::Right, angles))
}

/// As [`ground_from_robot`], from the poses of both soles in the robot frame.
#[must_use]
pub fn ground_from_soles(support: Side, left: &Affine3A, right: &Affine3A) -> Affine3A {
    let (support, other) = if support == Side::Left { (left, right) } else { (right, left) };
    let sole_from_robot = rigid_inverse(support);
    let other = sole_from_robot * *other;
    let half_yaw = 0.5 * atan2f(other.matrix3.x_axis.y, other.matrix3.x_axis.x);
    let (s, c) = sincosf(half_yaw);
    let turn = Mat3A::from_cols(Vec3A::new(c, -s, 0.0), Vec3A::new(s, c, 0.0), Vec3A::Z);
    let middle = Vec3A::new(0.5 * other.translation.x, 0.5 * other.translation.y, 0.0);
    Affine3A { matrix3: turn, translation: turn * -middle } * sole_from_robot
}

fn rigid_inverse(pose: &Affine3A) -> Affine3A {
    let matrix3 = pose.matrix3.transpose();
    let place: Vec3 = (matrix3 * -pose.translation).into();
    Affine3A { matrix3, translation: place.into() }
}
