//! What was reached, for people and machines.

use serde::Serialize;

use bica_console::Failure;
use bica_console::{Console, Style};

/// One thing that was tried, with every seed.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    pub name: String,
    pub runs: usize,
    /// Runs that went well.
    pub good: usize,
    /// Runs that have to.
    pub needed: usize,
    /// What else was measured: in words, with units.
    pub figures: String,
    /// Whether the figures are as they have to be.
    pub figures_hold: bool,
}

/// One trial.
#[derive(Clone, Debug, Serialize)]
pub struct Table {
    pub trial: &'static str,
    pub rows: Vec<Row>,
}

/// Trials for machines.
#[derive(Serialize)]
pub struct Told<'a> {
    pub schema: &'static str,
    pub runs: u64,
    pub tables: &'a [Table],
}

impl Row {
    const fn holds(&self) -> bool {
        self.good >= self.needed && self.figures_hold
    }
}

impl Table {
    /// Whether everything is as it has to be.
    pub fn holds(&self) -> bool {
        self.rows.iter().all(Row::holds)
    }

    /// Tells people.
    pub fn tell(&self, console: Console) -> Result<(), Failure> {
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

/// The value in the middle; 0 of none.
pub fn median(mut values: Vec<f32>) -> f32 {
    values.sort_by(f32::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}

/// The mean; 0 of none.
pub fn mean(values: &[f32]) -> f32 {
    values.iter().sum::<f32>() / values.len().max(1) as f32
}
