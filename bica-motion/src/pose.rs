//! Poses and motions in the plane of the ground.

use core::ops::Mul;

use glam::Vec2;
use libm::{cosf, sinf};

/// A pose on the ground, or the motion from one pose to another: metres and radians, x forward, y left, angles
/// counter-clockwise.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pose2 {
    /// Where, m.
    pub position: Vec2,
    /// Heading, rad.
    pub heading: f32,
}

impl Pose2 {
    /// The origin, heading along x.
    pub const ORIGIN: Self = Self::new(0.0, 0.0, 0.0);

    /// A pose from its coordinates.
    #[must_use]
    pub const fn new(x: f32, y: f32, heading: f32) -> Self {
        Self { position: Vec2::new(x, y), heading }
    }

    /// A point given in this pose's own frame, in the frame that the pose is given in.
    #[must_use]
    pub fn place(&self, point: Vec2) -> Vec2 {
        self.position + rotate(point, self.heading)
    }

    /// A point of the outer frame, as seen from this pose. Undoes [`place`](Self::place).
    #[must_use]
    pub fn locate(&self, point: Vec2) -> Vec2 {
        rotate(point - self.position, -self.heading)
    }

    /// The pose that undoes this one: `a * a.inverse()` is the origin.
    #[must_use]
    pub fn inverse(&self) -> Self {
        Self { position: rotate(-self.position, -self.heading), heading: -self.heading }
    }
}

/// First the left pose, then the right one seen from there.
impl Mul for Pose2 {
    type Output = Self;

    #[expect(clippy::suspicious_arithmetic_impl, reason = "chaining poses adds their headings")]
    fn mul(self, inner: Self) -> Self {
        Self { position: self.place(inner.position), heading: wrap(self.heading + inner.heading) }
    }
}

/// A vector turned counter-clockwise by `angle` rad.
#[must_use]
pub fn rotate(v: Vec2, angle: f32) -> Vec2 {
    let (s, c) = (sinf(angle), cosf(angle));
    Vec2::new(c * v.x - s * v.y, s * v.x + c * v.y)
}

/// An angle brought into −π..π, rad. Not finite in, not finite out.
#[must_use]
pub fn wrap(angle: f32) -> f32 {
    use core::f32::consts::{PI, TAU};
    if (-PI..=PI).contains(&angle) { angle } else { angle - TAU * libm::roundf(angle / TAU) }
}
