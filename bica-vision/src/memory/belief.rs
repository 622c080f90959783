//! Confidence in a remembered object.

use bica_motion::pose::Pose2;
use libm::{exp2f, fabsf};

use super::MemoryTuning;

/// Confidence below which an object is forgotten.
const FORGOTTEN: f32 = 0.02;

/// Confidence, 0 to 1, and time since the last sighting, s; both finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Belief {
    confidence: f32,
    age: f32,
    pub(super) tuning: MemoryTuning,
}

impl Belief {
    pub(super) const fn new(tuning: MemoryTuning) -> Self {
        Self { confidence: 0.0, age: 0.0, tuning }
    }

    pub(super) const fn forget(&mut self) {
        *self = Self::new(self.tuning);
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
        self.confidence *= self.tuning.miss_factor;
    }

    /// Applies motion and time, both finite.
    pub(super) fn advance(&mut self, motion: Pose2, seconds: f32) {
        let MemoryTuning { half_life, halving_distance, halving_turn, .. } = self.tuning;
        let by_time = if half_life > 0.0 { seconds / half_life } else { f32::INFINITY };
        let lives = by_time + motion.position.length() / halving_distance + fabsf(motion.heading) / halving_turn;
        self.confidence *= exp2f(-lives);
        self.age += seconds;
        if !(self.is_held() && self.age.is_finite()) {
            self.forget();
        }
    }
}
