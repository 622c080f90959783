//! Forward and inverse kinematics.
//!
//! Poses are [`glam::Affine3A`] with a rotation and a translation: `pose.transform_point3(p)` maps a point of a segment's
//! frame to the robot frame (origin midway between the hips). At zero angles every frame is parallel to the robot's:
//! x forward, y left, z up.

mod ground;
mod legs;
mod skeleton;

pub use ground::{ground_from_robot, ground_from_soles};
pub use legs::{YawFrom, legs_angles};
pub use skeleton::Skeleton;

pub use crate::limbs::LegAngles;
pub use crate::segment::{SEGMENTS, Segment};

use glam::{Affine3A, Vec3};

use crate::joints::Joints;
use crate::model::RobotModel;
use crate::robot::CameraId;
use crate::side::Side;

/// Pose of a sole in the robot frame: under the ankle, on the ground when the foot stands.
#[must_use]
pub fn sole(model: &RobotModel, side: Side, angles: &Joints) -> Affine3A {
    skeleton::sole(model, skeleton::leg(model, side, angles)[5])
}

/// Pose of a foot in the robot frame; its origin is the intersection of the ankle's axes.
#[must_use]
pub fn ankle(model: &RobotModel, side: Side, angles: &Joints) -> Affine3A {
    skeleton::leg(model, side, angles)[5]
}

/// Poses of an arm's segments in the robot frame: shoulder, biceps, elbow, forearm, hand.
#[must_use]
pub fn arm(model: &RobotModel, side: Side, angles: &Joints) -> [Affine3A; 5] {
    skeleton::arm(model, side, angles)
}

/// Poses of a leg's segments in the robot frame: pelvis, hip, thigh, tibia, ankle, foot.
#[must_use]
pub fn leg(model: &RobotModel, side: Side, angles: &Joints) -> [Affine3A; 6] {
    skeleton::leg(model, side, angles)
}

/// Pose of a camera in the robot frame: x along the optical axis, y to the left of the image, z up the image.
#[must_use]
pub fn camera(model: &RobotModel, camera: CameraId, angles: &Joints) -> Affine3A {
    skeleton::camera(model, skeleton::head(model, angles)[1], camera)
}

/// Centre of mass of the whole body in the robot frame, m.
#[must_use]
pub fn centre_of_mass(model: &'static RobotModel, angles: &Joints) -> Vec3 {
    Skeleton::of(model, angles).centre_of_mass()
}
