//! Calibration of the odometry.

use glam::Vec2;

/// Scales of the odometry's sources: soles slip, and joints give way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Calibration {
    /// Odometry scale: true displacement divided by displacement from measured joint angles, for x and y.
    pub measured_scale: Vec2,
    /// Odometry scale: true displacement divided by displacement from commanded joint angles, for x and y.
    pub commanded_scale: Vec2,
    /// True turn divided by the turn that the gyroscope measured.
    pub gyro_scale: f32,
    /// Turn rate by which the torso of a walking robot may differ from its legs, beyond their slip in turns, rad/s: a gyroscope that
    /// measures more has an offset. Infinite for soles whose slip says nothing about the gyroscope: it is then checked in stands alone.
    pub max_turn_difference: f32,
}

impl Calibration {
    /// All scales 1: no slip. In games of the built-in world no difference above 0.03 rad/s lasts.
    pub const EXACT: Self =
        Self { measured_scale: Vec2::ONE, commanded_scale: Vec2::ONE, gyro_scale: 1.0, max_turn_difference: 0.03 };
}
