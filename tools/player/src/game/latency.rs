//! Latency of the forward: the time of each cycle from sensing to acting.

use std::time::{Duration, Instant};

use bica::Probe;
use bica::runner::{Cycle, Observer};
use bica_evaluation::statistics::percentile;
use bica_motion::robot::Sensors;
use bica_player::tunable::Forward;
use serde::Serialize;

/// Bound of the paper for one cycle, ms.
const BOUND_MS: f64 = 200.0;

/// Largest number of cycles of one game whose latency is stored, almost three hours: a served world has no end.
const MAX_CYCLES: usize = 1_000_000;

/// Latency of every cycle, ns; in a game with more than [`MAX_CYCLES`] cycles only of the newest ones.
#[derive(Clone, Debug, Default)]
pub(crate) struct Latencies {
    times: Vec<u32>,
    /// Index of the newest latency.
    newest: usize,
}

/// Percentiles of latencies, ms.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct LatencySummary {
    /// Median.
    pub p50: f64,
    /// 99th percentile.
    pub p99: f64,
    /// Maximum.
    pub max: f64,
    /// Number of cycles above the bound.
    pub over_bound: usize,
    /// Bound of one cycle.
    pub bound: f64,
}

impl Latencies {
    fn add(&mut self, time: Duration) {
        let nanoseconds = u32::try_from(time.as_nanos()).unwrap_or(u32::MAX);
        if self.times.len() < MAX_CYCLES {
            self.newest = self.times.len();
            self.times.push(nanoseconds);
        } else {
            self.newest = (self.newest + 1) % MAX_CYCLES;
            self.times[self.newest] = nanoseconds;
        }
    }

    /// Adds the latencies of another game.
    pub(crate) fn extend(&mut self, other: &Self) {
        self.times.extend_from_slice(&other.times);
    }

    /// Returns the percentiles; zero without cycles.
    pub(crate) fn summarize(&self) -> LatencySummary {
        let mut sorted: Vec<f64> = self.times.iter().map(|&nanoseconds| f64::from(nanoseconds) * 1e-6).collect();
        sorted.sort_by(f64::total_cmp);
        let over_bound = sorted.iter().filter(|time| **time > BOUND_MS).count();
        let at = |part| percentile(&sorted, part).unwrap_or(0.0);
        LatencySummary { p50: at(0.5), p99: at(0.99), max: at(1.0), over_bound, bound: BOUND_MS }
    }
}

/// Observer of the loop that measures each cycle.
#[derive(Debug)]
pub(crate) struct Stopwatch {
    began: Instant,
    pub(crate) latencies: Latencies,
}

impl Default for Stopwatch {
    fn default() -> Self {
        Self { began: Instant::now(), latencies: Latencies::default() }
    }
}

impl Probe for Stopwatch {}

impl Observer<Forward> for Stopwatch {
    fn sensing(&mut self, _now: bica::Instant, _sensors: &Sensors<'_>) {
        self.began = Instant::now();
    }

    fn acted(&mut self, _cycle: &Cycle<'_, Forward>) {
        self.latencies.add(self.began.elapsed());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn memory_is_bounded_and_keeps_the_newest() {
        let mut latencies = Latencies::default();
        for cycle in 0..MAX_CYCLES + 3 {
            latencies.add(Duration::from_nanos(cycle as u64));
        }
        assert_eq!(latencies.times.len(), MAX_CYCLES);
        assert!(latencies.times.iter().all(|&time| time >= 3));
        assert!((latencies.summarize().max - (MAX_CYCLES + 2) as f64 * 1e-6).abs() < 1e-9);
    }
}
