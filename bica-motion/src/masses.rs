//! Masses of a NAO H25 V6's segments and where their centres are.
//!
//! Source: B-Human 2023 `robotDimensions.cfg`; HULKs 2025 `robot_masses.rs` has the same.

use glam::Vec3;

use crate::kinematics::Segment;

/// A segment's mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mass {
    /// kg.
    pub mass: f32,
    /// Centre of mass, m, in the segment's frame.
    pub centre: Vec3,
}

const fn grams(mass: f32, x: f32, y: f32, z: f32) -> Mass {
    Mass { mass: mass * 1e-3, centre: Vec3::new(x * 1e-3, y * 1e-3, z * 1e-3) }
}

/// The mass of a segment and its centre in the frame of the joint that moves it.
///
/// The right side is the mirror image of the left one.
#[must_use]
pub const fn mass(segment: Segment) -> Mass {
    let (left, side) = match segment {
        Segment::Torso => return grams(1049.60, -4.13, 0.0, 128.42),
        Segment::Neck => return grams(78.42, -0.01, 0.0, -27.42),
        Segment::Head => return grams(659.37, 1.09, 1.46, 57.19),
        Segment::Shoulder(side) => (grams(93.04, -1.65, -26.63, 0.14), side),
        Segment::Biceps(side) => (grams(157.77, 24.55, 5.63, 3.30), side),
        Segment::Elbow(side) => (grams(64.83, -27.44, 0.0, -0.14), side),
        Segment::Forearm(side) => (grams(77.61, 25.56, 2.81, 0.76), side),
        Segment::Hand(side) => (grams(185.33, 34.34, -0.88, 3.08), side),
        Segment::Pelvis(side) => (grams(69.81, -7.81, -11.14, 26.61), side),
        Segment::Hip(side) => (grams(140.53, -15.49, 0.29, -5.15), side),
        Segment::Thigh(side) => (grams(389.68, 1.38, 2.21, -53.73), side),
        Segment::Tibia(side) => (grams(301.42, 4.53, 2.25, -49.36), side),
        Segment::Ankle(side) => (grams(134.16, 0.45, 0.29, 6.85), side),
        Segment::Foot(side) => (grams(171.84, 25.42, 3.30, -32.39), side),
    };
    let centre = Vec3::new(left.centre.x, side.sign() * left.centre.y, left.centre.z);
    Mass { mass: left.mass, centre }
}

/// The whole robot, kg.
pub const TOTAL_MASS: f32 = {
    let mut total = 0.0;
    let mut i = 0;
    while i < Segment::ALL.len() {
        total += mass(Segment::ALL[i]).mass;
        i += 1;
    }
    total
};
