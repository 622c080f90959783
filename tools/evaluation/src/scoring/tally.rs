//! Counts and percentiles.

use crate::statistics::percentile;
use serde::Serialize;

/// Number of good cases among all cases.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub(super) struct Share {
    pub(super) of: usize,
    pub(super) good: usize,
}

impl Share {
    pub(super) fn count(&mut self, good: bool) {
        self.of += 1;
        self.good += usize::from(good);
    }

    /// Returns the fraction of good cases; `None` without cases.
    pub(super) fn ratio(self) -> Option<f32> {
        (self.of > 0).then(|| self.good as f32 / self.of as f32)
    }
}

/// Format `66/68 0.971`.
impl std::fmt::Display for Share {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { of, good } = *self;
        if of == 0 { write!(out, "none") } else { write!(out, "{good}/{of} {:.3}", good as f32 / of as f32) }
    }
}

/// Errors of measurements.
#[derive(Clone, Debug, Default)]
pub(super) struct Errors(Vec<f64>);

/// Percentiles of errors; `None` without measurements.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub(super) struct Percentiles {
    pub p50: Option<f64>,
    pub p95: Option<f64>,
    pub(super) max: Option<f64>,
}

impl Errors {
    pub(super) fn note(&mut self, error: f32) {
        self.0.push(error.into());
    }

    pub(super) fn spread(&self) -> Percentiles {
        let mut sorted = self.0.clone();
        sorted.sort_by(f64::total_cmp);
        let at = |part| percentile(&sorted, part);
        Percentiles { p50: at(0.5), p95: at(0.95), max: at(1.0) }
    }
}

impl Percentiles {
    /// Text of the percentiles, each multiplied by `factor` and followed by a unit.
    pub(super) fn text(self, factor: f64, unit: &str) -> String {
        let number =
            |value: Option<f64>| value.map_or_else(|| "-".to_owned(), |value| format!("{:.2}", factor * value));
        format!("median {}, 95 % {}, worst {} {unit}", number(self.p50), number(self.p95), number(self.max))
    }
}
