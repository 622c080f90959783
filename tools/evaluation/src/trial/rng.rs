//! Random numbers of a trial.

use rand_pcg::{Pcg32, rand_core::Rng as _};

/// Random number generator (PCG).
pub(super) struct Rng(Pcg32);

impl Rng {
    pub(super) fn new(seed: u64) -> Self {
        Self(Pcg32::new(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15), 0x7472_6961_6c73))
    }

    /// Returns a number uniformly distributed from `low` to `high`.
    pub(super) fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * (self.0.next_u32() >> 8) as f32 / (1 << 24) as f32
    }
}
