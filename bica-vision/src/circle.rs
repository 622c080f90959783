//! Robust circle fit to edge points with outliers.
//!
//! Circles through triples of points are hypotheses, as in RANSAC but over a fixed set of triples. The hypothesis with
//! the most inliers is refined by least squares (Gauss–Newton) on its inliers, as far as that raises their agreement.
//! Cost: up to n² + 10 n distances, 2 µs for 32 points.

use glam::{Mat3, Vec2, Vec3};

/// Circle in the image, px.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    /// Centre.
    pub centre: Vec2,
    /// Radius.
    pub radius: f32,
}

impl Circle {
    /// Circle through three points; `None` if they are collinear.
    #[must_use]
    pub fn through(a: Vec2, b: Vec2, c: Vec2) -> Option<Self> {
        let (ab, ac) = (b - a, c - a);
        let cross = 2.0 * ab.perp_dot(ac);
        let (b2, c2) = (ab.length_squared(), ac.length_squared());
        let offset = Vec2::new(ac.y * b2 - ab.y * c2, ab.x * c2 - ac.x * b2) / cross;
        let circle = Self { centre: a + offset, radius: offset.length() };
        (circle.centre.is_finite() && circle.radius.is_finite()).then_some(circle)
    }

    /// Signed distance of a point from the circle, px; negative inside.
    #[must_use]
    pub fn distance(&self, point: Vec2) -> f32 {
        (point - self.centre).length() - self.radius
    }

    /// Number of points within `tolerance` of the circle.
    #[must_use]
    pub fn support(&self, points: &[Vec2], tolerance: f32) -> usize {
        let (low, high) = ((self.radius - tolerance).max(0.0), self.radius + tolerance);
        let squares = low * low..=high * high;
        points.iter().filter(|point| squares.contains(&point.distance_squared(self.centre))).count()
    }

    /// Fits a circle to the largest set of inliers. A point within `tolerance(radius)` px is an inlier. The points should be
    /// ordered around the circle, which makes the triples well conditioned. `None` for fewer than three points or collinear ones.
    #[must_use]
    pub fn fit(points: &[Vec2], tolerance: impl Fn(f32) -> f32) -> Option<Self> {
        let n = points.len();
        let triple = |k: usize| Self::through(points[k], points[(k + n / 3) % n], points[(k + 2 * n / 3) % n]);
        let vote = |circle: &Self| circle.support(points, tolerance(circle.radius));
        let best = (0..n).filter(|_| n >= 3).filter_map(triple).max_by_key(vote)?;
        let once = best.refine(points, &tolerance);
        let score = |circle: &Self| circle.agreement(points, tolerance(circle.radius));
        [best, once, once.refine(points, &tolerance)].into_iter().max_by(|a, b| score(a).total_cmp(&score(b)))
    }

    /// Sum of 1 - (distance / tolerance)² over the inliers, the score of MSAC: a straight edge of an occluding object
    /// near the circle adds inliers, but distant ones.
    fn agreement(&self, points: &[Vec2], tolerance: f32) -> f32 {
        let shares = points.iter().map(|point| self.distance(*point) / tolerance);
        shares.map(|share: f32| (1.0 - share * share).max(0.0)).sum()
    }

    /// One Gauss–Newton step on the inliers. Returns the same circle if they do not determine it.
    fn refine(self, points: &[Vec2], tolerance: &impl Fn(f32) -> f32) -> Self {
        let limit = tolerance(self.radius);
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
