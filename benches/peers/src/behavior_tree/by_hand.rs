//! The leaves as an index.

use super::{LEAVES, STEPS, turn, work};
use crate::subject::Subject;

/// The leaves as an index: a sequence, or the fallback.
pub struct ByHand<const SEQUENCE: bool> {
    leaf: usize,
    steps: u32,
    number: u64,
}

impl<const SEQUENCE: bool> ByHand<SEQUENCE> {
    /// Creates the leaves; the first one is active.
    #[must_use]
    pub const fn new() -> Self {
        Self { leaf: 0, steps: 0, number: 1 }
    }
}

impl<const SEQUENCE: bool> Default for ByHand<SEQUENCE> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const SEQUENCE: bool> Subject for ByHand<SEQUENCE> {
    fn cycle(&mut self, now: u64) {
        if !SEQUENCE {
            self.leaf = turn(now);
        } else if self.steps == STEPS {
            (self.leaf, self.steps) = ((self.leaf + 1) % LEAVES, 0);
        }
        self.steps += u32::from(SEQUENCE);
        self.number = work(self.leaf, self.number);
    }

    fn result(&self) -> u64 {
        self.number
    }
}
