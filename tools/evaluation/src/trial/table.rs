//! Results of trials.

use bica_app::{Console, Failure, Style};
use serde::Serialize;

/// One case of a trial, with all seeds.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Row {
    /// Name of the case.
    pub(super) name: String,
    /// Number of runs.
    pub(super) runs: usize,
    /// Number of runs that succeeded.
    pub(super) good: usize,
    /// Number of runs that must succeed.
    pub(super) needed: usize,
    /// Other measurements, as text with units.
    pub(super) figures: String,
    /// Whether the other measurements meet their requirements.
    pub(super) figures_hold: bool,
}

/// Results of one trial.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Table {
    /// Name of the trial.
    pub(super) trial: String,
    /// One row for each case.
    pub(super) rows: Vec<Row>,
}

/// Results of all trials.
#[derive(Serialize)]
pub(super) struct TrialReport<'a> {
    pub(super) schema: &'static str,
    pub(super) runs: u32,
    pub(super) tables: &'a [Table],
}

impl Row {
    /// Creates the row of a case whose only requirement is the number of successful runs.
    pub(super) fn new(name: impl Into<String>, runs: usize, good: usize, needed: usize, figures: String) -> Self {
        Self { name: name.into(), runs, good, needed, figures, figures_hold: true }
    }

    const fn holds(&self) -> bool {
        self.good >= self.needed && self.figures_hold
    }
}

impl Table {
    /// Returns whether all rows meet their requirements.
    pub(super) fn holds(&self) -> bool {
        self.rows.iter().all(Row::holds)
    }

    /// Prints the table.
    pub(super) fn print(&self, console: Console) -> Result<(), Failure> {
        let heading = format!("{:<26} {:>9} {:>7}  figures", self.trial, "good", "needed");
        console.print(&console.styled(Style::Strong, &heading))?;
        for row in &self.rows {
            let style = if row.holds() { Style::Good } else { Style::Bad };
            let good = console.styled(style, &format!("{:>9}", format!("{}/{}", row.good, row.runs)));
            console.print(&format!("{:<26} {good} {:>7}  {}", row.name, row.needed, row.figures))?;
        }
        console.print("")
    }
}

/// Returns the median (the upper one for an even number of values); 0 without values.
pub(super) fn median(mut values: Vec<f32>) -> f32 {
    values.sort_by(f32::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}

/// Returns the mean; 0 without values.
pub(super) fn mean(values: &[f32]) -> f32 {
    values.iter().sum::<f32>() / values.len().max(1) as f32
}
