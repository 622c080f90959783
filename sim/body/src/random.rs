//! Seeded random streams.

use core::f32::consts::TAU;

use libm::{cosf, logf, sqrtf};
use rand_pcg::{Pcg32, rand_core::Rng};

/// A pseudo-random generator (PCG).
#[derive(Clone, Debug)]
pub struct Random(Pcg32);

impl Random {
    /// Starts a stream of a seed. Streams are independent: drawing more numbers from one does not change the numbers of another.
    #[must_use]
    pub fn new(seed: u64, stream: impl Into<u64>) -> Self {
        Self(Pcg32::new(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15), stream.into()))
    }

    /// Returns a uniform 32-bit number.
    pub fn bits(&mut self) -> u32 {
        self.0.next_u32()
    }

    /// Returns a uniform number in [0, 1).
    pub fn unit(&mut self) -> f32 {
        (self.bits() >> 8) as f32 / (1 << 24) as f32
    }

    /// Returns a uniform number between `low` and `high`.
    pub fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * self.unit()
    }

    /// Returns a uniform number from 0 to `count` − 1; 0 if `count` is 0.
    pub fn below(&mut self, count: usize) -> usize {
        ((self.bits() as u64 * count as u64) >> 32) as usize
    }

    /// Returns true with the given probability.
    pub fn chance(&mut self, probability: f32) -> bool {
        self.unit() < probability
    }

    /// Returns a standard normal number: mean 0, standard deviation 1 (Box and Muller 1958).
    pub fn normal(&mut self) -> f32 {
        let radius = sqrtf(-2.0 * logf(1.0 - self.unit()));
        radius * cosf(TAU * self.unit())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normal_numbers_have_mean_zero_and_deviation_one() {
        let mut random = Random::new(1, 0_u64);
        let numbers: Vec<f32> = (0..20_000).map(|_| random.normal()).collect();
        let mean = numbers.iter().sum::<f32>() / 20_000.0;
        let variance = numbers.iter().map(|x| x * x).sum::<f32>() / 20_000.0;
        assert!(mean.abs() < 0.03, "mean {mean}");
        assert!((variance - 1.0).abs() < 0.05, "variance {variance}");
    }

    #[test]
    fn streams_and_seeds_give_different_numbers() {
        let first = |seed, stream: u64| Random::new(seed, stream).bits();
        assert_ne!(first(1, 0), first(2, 0));
        assert_ne!(first(1, 0), first(1, 1));
    }
}
