//! Reproducible random numbers.

/// Generator PCG-XSH-RR 64/32 (O'Neill 2014, "PCG: A Family of Simple Fast Space-Efficient Statistically Good
/// Algorithms for Random Number Generation").
#[derive(Clone, Debug)]
pub(super) struct Random {
    state: u64,
}

impl Random {
    const FACTOR: u64 = 6_364_136_223_846_793_005;
    const STREAM: u64 = 1_442_695_040_888_963_407;

    pub(super) const fn new(seed: u64) -> Self {
        Self { state: seed.wrapping_add(Self::STREAM).wrapping_mul(Self::FACTOR).wrapping_add(Self::STREAM) }
    }

    const fn bits(&mut self) -> u32 {
        let old = self.state;
        self.state = old.wrapping_mul(Self::FACTOR).wrapping_add(Self::STREAM);
        let mixed = (((old >> 18) ^ old) >> 27) as u32;
        mixed.rotate_right((old >> 59) as u32)
    }

    /// Uniform in [0, 1).
    pub(super) fn unit(&mut self) -> f32 {
        (self.bits() >> 8) as f32 / (1_u32 << 24) as f32
    }

    /// Uniform in −`most` to `most`.
    pub(super) fn within(&mut self, most: f32) -> f32 {
        most * (2.0 * self.unit() - 1.0)
    }

    /// Uniform integer below `count`; 0 if `count` is 0.
    pub(super) fn below(&mut self, count: usize) -> usize {
        ((self.unit() * count as f32) as usize).min(count.saturating_sub(1))
    }

    /// Approximately standard normal: the sum of the four bytes of a number, within ±3.5, in steps of 0.007.
    pub(super) fn normal(&mut self) -> f32 {
        let bits = self.bits();
        let pairs = (bits & 0x00FF_00FF) + (bits >> 8 & 0x00FF_00FF);
        let sum = (pairs & 0xFFFF) + (pairs >> 16);
        // The variance of a byte is (256² − 1) / 12.
        (sum as f32 - 510.0) * 0.006_765_875
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distributions_have_the_stated_moments() {
        let mut random = Random::new(7);
        let (mut sum, mut squares, mut even) = (0.0, 0.0, [0_u32; 10]);
        for _ in 0..20_000 {
            let normal = f64::from(random.normal());
            sum += normal;
            squares += normal * normal;
            even[random.below(10)] += 1;
        }
        assert!((sum / 20_000.0).abs() < 0.03 && (squares / 20_000.0 - 1.0).abs() < 0.03, "{sum} {squares}");
        assert!(even.iter().all(|count| (1850..2150).contains(count)), "{even:?}");
        assert_eq!(Random::new(3).bits(), Random::new(3).bits());
        assert_eq!(random.below(0), 0);
    }
}
