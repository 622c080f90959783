//! Random numbers from a seed.

use core::f32::consts::TAU;

use libm::{cosf, logf, sqrtf};
use rand_pcg::{Pcg32, rand_core::Rng};

/// What the numbers are for. Every purpose has its own stream, so that drawing more of one leaves the others as they
/// were.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Stream {
    /// Where everything is at the start, and how the ball rolls.
    Start,
    /// How the feet slip.
    Slip,
    /// Noise of the body's sensors.
    Sensors,
    /// Walls, people and carpet.
    Hall,
    /// Camera settings.
    Camera,
    /// Noise in the images.
    Grain,
}

/// A generator of random numbers.
#[derive(Clone, Debug)]
pub(crate) struct Random(Pcg32);

impl Random {
    pub(crate) fn new(seed: u64, stream: Stream) -> Self {
        Self(Pcg32::new(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15), stream as u64))
    }

    /// Any number.
    pub(crate) fn bits(&mut self) -> u32 {
        self.0.next_u32()
    }

    /// From 0 inclusive to 1 exclusive, uniform.
    pub(crate) fn unit(&mut self) -> f32 {
        (self.bits() >> 8) as f32 / (1 << 24) as f32
    }

    /// From `low` to `high`, uniform.
    pub(crate) fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * self.unit()
    }

    /// From 0 to `count` − 1; 0 if `count` is 0.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        ((self.bits() as u64 * count as u64) >> 32) as usize
    }

    /// True with the probability given.
    pub(crate) fn chance(&mut self, probability: f32) -> bool {
        self.unit() < probability
    }

    /// Normal, mean 0, standard deviation 1 (Box and Muller 1958).
    pub(crate) fn normal(&mut self) -> f32 {
        let radius = sqrtf(-2.0 * logf(1.0 - self.unit()));
        radius * cosf(TAU * self.unit())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normal_numbers_have_mean_zero_and_deviation_one() {
        let mut random = Random::new(1, Stream::Start);
        let numbers: Vec<f32> = (0..20_000).map(|_| random.normal()).collect();
        let mean = numbers.iter().sum::<f32>() / 20_000.0;
        let variance = numbers.iter().map(|x| x * x).sum::<f32>() / 20_000.0;
        assert!(mean.abs() < 0.03, "mean {mean}");
        assert!((variance - 1.0).abs() < 0.05, "variance {variance}");
    }

    #[test]
    fn streams_and_seeds_differ() {
        let first = |seed, stream| Random::new(seed, stream).bits();
        assert_ne!(first(1, Stream::Start), first(2, Stream::Start));
        assert_ne!(first(1, Stream::Start), first(1, Stream::Slip));
    }
}
