//! The declared budgets against the measured times.

use super::spread::Spread;

/// Measured and declared time of a component, µs.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The component.
    pub name: &'static str,
    /// Number of runs.
    pub runs: usize,
    /// Spread of the runs, each with its least time over all repetitions; `None` without a run.
    pub time: Option<Spread>,
    /// Longest time of a run, interruptions included.
    pub most: f64,
    /// Declared budget.
    pub budget: Option<f64>,
}

impl Row {
    /// Share of the budget that the slowest run leaves; negative if it exceeds the budget.
    #[must_use]
    pub fn headroom(&self) -> Option<f64> {
        Some(1.0 - self.time?.max / self.budget?)
    }
}

/// A message for each component that exceeds its budget.
pub fn broken(rows: &[Row]) -> impl Iterator<Item = String> {
    rows.iter().filter_map(|row| {
        let (time, budget) = (row.time?, row.budget?);
        (time.max > budget).then(|| {
            format!(
                "{} takes {:.1} µs in its slowest run and declares {budget} µs: make it faster, or declare what it takes",
                row.name, time.max
            )
        })
    })
}

/// A message for each component that never ran, so that nothing is known of its budget.
pub fn idle(rows: &[Row]) -> impl Iterator<Item = String> {
    rows.iter()
        .filter(|row| row.time.is_none())
        .map(|row| format!("{} ran in none of the games: its budget is not proved, change a game", row.name))
}

/// A message if a chain takes longer than its limit; both in µs.
#[must_use]
pub fn late(what: &str, took: f64, limit: f64) -> Option<String> {
    (took > limit).then(|| format!("{what} takes {:.2} ms and may take {:.2} ms", took * 1e-3, limit * 1e-3))
}
