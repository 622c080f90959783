//! What was reached, for people and machines.

use serde::Serialize;

use crate::program::ending::Failure;
use crate::program::voice::{Style, Voice};

/// One thing that was tried, with every seed.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Row {
    pub(crate) name: String,
    pub(crate) runs: usize,
    /// Runs that went well.
    pub(crate) good: usize,
    /// Runs that have to.
    pub(crate) needed: usize,
    /// What else was measured: in words, with units.
    pub(crate) figures: String,
    /// Whether the figures are as they have to be.
    pub(crate) figures_hold: bool,
}

/// One trial.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Table {
    pub(crate) trial: &'static str,
    pub(crate) rows: Vec<Row>,
}

/// Trials for machines.
#[derive(Serialize)]
pub(crate) struct Told<'a> {
    pub(crate) schema: &'static str,
    pub(crate) runs: u64,
    pub(crate) tables: &'a [Table],
}

impl Row {
    const fn holds(&self) -> bool {
        self.good >= self.needed && self.figures_hold
    }
}

impl Table {
    /// Whether everything is as it has to be.
    pub(crate) fn holds(&self) -> bool {
        self.rows.iter().all(Row::holds)
    }

    /// Tells people.
    pub(crate) fn tell(&self, voice: Voice) -> Result<(), Failure> {
        let heading = format!("{:<26} {:>9} {:>7}  figures", self.trial, "good", "needed");
        voice.say(&voice.style(Style::Strong, &heading))?;
        for row in &self.rows {
            let style = if row.holds() { Style::Good } else { Style::Bad };
            let good = voice.style(style, &format!("{:>9}", format!("{}/{}", row.good, row.runs)));
            voice.say(&format!("{:<26} {good} {:>7}  {}", row.name, row.needed, row.figures))?;
        }
        voice.say("")
    }
}

/// The value in the middle; 0 of none.
pub(crate) fn median(mut values: Vec<f32>) -> f32 {
    values.sort_by(f32::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}

/// The mean; 0 of none.
pub(crate) fn mean(values: &[f32]) -> f32 {
    values.iter().sum::<f32>() / values.len().max(1) as f32
}
