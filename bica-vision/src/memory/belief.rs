//! Confidence in a remembered object.

use bica_motion::pose::Pose2;
use libm::{exp2f, fabsf};

/// Confidence below which an object is forgotten.
const FORGOTTEN: f32 = 0.02;
/// Walked distance that halves the confidence, m; odometry drifts by about a tenth.
const HALVING_WAY: f32 = 3.0;
/// Turn that halves the confidence, rad.
const HALVING_TURN: f32 = 6.0;
/// Factor on the confidence after an image that should show the object and does not. One image may be blurred, a third
/// of a second of images is not.
const MISSED: f32 = 0.75;

/// Confidence, 0 to 1, and time since the last sighting, s; both finite.
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

    /// Whether a sighting with this confidence is used.
    pub(super) fn counts(confidence: f32) -> bool {
        confidence >= FORGOTTEN
    }

    /// Processes a sighting of the same object (`again`) or of another one.
    pub(super) fn see(&mut self, confidence: f32, again: bool) {
        let before = if again { self.confidence } else { 0.0 };
        self.confidence = confidence.clamp(0.0, 1.0).max(before);
        self.age = 0.0;
    }

    pub(super) fn miss(&mut self) {
        self.confidence *= MISSED;
    }

    /// Applies motion and time, both finite.
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
