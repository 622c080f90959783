//! Comparison of measured times with declared budgets.

use super::quantiles::Quantiles;

/// Measured and declared time of a component or phase, µs.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Name of the component or phase.
    pub name: &'static str,
    /// Number of runs.
    pub runs: usize,
    /// Quantiles over the runs, each with its minimum time over all repetitions; `None` without a run.
    pub time: Option<Quantiles>,
    /// Maximum time of a run over all repetitions, including interruptions.
    pub ever: f64,
    /// Declared budget.
    pub budget: Option<f64>,
}

impl Row {
    /// Share of the budget that the slowest run leaves free; negative if it exceeds the budget.
    #[must_use]
    pub fn headroom(&self) -> Option<f64> {
        Some(1.0 - self.time?.max / self.budget?)
    }
}

/// Returns a message for each component that exceeds its budget.
pub fn over_budget(rows: &[Row]) -> impl Iterator<Item = String> {
    rows.iter().filter_map(|row| {
        let (time, budget) = (row.time?, row.budget?);
        (time.max > budget).then(|| {
            format!(
                "{} takes {:.1} µs in its slowest run and declares {budget} µs: make it faster, or raise `budget_us`",
                row.name, time.max
            )
        })
    })
}

/// Returns a message for each component that never ran, whose budget is therefore not checked.
pub fn never_ran(rows: &[Row]) -> impl Iterator<Item = String> {
    rows.iter().filter(|row| row.time.is_none()).map(|row| {
        format!("{} ran in none of the games: its budget is not checked; add a game in which it runs", row.name)
    })
}

/// Returns a message if a time exceeds its limit; both in µs.
#[must_use]
pub fn over_limit(what: &str, took: f64, limit: f64) -> Option<String> {
    (took > limit).then(|| format!("{what} takes {:.2} ms, the limit is {:.2} ms", took * 1e-3, limit * 1e-3))
}
