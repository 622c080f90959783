//! Simulated person who raises the left arm.

use glam::Vec3;

use super::{POINTS, Point, Skeleton};

/// Geometry of the raised arm.
#[derive(Clone, Copy, Debug)]
pub struct Person {
    /// Highest angle of the arm, degrees.
    pub peak: f32,
    /// Largest lean of the trunk, degrees.
    pub lean: f32,
    /// Angle of the plane of the arm in front of the shoulders, degrees.
    pub plane: f32,
}

impl Person {
    /// A person who does not move.
    pub const STILL: Self = Self { peak: 0.0, lean: 0.0, plane: 0.0 };

    /// Skeleton, m, at a fraction of the rise, 0 (rest) to 1 (highest).
    #[must_use]
    pub fn at(&self, share: f32) -> Skeleton {
        let (sin, cos) = libm::sincosf((share * self.lean).to_radians());
        let (up, across) = (Vec3::new(sin, cos, 0.0), Vec3::new(-cos, sin, 0.0));
        let (ahead, aside) = libm::sincosf(self.plane.to_radians());
        let (sin, cos) = libm::sincosf((share * self.peak).to_radians());
        let arm = 0.3 * (sin * (aside * across + ahead * Vec3::Z) - cos * up);
        let mut skeleton = Skeleton { points: [[0.0; 3]; POINTS], confidence: [1.0; POINTS] };
        for (point, at) in [
            (Point::Head, 0.7 * up),
            (Point::Neck, 0.52 * up),
            (Point::Chest, 0.5 * up),
            (Point::LeftShoulder, 0.5 * up + 0.2 * across),
            (Point::RightShoulder, 0.5 * up - 0.2 * across),
            (Point::LeftElbow, 0.5 * up + 0.2 * across + arm),
            (Point::RightElbow, 0.2 * up - 0.2 * across),
            (Point::LeftHip, 0.1 * across),
            (Point::RightHip, -0.1 * across),
        ] {
            skeleton.points[point as usize] = at.to_array();
        }
        skeleton
    }
}
