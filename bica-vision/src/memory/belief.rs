//! How much a remembered thing is believed.

use bica_motion::pose::Pose2;
use libm::{exp2f, fabsf};

/// Below this confidence a thing is forgotten.
const FORGOTTEN: f32 = 0.02;
/// The way that halves the confidence in a place, m: odometry is off by a tenth or so.
const HALVING_WAY: f32 = 3.0;
/// The turn that halves it, rad.
const HALVING_TURN: f32 = 6.0;
/// What is left of the confidence after an image that should have shown the thing and did not: one image may be
/// blurred, a third of a second of them is not.
const MISSED: f32 = 0.75;

/// Confidence, 0 to 1, and the seconds since the last sighting. Always numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Belief {
    confidence: f32,
    age: f32,
    half_life: f32,
}

impl Belief {
    pub(super) const fn new(half_life: f32) -> Self {
        Self { confidence: 0.0, age: 0.0, half_life }
    }

    pub(super) const fn forget(&mut self) {
        *self = Self::new(self.half_life);
    }

    pub(super) fn is_held(&self) -> bool {
        self.confidence >= FORGOTTEN
    }

    pub(super) const fn confidence(&self) -> f32 {
        self.confidence
    }

    pub(super) const fn age(&self) -> f32 {
        self.age
    }

    /// Whether a sighting with this confidence says anything.
    pub(super) fn counts(confidence: f32) -> bool {
        confidence >= FORGOTTEN
    }

    /// Seen again, or something else seen instead.
    pub(super) fn see(&mut self, confidence: f32, again: bool) {
        let before = if again { self.confidence } else { 0.0 };
        self.confidence = confidence.clamp(0.0, 1.0).max(before);
        self.age = 0.0;
    }

    pub(super) fn miss(&mut self) {
        self.confidence *= MISSED;
    }

    /// Time goes by and the robot moves; both finite.
    pub(super) fn advance(&mut self, motion: Pose2, seconds: f32) {
        let by_time = if self.half_life > 0.0 { seconds / self.half_life } else { f32::INFINITY };
        let lives = by_time + motion.position.length() / HALVING_WAY + fabsf(motion.heading) / HALVING_TURN;
        self.confidence *= exp2f(-lives);
        self.age += seconds;
        if !(self.is_held() && self.age.is_finite()) {
            self.forget();
        }
    }
}
