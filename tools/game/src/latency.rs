//! Latency of the forward: the time of each cycle from sensing to acting.

use std::time::{Duration, Instant};

use bica::Probe;
use bica::runner::{Cycle, Observer};
use bica_console::statistics::percentile;
use bica_motion::robot::Sensors;
use bica_player::tunable::Forward;
use serde::Serialize;

/// Bound of the paper for one cycle, ms.
const BOUND_MS: f64 = 200.0;

/// Latency of every cycle, ns.
#[derive(Clone, Debug, Default)]
pub(crate) struct Latencies(Vec<u32>);

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
        self.0.push(u32::try_from(time.as_nanos()).unwrap_or(u32::MAX));
    }

    /// Latency of the last cycle; zero before the first.
    pub(crate) fn last(&self) -> Duration {
        Duration::from_nanos(self.0.last().copied().unwrap_or(0).into())
    }

    /// Adds those of another game.
    pub(crate) fn extend(&mut self, other: &Self) {
        self.0.extend_from_slice(&other.0);
    }

    /// Returns the percentiles; zero without cycles.
    pub(crate) fn summarize(&self) -> LatencySummary {
        let mut sorted: Vec<f64> = self.0.iter().map(|&nanoseconds| f64::from(nanoseconds) * 1e-6).collect();
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
