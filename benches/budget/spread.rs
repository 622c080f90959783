//! How a figure spreads.

/// Median, 99th percentile and most of some figures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Spread {
    pub(crate) p50: f64,
    pub(crate) p99: f64,
    pub(crate) max: f64,
}

impl Spread {
    /// By nearest rank; `None` of nothing.
    pub(crate) fn of(mut figures: Vec<f64>) -> Option<Self> {
        figures.sort_unstable_by(f64::total_cmp);
        let rank = |part: f64| figures.get(((part * figures.len() as f64).ceil() as usize).max(1) - 1).copied();
        Some(Self { p50: rank(0.5)?, p99: rank(0.99)?, max: rank(1.0)? })
    }

    /// All of it times a factor.
    pub(crate) fn times(self, factor: f64) -> Self {
        Self { p50: self.p50 * factor, p99: self.p99 * factor, max: self.max * factor }
    }
}
