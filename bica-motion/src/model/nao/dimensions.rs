//! Lengths.
//!
//! Sources: B-Human 2023 `robotDimensions.cfg`, HULKs 2025 `robot_dimensions.rs`, rUNSWift 2019 `bodyV6.hpp`, which agree.

use glam::{Vec2, Vec3};

use crate::model::{CameraMount, Dimensions};

/// Lengths of the H25; V4, V5 and V6 share them.
pub(super) const DIMENSIONS: Dimensions = Dimensions {
    hip: Vec3::new(0.0, 0.05, 0.0),
    thigh: 0.100,
    tibia: 0.1029,
    foot_height: 0.045_19,
    neck: Vec3::new(0.0, 0.0, 0.2115),
    shoulder: Vec3::new(0.0, 0.098, 0.185),
    upper_arm: Vec3::new(0.105, 0.015, 0.0),
    lower_arm: Vec3::new(0.055_95, 0.0, 0.0),
    hand: Vec3::new(0.057_75, 0.0, 0.012_31),
    torso: Vec3::new(0.0, 0.0, 0.085),
    inertial_unit: Vec3::new(-0.008, 0.006_06, 0.112),
    top_camera: CameraMount { position: Vec3::new(0.058_71, 0.0, 0.063_64), tilt: 1.2_f32.to_radians(), focal: FOCAL },
    bottom_camera: CameraMount {
        position: Vec3::new(0.050_71, 0.0, 0.017_74),
        tilt: 39.7_f32.to_radians(),
        focal: FOCAL,
    },
    mass_over_hips: 0.035,
    sole_outline: &SOLE_OUTLINE,
    left_pressure: LEFT_PRESSURE,
    right_pressure: RIGHT_PRESSURE,
};

/// Focal lengths of both cameras: 618.66 and 617.16 pixels at 640 × 480. Source: B-Human 2023 and HULKs 2025.
const FOCAL: Vec2 = Vec2::new(618.66 / 640.0, 617.16 / 480.0);

/// Edge of the left sole.
///
/// It fills the extents of HULKs 2025 (x −54.7…+100.1 mm, y −38.8…+51.7 mm). The rounding of the corners is our estimate
/// from photographs; both long edges are straight from x −35 to +70 mm.
const SOLE_OUTLINE: [Vec2; 13] = [
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

/// Pressure sensors of the left sole. Source: B-Human 2023. They are not quite a mirror image of the right ones.
const LEFT_PRESSURE: [Vec2; 4] = [
    Vec2::new(0.070_25, 0.0299),
    Vec2::new(0.070_25, -0.0231),
    Vec2::new(-0.030_25, 0.0299),
    Vec2::new(-0.029_65, -0.0191),
];

/// Pressure sensors of the right sole. Source: B-Human 2023.
const RIGHT_PRESSURE: [Vec2; 4] = [
    Vec2::new(0.070_25, 0.0231),
    Vec2::new(0.070_25, -0.0299),
    Vec2::new(-0.029_65, 0.0191),
    Vec2::new(-0.030_25, -0.0299),
];
