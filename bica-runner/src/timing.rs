//! Statistics of durations.

use bica_core::Duration;

/// Number of classes of durations; their upper bounds are powers of two, µs.
const CLASSES: usize = 32;

/// Number, mean, maximum and quantiles of durations, in constant memory.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Timing {
    count: u64,
    sum_us: u64,
    max_us: u64,
    /// Number of durations in each class: class `n` contains durations below 2ⁿ µs that are in no lower class.
    classes: [u64; CLASSES],
}

impl Timing {
    /// Creates statistics without durations.
    #[must_use]
    pub const fn new() -> Self {
        Self { count: 0, sum_us: 0, max_us: 0, classes: [0; CLASSES] }
    }

    /// Adds a duration.
    pub const fn add(&mut self, duration: Duration) {
        let us = duration.as_micros();
        self.count += 1;
        self.sum_us = self.sum_us.saturating_add(us);
        if us > self.max_us {
            self.max_us = us;
        }
        let class = (u64::BITS - us.leading_zeros()) as usize;
        self.classes[if class < CLASSES { class } else { CLASSES - 1 }] += 1;
    }

    /// Number of durations.
    #[must_use]
    pub const fn count(&self) -> u64 {
        self.count
    }

    /// Mean duration; zero without durations.
    #[must_use]
    pub const fn mean(&self) -> Duration {
        Duration::from_micros(match self.sum_us.checked_div(self.count) {
            Some(mean) => mean,
            None => 0,
        })
    }

    /// Maximum duration.
    #[must_use]
    pub const fn max(&self) -> Duration {
        Duration::from_micros(self.max_us)
    }

    /// Returns an upper bound of the quantile `share` (0 to 1): at most twice the true quantile and never above the
    /// maximum.
    #[must_use]
    pub fn quantile(&self, share: f32) -> Duration {
        let rank = share * self.count as f32;
        let mut seen = 0;
        for (class, count) in self.classes.iter().enumerate() {
            seen += count;
            if seen as f32 >= rank {
                return Duration::from_micros(((1 << class) - 1).min(self.max_us));
            }
        }
        self.max()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mean_maximum_and_quantiles_of_known_durations() {
        let mut timing = Timing::new();
        assert_eq!((timing.mean(), timing.max(), timing.quantile(0.99)), (Duration::MIN, Duration::MIN, Duration::MIN));
        for us in [0, 1, 3, 3, 3, 3, 3, 3, 3, 1000] {
            timing.add(Duration::from_micros(us));
        }
        assert_eq!(timing.count(), 10);
        assert_eq!(timing.mean(), Duration::from_micros(102));
        assert_eq!(timing.max(), Duration::from_micros(1000));
        let quantiles = [0.1, 0.2, 0.9, 1.0].map(|share| timing.quantile(share).as_micros());
        assert_eq!(quantiles, [0, 1, 3, 1000]);
    }

    #[test]
    fn too_long_duration_counts_in_the_last_class() {
        let mut timing = Timing::new();
        timing.add(Duration::from_secs(1 << 40));
        assert_eq!(timing.classes[CLASSES - 1], 1);
        assert_eq!(timing.max().as_secs(), 1 << 40);
    }
}
