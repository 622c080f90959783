//! Results of trials.

use serde::Serialize;

use bica_console::Failure;
use bica_console::{Console, Style};

/// One case of a trial, with all seeds.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// Name of the case.
    pub name: String,
    /// Number of runs.
    pub runs: usize,
    /// Number of runs that succeeded.
    pub good: usize,
    /// Number of runs that must succeed.
    pub needed: usize,
    /// Other measurements, as text with units.
    pub figures: String,
    /// Whether the other measurements are as required.
    pub figures_hold: bool,
}

/// Results of one trial.
#[derive(Clone, Debug, Serialize)]
pub struct Table {
    /// Name of the trial.
    pub trial: &'static str,
    /// One row for each case.
    pub rows: Vec<Row>,
}

/// Results of all trials.
#[derive(Serialize)]
pub struct TrialReport<'a> {
    pub schema: &'static str,
    pub runs: u32,
    pub tables: &'a [Table],
}

impl Row {
    const fn holds(&self) -> bool {
        self.good >= self.needed && self.figures_hold
    }
}

impl Table {
    /// Returns whether all rows are as required.
    pub fn holds(&self) -> bool {
        self.rows.iter().all(Row::holds)
    }

    /// Prints the table.
    pub fn print(&self, console: Console) -> Result<(), Failure> {
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

/// Returns the median (the upper one of an even number); 0 of no values.
pub fn median(mut values: Vec<f32>) -> f32 {
    values.sort_by(f32::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}

/// Returns the mean; 0 of no values.
pub fn mean(values: &[f32]) -> f32 {
    values.iter().sum::<f32>() / values.len().max(1) as f32
}
