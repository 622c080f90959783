//! What must hold, and what does not.

use crate::spread::Spread;

/// What a component took, and what it says it takes. µs.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Row {
    pub(crate) name: &'static str,
    pub(crate) runs: usize,
    /// Of every run the least time measured; `None` if it never ran.
    pub(crate) time: Option<Spread>,
    /// The longest ever measured, with all that the machine did in between.
    pub(crate) most: f64,
    /// As declared.
    pub(crate) budget: Option<f64>,
}

impl Row {
    /// The part of the budget that its slowest run leaves; negative if it exceeds the budget.
    pub(crate) fn headroom(&self) -> Option<f64> {
        Some(1.0 - self.time?.max / self.budget?)
    }
}

/// The components that break their word, in words.
pub(crate) fn broken(rows: &[Row]) -> impl Iterator<Item = String> {
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

/// The components that never ran, of which a report can say nothing.
pub(crate) fn idle(rows: &[Row]) -> impl Iterator<Item = String> {
    rows.iter()
        .filter(|row| row.time.is_none())
        .map(|row| format!("{} ran in none of the games: its budget is not proved, change a game", row.name))
}

/// Whether a chain is later than it may be, in words. µs.
pub(crate) fn late(what: &str, took: f64, limit: f64) -> Option<String> {
    (took > limit).then(|| format!("{what} takes {:.2} ms and may take {:.2} ms", took * 1e-3, limit * 1e-3))
}
