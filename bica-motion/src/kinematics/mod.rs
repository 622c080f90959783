//! Where the parts of the body are, and which angles bring the feet to a place.
//!
//! Poses are [`glam::Affine3A`] of a rotation and a translation: `pose.transform_point3(p)` takes a point of the part's
//! frame to the robot frame (origin midway between the hips). At zero angles every frame is parallel to the robot's:
//! x forward, y left, z up.

mod ground;
mod inverse;
mod segment;
mod skeleton;

pub use ground::{ground_from_robot, ground_from_soles};
pub use inverse::{LegAngles, YawFrom, leg_angles, leg_angles_at, legs_angles};
pub use segment::{SEGMENTS, Segment};
pub use skeleton::Skeleton;

use glam::{Affine3A, Vec3};

use crate::joints::Joints;
use crate::robot::CameraId;
use crate::side::Side;

/// The pose of a sole in the robot frame: under the ankle, on the ground when the foot stands.
#[must_use]
pub fn sole(side: Side, angles: &Joints) -> Affine3A {
    skeleton::sole(skeleton::leg(side, angles)[5])
}

/// The pose of a foot in the robot frame, with its origin where the ankle's two axes meet.
#[must_use]
pub fn ankle(side: Side, angles: &Joints) -> Affine3A {
    skeleton::leg(side, angles)[5]
}

/// The poses of an arm's parts in the robot frame: shoulder, biceps, elbow, forearm, hand.
#[must_use]
pub fn arm(side: Side, angles: &Joints) -> [Affine3A; 5] {
    skeleton::arm(side, angles)
}

/// The poses of a leg's parts in the robot frame: pelvis, hip, thigh, tibia, ankle, foot.
#[must_use]
pub fn leg(side: Side, angles: &Joints) -> [Affine3A; 6] {
    skeleton::leg(side, angles)
}

/// The pose of a camera in the robot frame: x along the optical axis, y to the left of the image, z up the image.
#[must_use]
pub fn camera(camera: CameraId, angles: &Joints) -> Affine3A {
    skeleton::camera(skeleton::head(angles)[1], camera)
}

/// The whole body's centre of mass in the robot frame, m.
#[must_use]
pub fn centre_of_mass(angles: &Joints) -> Vec3 {
    Skeleton::of(angles).centre_of_mass()
}
