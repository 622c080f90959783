//! Lengths of a NAO H25 (V4, V5 and V6 share them), m and rad, x forward, y left, z up.
//!
//! Sources: B-Human 2023 `robotDimensions.cfg`, HULKs 2025 `robot_dimensions.rs`, rUNSWift 2019 `bodyV6.hpp`, which
//! agree. Points of paired parts are given for the left side; the right one is the mirror image (y negated).

use glam::{Vec2, Vec3};

/// Hip joint, from the middle between both.
pub const HIP: Vec3 = Vec3::new(0.0, 0.05, 0.0);
/// Hip to knee, straight down.
pub const THIGH: f32 = 0.100;
/// Knee to ankle, straight down.
pub const TIBIA: f32 = 0.1029;
/// Ankle axes to the sole, straight down.
pub const FOOT_HEIGHT: f32 = 0.045_19;
/// Hips over the ground with straight legs: the most there can be.
pub const LEG_LENGTH: f32 = THIGH + TIBIA + FOOT_HEIGHT;
/// Robot frame to the head's yaw and pitch axes.
pub const NECK: Vec3 = Vec3::new(0.0, 0.0, 0.2115);
/// Robot frame to shoulder.
pub const SHOULDER: Vec3 = Vec3::new(0.0, 0.098, 0.185);
/// Shoulder to elbow.
pub const UPPER_ARM: Vec3 = Vec3::new(0.105, 0.015, 0.0);
/// Elbow to wrist.
pub const LOWER_ARM: Vec3 = Vec3::new(0.055_95, 0.0, 0.0);
/// Wrist to the middle of the hand.
pub const HAND: Vec3 = Vec3::new(0.057_75, 0.0, 0.012_31);
/// Robot frame to Aldebaran's torso frame.
pub const TORSO: Vec3 = Vec3::new(0.0, 0.0, 0.085);
/// Robot frame to the inertial unit.
pub const INERTIAL_UNIT: Vec3 = Vec3::new(-0.008, 0.006_06, 0.112);

/// Neck to the optical centre of the top camera (V4 to V6).
pub const TOP_CAMERA: Vec3 = Vec3::new(0.058_71, 0.0, 0.063_64);
/// How far the top camera looks down, rad (1.2°).
pub const TOP_CAMERA_TILT: f32 = 1.2_f32.to_radians();
/// Neck to the optical centre of the bottom camera (V4 to V6).
pub const BOTTOM_CAMERA: Vec3 = Vec3::new(0.050_71, 0.0, 0.017_74);
/// How far the bottom camera looks down, rad (39.7°).
pub const BOTTOM_CAMERA_TILT: f32 = 39.7_f32.to_radians();

/// The left sole's edge, counter-clockwise, m in the sole's frame (under the ankle); convex. Mirror y for the right.
///
/// It fills the extents that HULKs 2025 gives (x −54.7…+100.1 mm, y −38.8…+51.7 mm); how the corners round is our
/// estimate from photographs: both long edges are straight from x −35 to +70 mm.
pub const SOLE_OUTLINE: [Vec2; 13] = [
    Vec2::new(0.0700, -0.0388),
    Vec2::new(0.0900, -0.0300),
    Vec2::new(0.0985, -0.0150),
    Vec2::new(0.1001, 0.0050),
    Vec2::new(0.0985, 0.0250),
    Vec2::new(0.0900, 0.0410),
    Vec2::new(0.0700, 0.0517),
    Vec2::new(-0.0350, 0.0517),
    Vec2::new(-0.0500, 0.0410),
    Vec2::new(-0.0547, 0.0250),
    Vec2::new(-0.0547, -0.0150),
    Vec2::new(-0.0500, -0.0300),
    Vec2::new(-0.0350, -0.0388),
];

/// The four pressure sensors of the left sole: front left, front right, rear left, rear right; m in the sole's frame.
/// Not quite a mirror image of the right one's. Source: B-Human 2023.
pub const LEFT_PRESSURE: [Vec2; 4] = [
    Vec2::new(0.070_25, 0.0299),
    Vec2::new(0.070_25, -0.0231),
    Vec2::new(-0.030_25, 0.0299),
    Vec2::new(-0.029_65, -0.0191),
];

/// The four pressure sensors of the right sole, ordered and given as [`LEFT_PRESSURE`].
pub const RIGHT_PRESSURE: [Vec2; 4] = [
    Vec2::new(0.070_25, 0.0231),
    Vec2::new(0.070_25, -0.0299),
    Vec2::new(-0.029_65, 0.0191),
    Vec2::new(-0.030_25, -0.0299),
];
