//! Kalman filter of a rolling ball: position and velocity, with rolling friction.

use bica_motion::pose::{Pose2, rotate};
use glam::{Mat2, Mat4, Vec2, Vec4, Vec4Swizzles as _};

use super::BallMemoryTuning;
use super::position_estimate::{Fit, PositionEstimate, drift, turn_of};
use crate::uncertainty::{Covariance, largest, round, square};

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
    covariance: Mat4,
}

impl Rolling {
    /// Ball just kicked from a position, with unknown velocity.
    pub(super) fn kicked(place: &PositionEstimate, tuning: &BallMemoryTuning) -> Self {
        let covariance = blocks(place.covariance, Mat2::ZERO, round(tuning.kick_speed));
        Self { position: place.position, velocity: Vec2::ZERO, covariance }
    }

    pub(super) fn estimate(&self) -> PositionEstimate {
        PositionEstimate { position: self.position, covariance: self.of_position() }
    }

    /// Velocity, m/s.
    pub(super) const fn velocity(&self) -> Vec2 {
        self.velocity
    }

    pub(super) fn is_sound(&self) -> bool {
        let fast = PositionEstimate { position: self.velocity, covariance: self.of_velocity() };
        self.estimate().is_sound() && fast.is_sound() && self.covariance.is_finite()
    }

    /// Whether it is slower than `speed` with a standard deviation below `deviation`, m/s.
    pub(super) fn is_slow(&self, speed: f32, deviation: f32) -> bool {
        self.velocity.length() < speed && largest(&self.of_velocity()) < deviation
    }

    fn of_position(&self) -> Covariance {
        Covariance::from_cols(self.covariance.x_axis.xy(), self.covariance.y_axis.xy())
    }

    fn of_velocity(&self) -> Covariance {
        Covariance::from_cols(self.covariance.z_axis.zw(), self.covariance.w_axis.zw())
    }

    /// Mixes in a ball kicked from a position, with weight `share`.
    pub(super) fn mix_in_kicked(&mut self, place: &PositionEstimate, share: f32, tuning: &BallMemoryTuning) {
        let other = Self::kicked(place, tuning);
        let (off, faster) = (other.position - self.position, other.velocity - self.velocity);
        let apart = Vec4::new(off.x, off.y, faster.x, faster.y);
        self.position += share * off;
        self.velocity += share * faster;
        self.covariance = self.covariance * (1.0 - share)
            + other.covariance * share
            + product(apart, apart) * (share * (1.0 - share));
    }

    /// Applies the robot's `motion`.
    pub(super) fn advance(&mut self, motion: Pose2, tuning: &BallMemoryTuning) {
        let added = drift(motion, self.position, &tuning.memory);
        let turn = turn_of(motion);
        let both = blocks(turn, Mat2::ZERO, turn);
        self.covariance = both * self.covariance * both.transpose() + blocks(added, Mat2::ZERO, Mat2::ZERO);
        self.position = motion.locate(self.position);
        self.velocity = rotate(self.velocity, -motion.heading);
    }

    /// Predicts the motion over some seconds with a deceleration, m/s².
    pub(super) fn roll(&mut self, seconds: f32, deceleration: f32) {
        let mut left = seconds;
        for _ in 0..STEPS {
            let step = left.min(STEP);
            self.roll_step(step, deceleration);
            left -= step;
            if left <= 0.0 {
                break;
            }
        }
    }

    fn roll_step(&mut self, seconds: f32, deceleration: f32) {
        let speed = self.velocity.length();
        let moving = seconds.min(speed / deceleration);
        let stops = speed <= deceleration * seconds;
        let ahead = self.velocity.normalize_or_zero();
        // Derivatives with respect to the velocity: ahead they persist, sideways they turn the path and shrink with the speed.
        let share = if stops { 1.0 } else { 1.0 - deceleration * moving / speed };
        let straight = square(ahead);
        let aside = Mat2::IDENTITY - straight;
        let (way, faster) = if stops {
            // The velocity is unknown: the ball may continue at any.
            (Mat2::from_diagonal(Vec2::splat(seconds)), Mat2::IDENTITY)
        } else {
            (straight * moving + aside * (0.5 * (1.0 + share) * moving), straight + aside * share)
        };
        let moves = blocks(Mat2::IDENTITY, way, faster);
        let bumps = blocks(Mat2::ZERO, Mat2::ZERO, round(BUMPS) * seconds);
        self.covariance = moves * self.covariance * moves.transpose() + bumps;
        self.position += ahead * (speed - 0.5 * deceleration * moving) * moving;
        self.velocity = if stops { Vec2::ZERO } else { self.velocity * share };
    }

    /// Fit of a sighting.
    pub(super) fn fit(&self, seen: &PositionEstimate) -> Option<Fit> {
        self.estimate().fit(seen)
    }

    /// Updates position and velocity with the fit of a sighting.
    pub(super) fn correct(&mut self, fit: &Fit) {
        // The covariance of the state with the measured position, and the Kalman gain, both by columns.
        let [x, y] = [self.covariance.row(0), self.covariance.row(1)];
        let [by_x, by_y] = [fit.inverse.x_axis, fit.inverse.y_axis].map(|column| x * column.x + y * column.y);
        let step = by_x * fit.off.x + by_y * fit.off.y;
        self.position += step.xy();
        self.velocity += step.zw();
        let covariance = self.covariance - (product(by_x, x) + product(by_y, y));
        self.covariance = 0.5 * (covariance + covariance.transpose());
    }
}

/// Matrix of the blocks above left, above right and below right; zero below left.
fn blocks(above: Mat2, aside: Mat2, below: Mat2) -> Mat4 {
    let left = [above.x_axis, above.y_axis].map(|column| Vec4::from((column, Vec2::ZERO)));
    let right = |above: Vec2, below: Vec2| Vec4::from((above, below));
    Mat4::from_cols(left[0], left[1], right(aside.x_axis, below.x_axis), right(aside.y_axis, below.y_axis))
}

/// Product of a column and a row.
fn product(column: Vec4, row: Vec4) -> Mat4 {
    Mat4::from_cols(column * row.x, column * row.y, column * row.z, column * row.w)
}
