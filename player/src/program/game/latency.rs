//! How long the forward thinks: the time of each cycle from sensing to acting.

use std::time::Duration;

use serde::Serialize;

/// What the whole chain may take (the paper's bound), ms.
pub(crate) const BOUND_MS: f64 = 200.0;

/// The time of every cycle.
#[derive(Clone, Debug, Default)]
pub(crate) struct Latencies(Vec<u32>);

/// Percentiles, ms.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct Latency {
    pub(crate) p50: f64,
    pub(crate) p99: f64,
    pub(crate) max: f64,
    /// Cycles that took longer than the bound.
    pub(crate) over_bound: usize,
    pub(crate) bound: f64,
}

impl Latencies {
    /// Notes one cycle.
    pub(crate) fn note(&mut self, time: Duration) {
        self.0.push(u32::try_from(time.as_nanos()).unwrap_or(u32::MAX));
    }

    /// Takes in those of another game.
    pub(crate) fn extend(&mut self, other: &Self) {
        self.0.extend_from_slice(&other.0);
    }

    /// Sums them up; zero if there was no cycle.
    pub(crate) fn sum_up(&self) -> Latency {
        let mut sorted: Vec<f64> = self.0.iter().map(|&nanoseconds| f64::from(nanoseconds) * 1e-6).collect();
        sorted.sort_by(f64::total_cmp);
        let over_bound = sorted.iter().filter(|time| **time > BOUND_MS).count();
        let at = |part| percentile(&sorted, part).unwrap_or(0.0);
        Latency { p50: at(0.5), p99: at(0.99), max: at(1.0), over_bound, bound: BOUND_MS }
    }
}

/// The smallest value that at least `part` of the sorted values do not exceed (nearest rank).
pub(crate) fn percentile(sorted: &[f64], part: f64) -> Option<f64> {
    let rank = (part * sorted.len() as f64).ceil() as usize;
    sorted.get(rank.max(1) - 1).copied()
}

#[cfg(test)]
mod tests {
    use super::percentile;

    #[test]
    fn percentiles_are_values_by_nearest_rank() {
        let values: Vec<f64> = (1..=100).map(f64::from).collect();
        assert_eq!(percentile(&values, 0.5), Some(50.0));
        assert_eq!(percentile(&values, 0.99), Some(99.0));
        assert_eq!(percentile(&values, 1.0), Some(100.0));
        assert_eq!(percentile(&values[..1], 0.0), Some(1.0));
        assert_eq!(percentile(&[], 0.5), None);
    }
}
