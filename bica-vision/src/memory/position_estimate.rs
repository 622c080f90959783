//! Where something is, and how sure that is.

use bica_motion::pose::{Pose2, rotate};
use glam::Vec2;
use libm::{cosf, fabsf, logf, sinf};
use nalgebra::{Matrix2, Vector2};

use crate::uncertainty::{Covariance, round, square};

/// How far the way by odometry is off after 1 m, m; errors of steps know nothing of each other, so after n metres √n
/// times as far.
const WAY_ERROR: f32 = 0.08;
/// Likewise for a turn: after 1 rad, rad.
const TURN_ERROR: f32 = 0.05;
/// Sightings farther off than this many squared deviations are of something else: 1 of 1000 of the same is (χ² with two
/// degrees of freedom).
pub(super) const GATE: f32 = 13.8;
/// The part of sightings that are wild, as of a ball half hidden or at the edge of the image, and how many times as far off
/// they are: one of them makes no kick.
const WILD: (f32, f32) = (0.03, 4.0);
/// No sighting is better than this, m.
const SHARPEST: f32 = 0.001;
/// What is farther away or less sure is not remembered, m.
const FARTHEST: f32 = 1000.0;

/// A place on the ground, in the ground frame of the robot as it stands now: x forward, y left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PositionEstimate {
    /// The best estimate, m.
    pub position: Vec2,
    /// How far off it may be, m².
    pub covariance: Covariance,
}

impl PositionEstimate {
    /// As it was seen; none if that is no number, or the covariance none of a place.
    pub(super) fn seen(position: Vec2, covariance: &Covariance) -> Option<Self> {
        let place = Self { position, covariance: covariance + round(SHARPEST) };
        (place.is_sound() && place.covariance.determinant() > 0.0).then_some(place)
    }

    /// As seen after the robot's `motion`, which is known only so well.
    pub(super) fn advance(&mut self, motion: Pose2) {
        self.covariance = turned(motion, &self.covariance) + drift(motion, self.position);
        self.position = motion.locate(self.position);
    }

    /// Less sure than before, by a factor.
    pub(super) fn faded(&self, factor: f32) -> Self {
        Self { covariance: self.covariance * factor, ..*self }
    }

    /// With another error beside its own.
    pub(super) fn with(&self, error: &Covariance) -> Self {
        Self { covariance: self.covariance + error, ..*self }
    }

    /// How well a sighting fits.
    pub(super) fn fit(&self, seen: &Self) -> Option<Fit> {
        Fit::of(vector(seen.position - self.position), self.covariance + seen.covariance)
    }

    /// This place corrected by a sighting that fits so.
    pub(super) fn corrected(&self, fit: &Fit) -> Self {
        let gain = self.covariance * fit.inverse;
        let step = gain * fit.off;
        let covariance = self.covariance - gain * self.covariance;
        Self {
            position: self.position + Vec2::new(step.x, step.y),
            covariance: 0.5 * (covariance + covariance.transpose()),
        }
    }

    /// Two possible places as one; `share` of the other.
    pub(super) fn mixed(&self, other: &Self, share: f32) -> Self {
        let off = other.position - self.position;
        Self {
            position: self.position + share * off,
            covariance: self.covariance * (1.0 - share)
                + other.covariance * share
                + square(off) * (share * (1.0 - share)),
        }
    }

    /// Whether it is one of numbers, and not of huge ones.
    pub(super) fn is_sound(&self) -> bool {
        let near = |value: f32, most: f32| fabsf(value) <= most;
        near(self.position.length(), FARTHEST)
            && self.covariance.iter().all(|value| near(*value, FARTHEST * FARTHEST))
            && self.covariance.m11 >= 0.0
            && self.covariance.m22 >= 0.0
    }
}

/// A sighting against what was expected.
pub(super) struct Fit {
    /// From the expected place to the seen one.
    pub(super) off: Vector2<f32>,
    /// The inverse covariance of that.
    pub(super) inverse: Matrix2<f32>,
    /// How many squared deviations that is.
    pub(super) distance: f32,
    /// The logarithm of how likely that is, but for a constant; wild sightings are a little likely.
    pub(super) likelihood: f32,
}

impl Fit {
    pub(super) fn of(off: Vector2<f32>, covariance: Covariance) -> Option<Self> {
        let determinant = covariance.determinant();
        let inverse = covariance.try_inverse()?;
        let distance = (off.transpose() * inverse * off).x;
        let size = logf(determinant);
        let (wild, wider) = WILD;
        let wild = logf(wild) - 0.5 * (distance / (wider * wider) + size) - 2.0 * logf(wider);
        let likelihood = wild.max(-0.5 * (distance + size));
        (determinant > 0.0 && likelihood.is_finite()).then_some(Self { off, inverse, distance, likelihood })
    }
}

pub(super) fn vector(point: Vec2) -> Vector2<f32> {
    Vector2::new(point.x, point.y)
}

/// The matrix that takes vectors to how they are seen after a motion.
pub(super) fn turn_of(motion: Pose2) -> Matrix2<f32> {
    let (sin, cos) = (sinf(motion.heading), cosf(motion.heading));
    Matrix2::new(cos, sin, -sin, cos)
}

/// A covariance as seen after a motion.
pub(super) fn turned(motion: Pose2, covariance: &Covariance) -> Covariance {
    let turn = turn_of(motion);
    turn * covariance * turn.transpose()
}

/// What a motion adds to the covariance of a place that was at `position` before it.
pub(super) fn drift(motion: Pose2, position: Vec2) -> Covariance {
    let way = round(WAY_ERROR) * motion.position.length();
    let aside = rotate(position - motion.position, -motion.heading).perp();
    way + square(TURN_ERROR * aside) * fabsf(motion.heading)
}
