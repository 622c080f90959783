//! Circles through edge points, some of which are wrong.
//!
//! Circles through triples of points vote; the winner is fitted to those who agree by least squares of the distances
//! (Gauss–Newton). Cost: up to n² + 10 n distances, 2 µs for 32 points.

use glam::{Mat3, Vec2, Vec3};

/// A circle in the image, pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    /// Its centre.
    pub centre: Vec2,
    /// Its radius.
    pub radius: f32,
}

impl Circle {
    /// The circle through three points; none if they are on a line.
    #[must_use]
    pub fn through(a: Vec2, b: Vec2, c: Vec2) -> Option<Self> {
        let (ab, ac) = (b - a, c - a);
        let cross = 2.0 * ab.perp_dot(ac);
        let (b2, c2) = (ab.length_squared(), ac.length_squared());
        let offset = Vec2::new(ac.y * b2 - ab.y * c2, ab.x * c2 - ac.x * b2) / cross;
        let circle = Self { centre: a + offset, radius: offset.length() };
        (circle.centre.is_finite() && circle.radius.is_finite()).then_some(circle)
    }

    /// How far a point is from the line, pixels; negative inside.
    #[must_use]
    pub fn distance(&self, point: Vec2) -> f32 {
        (point - self.centre).length() - self.radius
    }

    /// How many points are within `tolerance` of the line.
    #[must_use]
    pub fn support(&self, points: &[Vec2], tolerance: f32) -> usize {
        let (low, high) = ((self.radius - tolerance).max(0.0), self.radius + tolerance);
        let squares = low * low..=high * high;
        points.iter().filter(|point| squares.contains(&point.distance_squared(self.centre))).count()
    }

    /// The circle that most points are close to; a point within `tolerance(radius)` pixels is close. Points that
    /// follow each other around the circle make the best triples. None for fewer than three points, or on a line.
    #[must_use]
    pub fn fit(points: &[Vec2], tolerance: impl Fn(f32) -> f32) -> Option<Self> {
        let n = points.len();
        let triple = |k: usize| Self::through(points[k], points[(k + n / 3) % n], points[(k + 2 * n / 3) % n]);
        let vote = |circle: &Self| circle.support(points, tolerance(circle.radius));
        let best = (0..n).filter(|_| n >= 3).filter_map(triple).max_by_key(vote)?;
        let refined = best.refine(points, &tolerance).refine(points, &tolerance);
        Some(if vote(&refined) >= vote(&best) { refined } else { best })
    }

    /// One Gauss–Newton step on the distances of the close points. Stays if they don't decide.
    fn refine(self, points: &[Vec2], tolerance: &impl Fn(f32) -> f32) -> Self {
        let limit = 1.5 * tolerance(self.radius);
        let (mut normal, mut right) = (Mat3::ZERO, Vec3::ZERO);
        for point in points {
            let distance = self.distance(*point);
            if distance.abs() <= limit {
                let outward = (*point - self.centre).normalize_or_zero().extend(1.0);
                normal += Mat3::from_cols(outward * outward.x, outward * outward.y, outward);
                right += outward * distance;
            }
        }
        if normal.determinant() < 1e-3 {
            return self;
        }
        let step = normal.inverse() * right;
        let next = Self { centre: self.centre + step.truncate(), radius: self.radius + step.z };
        if next.centre.is_finite() && next.radius > 0.0 { next } else { self }
    }
}
