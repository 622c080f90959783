//! Memory of several objects of one kind, such as other robots.

use bica_motion::pose::Pose2;
use glam::Vec2;

use super::position_estimate::GATE;
use super::{Memory, MemoryTuning, PositionEstimate};
use crate::uncertainty::Covariance;

/// Memory of up to `N` indistinguishable objects. Of more, the one with the lowest confidence is forgotten.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MultiTargetMemory<const N: usize> {
    memories: [Memory; N],
}

impl<const N: usize> MultiTargetMemory<N> {
    /// Creates an empty memory; `half_life` as in [`Memory::new`].
    #[must_use]
    pub const fn new(half_life: f32) -> Self {
        Self { memories: [Memory::new(half_life); N] }
    }

    /// Sets the rates and errors to use from now on.
    pub fn set_tuning(&mut self, tuning: &MemoryTuning) {
        for memory in &mut self.memories {
            memory.set_tuning(tuning);
        }
    }

    /// Estimates of all objects, in no order.
    pub fn places(&self) -> impl Iterator<Item = PositionEstimate> + '_ {
        self.memories.iter().filter_map(Memory::estimate)
    }

    /// Processes a sighting as [`Memory::see`] does: of the nearest object by Mahalanobis distance, or of a new one.
    pub fn see(&mut self, position: Vec2, covariance: &Covariance, confidence: f32) {
        let distance = |memory: &Memory| memory.distance(position, covariance).unwrap_or(f32::INFINITY);
        let nearest = self.memories.iter_mut().min_by(|a, b| distance(a).total_cmp(&distance(b)));
        let same = nearest.filter(|memory| distance(memory) <= GATE);
        if let Some(memory) = same {
            return memory.see(position, covariance, confidence);
        }
        let least = self.memories.iter_mut().min_by(|a, b| a.confidence().total_cmp(&b.confidence()));
        if let Some(memory) = least.filter(|memory| memory.confidence() < confidence) {
            memory.see(position, covariance, confidence);
        }
    }

    /// Reduces the confidence of each object that was not seen in this image and should be visible according to
    /// `shows`. Call it after the image's sightings and before the next [`advance`](Self::advance).
    pub fn miss(&mut self, shows: impl Fn(&PositionEstimate) -> bool) {
        for memory in &mut self.memories {
            let unseen = memory.age().is_some_and(|age| age > 0.0);
            if unseen && memory.estimate().is_some_and(|place| shows(&place)) {
                memory.miss();
            }
        }
    }

    /// Applies motion and time as [`Memory::advance`] does.
    pub fn advance(&mut self, motion: Pose2, seconds: f32) {
        for memory in &mut self.memories {
            memory.advance(motion, seconds);
        }
    }
}
