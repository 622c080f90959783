//! Poses in the plane of the ground.

use core::ops::Mul;

use glam::Vec2;
use libm::sincosf;

/// A pose on the ground, or the motion between two poses: m and rad, x forward, y left, angles counter-clockwise.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pose2 {
    /// Position, m.
    pub position: Vec2,
    /// Heading, rad.
    pub heading: f32,
}

impl Pose2 {
    /// The origin, heading along x.
    pub const ORIGIN: Self = Self::new(0.0, 0.0, 0.0);

    /// A pose from x, y (m) and heading (rad).
    #[must_use]
    pub const fn new(x: f32, y: f32, heading: f32) -> Self {
        Self { position: Vec2::new(x, y), heading }
    }

    /// Maps a point from this pose's frame to the outer frame, in which the pose is given.
    #[must_use]
    pub fn place(&self, point: Vec2) -> Vec2 {
        self.position + rotate(point, self.heading)
    }

    /// Maps a point from the outer frame to this pose's frame. The inverse of [`place`](Self::place).
    #[must_use]
    pub fn locate(&self, point: Vec2) -> Vec2 {
        rotate(point - self.position, -self.heading)
    }

    /// Inverse pose: `a * a.inverse()` is the origin.
    #[must_use]
    pub fn inverse(&self) -> Self {
        Self { position: rotate(-self.position, -self.heading), heading: -self.heading }
    }
}

/// Composition: the right pose is given in the frame of the left one.
impl Mul for Pose2 {
    type Output = Self;

    #[expect(clippy::suspicious_arithmetic_impl, reason = "composition of poses adds their headings")]
    fn mul(self, inner: Self) -> Self {
        Self { position: self.place(inner.position), heading: wrap(self.heading + inner.heading) }
    }
}

/// Rotates a vector counter-clockwise by `angle` rad.
#[must_use]
pub fn rotate(v: Vec2, angle: f32) -> Vec2 {
    let (s, c) = sincosf(angle);
    Vec2::new(c * v.x - s * v.y, s * v.x + c * v.y)
}

/// Wraps an angle to −π..π, rad. The result for a non-finite angle is not finite.
#[must_use]
pub fn wrap(mut angle: f32) -> f32 {
    use core::f32::consts::{PI, TAU};
    // One pass is enough for angles of a few turns. The error of a pass grows with the angle, by 2⁻²³ of it.
    while libm::fabsf(angle) > PI {
        angle -= TAU * libm::roundf(angle / TAU);
    }
    angle
}
