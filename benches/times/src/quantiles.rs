//! Quantiles.

/// Median, 99th percentile and maximum of a set of figures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantiles {
    /// Median.
    pub p50: f64,
    /// 99th percentile.
    pub p99: f64,
    /// Maximum.
    pub max: f64,
}

impl Quantiles {
    /// Computes the quantiles by nearest rank; `None` without figures.
    #[must_use]
    pub fn of(mut figures: Vec<f64>) -> Option<Self> {
        figures.sort_unstable_by(f64::total_cmp);
        let rank = |part: f64| figures.get(((part * figures.len() as f64).ceil() as usize).max(1) - 1).copied();
        Some(Self { p50: rank(0.5)?, p99: rank(0.99)?, max: rank(1.0)? })
    }

    /// Multiplies all quantiles by a factor.
    #[must_use]
    pub fn times(self, factor: f64) -> Self {
        Self { p50: self.p50 * factor, p99: self.p99 * factor, max: self.max * factor }
    }
}
