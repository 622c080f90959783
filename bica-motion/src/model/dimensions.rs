//! Lengths of a robot, and the places of its sensors.

use glam::{Vec2, Vec3};

use crate::robot::CameraId;

/// Place and direction of a camera in the head.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraMount {
    /// Neck to the optical centre, m.
    pub position: Vec3,
    /// Downward tilt of the optical axis, rad.
    pub tilt: f32,
    /// Focal lengths relative to the width and the height of the image.
    pub focal: Vec2,
}

/// Lengths in m, x forward, y left, z up, at zero joint angles.
///
/// Points of paired parts are given for the left side; the right side is the mirror image (y negated). The *robot
/// frame* has its origin midway between the hip joints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dimensions {
    /// Robot frame to the hip joint.
    pub hip: Vec3,
    /// Hip to knee, straight down.
    pub thigh: f32,
    /// Knee to ankle, straight down.
    pub tibia: f32,
    /// Height of the ankle's axes over the sole.
    pub foot_height: f32,
    /// Robot frame to the axes of head yaw and head pitch.
    pub neck: Vec3,
    /// Robot frame to shoulder.
    pub shoulder: Vec3,
    /// Shoulder to elbow.
    pub upper_arm: Vec3,
    /// Elbow to wrist.
    pub lower_arm: Vec3,
    /// Wrist to the middle of the hand.
    pub hand: Vec3,
    /// Robot frame to the manufacturer's torso frame.
    pub torso: Vec3,
    /// Robot frame to the inertial measurement unit.
    pub inertial_unit: Vec3,
    /// Camera that looks to the horizon.
    pub top_camera: CameraMount,
    /// Camera that looks to the feet.
    pub bottom_camera: CameraMount,
    /// Height of the whole robot's centre of mass over the hips in stand.
    pub mass_over_hips: f32,
    /// Edge of the left sole, counter-clockwise and convex, in the sole's frame (origin under the ankle).
    pub sole_outline: &'static [Vec2],
    /// Pressure sensors of the left sole in the sole's frame: front left, front right, rear left, rear right.
    pub left_pressure: [Vec2; 4],
    /// Pressure sensors of the right sole, in the same order.
    pub right_pressure: [Vec2; 4],
}

impl Dimensions {
    /// Mount of a camera.
    #[must_use]
    pub const fn camera(&self, camera: CameraId) -> CameraMount {
        match camera {
            CameraId::Top => self.top_camera,
            CameraId::Bottom => self.bottom_camera,
        }
    }
}
