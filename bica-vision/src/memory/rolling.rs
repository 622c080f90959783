//! Kalman filter of a rolling ball: position and velocity, with rolling friction.

use bica_motion::pose::{Pose2, rotate};
use glam::Vec2;
use nalgebra::{Matrix2, Matrix2x4, Matrix4, Vector4};

use super::position_estimate::{Fit, PositionEstimate, drift, turn_of};
use crate::uncertainty::{Covariance, largest, round, square};

/// Deceleration of a ball on carpet, m/s². Source: B-Human 2023 `ballSpecification.cfg`.
const BRAKING: f32 = 0.3;
/// Standard deviation of the velocity of a ball just kicked, in each direction, m/s.
const KICKED: f32 = 1.0;
/// Process noise of the velocity from bumps and varying friction, m/s after 1 s.
const BUMPS: f32 = 0.2;
/// Maximum duration of a prediction step, s, within which the motion is linearized.
const STEP: f32 = 0.1;
/// Maximum number of prediction steps.
const STEPS: usize = 50;

/// Kalman filter of position and velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rolling {
    position: Vec2,
    velocity: Vec2,
    /// Covariance of (x, y, vx, vy).
    covariance: Matrix4<f32>,
}

impl Rolling {
    /// Ball just kicked from a position, with unknown velocity.
    pub(super) fn kicked(place: &PositionEstimate) -> Self {
        let mut covariance = Matrix4::zeros();
        covariance.fixed_view_mut::<2, 2>(0, 0).copy_from(&place.covariance);
        covariance.fixed_view_mut::<2, 2>(2, 2).copy_from(&round(KICKED));
        Self { position: place.position, velocity: Vec2::ZERO, covariance }
    }

    pub(super) fn estimate(&self) -> PositionEstimate {
        PositionEstimate { position: self.position, covariance: self.block(0) }
    }

    /// Velocity, m/s.
    pub(super) const fn velocity(&self) -> Vec2 {
        self.velocity
    }

    pub(super) fn is_sound(&self) -> bool {
        let fast = PositionEstimate { position: self.velocity, covariance: self.block(2) };
        self.estimate().is_sound() && fast.is_sound() && self.covariance.iter().all(|value| value.is_finite())
    }

    /// Whether it is slower than `speed` with a standard deviation below `deviation`, m/s.
    pub(super) fn is_slow(&self, speed: f32, deviation: f32) -> bool {
        self.velocity.length() < speed && largest(&self.block(2)) < deviation
    }

    fn block(&self, at: usize) -> Covariance {
        self.covariance.fixed_view::<2, 2>(at, at).into()
    }

    /// Mixes in a ball kicked from a position, with weight `share`.
    pub(super) fn mix_in_kicked(&mut self, place: &PositionEstimate, share: f32) {
        let other = Self::kicked(place);
        let (off, faster) = (other.position - self.position, other.velocity - self.velocity);
        let apart = Vector4::new(off.x, off.y, faster.x, faster.y);
        self.position += share * off;
        self.velocity += share * faster;
        self.covariance = self.covariance * (1.0 - share)
            + other.covariance * share
            + apart * apart.transpose() * (share * (1.0 - share));
    }

    /// Applies the robot's `motion`.
    pub(super) fn advance(&mut self, motion: Pose2) {
        let added = drift(motion, self.position);
        let turn = turn_of(motion);
        let mut both = Matrix4::zeros();
        both.fixed_view_mut::<2, 2>(0, 0).copy_from(&turn);
        both.fixed_view_mut::<2, 2>(2, 2).copy_from(&turn);
        self.covariance = both * self.covariance * both.transpose();
        self.add(0, &added);
        self.position = motion.locate(self.position);
        self.velocity = rotate(self.velocity, -motion.heading);
    }

    fn add(&mut self, at: usize, covariance: &Covariance) {
        let mut block = self.covariance.fixed_view_mut::<2, 2>(at, at);
        block += covariance;
    }

    /// Predicts the motion over some seconds.
    pub(super) fn roll(&mut self, seconds: f32) {
        let mut left = seconds;
        for _ in 0..STEPS {
            let step = left.min(STEP);
            self.roll_step(step);
            left -= step;
            if left <= 0.0 {
                break;
            }
        }
    }

    fn roll_step(&mut self, seconds: f32) {
        let speed = self.velocity.length();
        let moving = seconds.min(speed / BRAKING);
        let stops = speed <= BRAKING * seconds;
        let ahead = self.velocity.normalize_or_zero();
        // Derivatives with respect to the velocity: ahead they persist, sideways they turn the path and shrink with the
        // speed.
        let share = if stops { 1.0 } else { 1.0 - BRAKING * moving / speed };
        let straight = square(ahead);
        let aside = Matrix2::identity() - straight;
        let (way, faster) = if stops {
            // The velocity is unknown: the ball may continue at any.
            (Matrix2::from_diagonal_element(seconds), Matrix2::identity())
        } else {
            (straight * moving + aside * (0.5 * (1.0 + share) * moving), straight + aside * share)
        };
        let mut moves = Matrix4::identity();
        moves.fixed_view_mut::<2, 2>(0, 2).copy_from(&way);
        moves.fixed_view_mut::<2, 2>(2, 2).copy_from(&faster);
        self.covariance = moves * self.covariance * moves.transpose();
        self.add(2, &(round(BUMPS) * seconds));
        self.position += ahead * (speed - 0.5 * BRAKING * moving) * moving;
        self.velocity = if stops { Vec2::ZERO } else { self.velocity * share };
    }

    /// Fit of a sighting.
    pub(super) fn fit(&self, seen: &PositionEstimate) -> Option<Fit> {
        self.estimate().fit(seen)
    }

    /// Updates position and velocity with the fit of a sighting.
    pub(super) fn correct(&mut self, fit: &Fit) {
        let above: Matrix2x4<f32> = self.covariance.fixed_rows::<2>(0).into();
        let gain = above.transpose() * fit.inverse;
        let step = gain * fit.off;
        self.position += Vec2::new(step.x, step.y);
        self.velocity += Vec2::new(step.z, step.w);
        let covariance = self.covariance - gain * above;
        self.covariance = 0.5 * (covariance + covariance.transpose());
    }
}
