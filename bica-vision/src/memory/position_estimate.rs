//! Position with covariance.

use bica_motion::pose::{Pose2, rotate};
use glam::{Mat2, Vec2};
use libm::{fabsf, logf, sincosf};

use super::MemoryTuning;
use crate::uncertainty::{Covariance, inverse, round, square};

/// Gate: maximum squared Mahalanobis distance of a sighting of the same object; 99.9 % quantile of χ² with two degrees of freedom.
pub(super) const GATE: f32 = 13.8;
/// Share of outliers among sightings, such as a ball half hidden or at the image edge.
const OUTLIERS: f32 = 0.03;
/// Standard deviation of outliers, relative to other sightings. A single outlier must not count as a kick.
const OUTLIER_SPREAD: f32 = 4.0;
/// Minimum standard deviation of a sighting, m.
const SHARPEST: f32 = 0.001;
/// Maximum distance and standard deviation of an estimate, m.
const FARTHEST: f32 = 1000.0;

/// Position on the ground with covariance, in the robot's present ground frame: x forward, y left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PositionEstimate {
    /// Position, m.
    pub position: Vec2,
    /// Covariance, m².
    pub covariance: Covariance,
}

impl PositionEstimate {
    /// Estimate from a sighting; `None` if it is not finite or the covariance is not positive definite.
    pub(super) fn seen(position: Vec2, covariance: &Covariance) -> Option<Self> {
        let place = Self { position, covariance: covariance + round(SHARPEST) };
        (place.is_sound() && place.covariance.determinant() > 0.0).then_some(place)
    }

    /// Applies the robot's `motion` with the error of odometry.
    pub(super) fn advance(&mut self, motion: Pose2, tuning: &MemoryTuning) {
        self.covariance = turned(motion, &self.covariance) + drift(motion, self.position, tuning);
        self.position = motion.locate(self.position);
    }

    /// Same position with the covariance scaled by a factor.
    pub(super) fn faded(&self, factor: f32) -> Self {
        Self { covariance: self.covariance * factor, ..*self }
    }

    /// Same position with an added independent error.
    pub(super) fn with(&self, error: &Covariance) -> Self {
        Self { covariance: self.covariance + error, ..*self }
    }

    /// Fit of a sighting.
    pub(super) fn fit(&self, seen: &Self) -> Option<Fit> {
        Fit::of(seen.position - self.position, self.covariance + seen.covariance)
    }

    /// Kalman update with the fit of a sighting.
    pub(super) fn corrected(&self, fit: &Fit) -> Self {
        let gain = self.covariance * fit.inverse;
        let covariance = self.covariance - gain * self.covariance;
        Self { position: self.position + gain * fit.off, covariance: 0.5 * (covariance + covariance.transpose()) }
    }

    /// Mixture of two estimates; `share` is the weight of the other.
    pub(super) fn mixed(&self, other: &Self, share: f32) -> Self {
        let off = other.position - self.position;
        Self {
            position: self.position + share * off,
            covariance: self.covariance * (1.0 - share)
                + other.covariance * share
                + square(off) * (share * (1.0 - share)),
        }
    }

    /// Whether all values are finite and within range.
    pub(super) fn is_sound(&self) -> bool {
        let near = |value: f32, most: f32| fabsf(value) <= most;
        near(self.position.length(), FARTHEST)
            && self.covariance.to_cols_array().iter().all(|value| near(*value, FARTHEST * FARTHEST))
            && self.covariance.x_axis.x >= 0.0
            && self.covariance.y_axis.y >= 0.0
    }
}

/// Innovation of a sighting.
pub(super) struct Fit {
    /// Innovation: seen minus expected position, m.
    pub(super) off: Vec2,
    /// Inverse covariance of the innovation.
    pub(super) inverse: Mat2,
    /// Squared Mahalanobis distance.
    pub(super) distance: f32,
    /// Log-likelihood up to a constant, with a heavy tail for outliers.
    pub(super) likelihood: f32,
}

impl Fit {
    pub(super) fn of(off: Vec2, covariance: Covariance) -> Option<Self> {
        let determinant = covariance.determinant();
        let inverse = inverse(&covariance)?;
        let distance = (inverse.transpose() * off).dot(off);
        let size = logf(determinant);
        let (outliers, wider) = (OUTLIERS, OUTLIER_SPREAD);
        let outlier = logf(outliers) - 0.5 * (distance / (wider * wider) + size) - 2.0 * logf(wider);
        let likelihood = outlier.max(-0.5 * (distance + size));
        (determinant > 0.0 && likelihood.is_finite()).then_some(Self { off, inverse, distance, likelihood })
    }
}

/// Matrix that rotates vectors into the frame after a motion.
pub(super) fn turn_of(motion: Pose2) -> Mat2 {
    let (sin, cos) = sincosf(motion.heading);
    Mat2::from_cols(Vec2::new(cos, -sin), Vec2::new(sin, cos))
}

/// Covariance in the frame after a motion.
pub(super) fn turned(motion: Pose2, covariance: &Covariance) -> Covariance {
    let turn = turn_of(motion);
    turn * covariance * turn.transpose()
}

/// Covariance that odometry adds to an object at `position` before the motion.
pub(super) fn drift(motion: Pose2, position: Vec2, tuning: &MemoryTuning) -> Covariance {
    let way = round(tuning.distance_error) * motion.position.length();
    let aside = rotate(position - motion.position, -motion.heading).perp();
    way + square(tuning.turn_error * aside) * fabsf(motion.heading)
}
