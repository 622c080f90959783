//! Several things of a kind, such as other robots, which look all alike.

use bica_motion::pose::Pose2;
use glam::Vec2;

use super::position_estimate::GATE;
use super::{Memory, PositionEstimate};
use crate::uncertainty::Covariance;

/// Remembers up to `N` things of a kind; when there are more, the least believed is forgotten.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MultiTargetMemory<const N: usize> {
    memories: [Memory; N],
}

impl<const N: usize> MultiTargetMemory<N> {
    /// Nothing remembered yet; half-lives as in [`Memory::new`].
    #[must_use]
    pub const fn new(half_life: f32) -> Self {
        Self { memories: [Memory::new(half_life); N] }
    }

    /// The places, in no order.
    pub fn places(&self) -> impl Iterator<Item = PositionEstimate> + '_ {
        self.memories.iter().filter_map(Memory::estimate)
    }

    /// Takes in a sighting as [`Memory::see`]: of the nearest remembered thing, as deviations go, or of a new one.
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

    /// What was not seen in this image and should have been, by `shows` of its place, is believed a quarter less. After
    /// the image's sightings were taken in, and before time goes on.
    pub fn miss(&mut self, shows: impl Fn(&PositionEstimate) -> bool) {
        for memory in &mut self.memories {
            let unseen = memory.age().is_some_and(|age| age > 0.0);
            if unseen && memory.estimate().is_some_and(|place| shows(&place)) {
                memory.miss();
            }
        }
    }

    /// The robot moved and time went by: as [`Memory::advance`].
    pub fn advance(&mut self, motion: Pose2, seconds: f32) {
        for memory in &mut self.memories {
            memory.advance(motion, seconds);
        }
    }
}
