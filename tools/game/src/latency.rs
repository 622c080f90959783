//! How long the forward thinks: the time of each cycle from sensing to acting.

use std::time::Duration;

use bica_console::statistics::percentile;
use serde::Serialize;

/// What the whole chain may take (the paper's bound), ms.
pub const BOUND_MS: f64 = 200.0;

/// The time of every cycle.
#[derive(Clone, Debug, Default)]
pub struct Latencies(Vec<u32>);

/// Percentiles, ms.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Latency {
    pub p50: f64,
    pub p99: f64,
    pub max: f64,
    /// Cycles that took longer than the bound.
    pub over_bound: usize,
    pub bound: f64,
}

impl Latencies {
    /// Notes one cycle.
    pub fn note(&mut self, time: Duration) {
        self.0.push(u32::try_from(time.as_nanos()).unwrap_or(u32::MAX));
    }

    /// Takes in those of another game.
    pub fn extend(&mut self, other: &Self) {
        self.0.extend_from_slice(&other.0);
    }

    /// Sums them up; zero if there was no cycle.
    pub fn sum_up(&self) -> Latency {
        let mut sorted: Vec<f64> = self.0.iter().map(|&nanoseconds| f64::from(nanoseconds) * 1e-6).collect();
        sorted.sort_by(f64::total_cmp);
        let over_bound = sorted.iter().filter(|time| **time > BOUND_MS).count();
        let at = |part| percentile(&sorted, part).unwrap_or(0.0);
        Latency { p50: at(0.5), p99: at(0.99), max: at(1.0), over_bound, bound: BOUND_MS }
    }
}
