//! Repeated runs of recordings.

use std::path::Path;

use bica_console::Failure;
use bica_recording::ReplayReport;
use serde::Serialize;

/// Runs recordings of a program again, and compares them.
pub trait Replay: Send + Sync {
    /// Runs the code again on a recording, with other parameters, and writes the new course to a file. `progress` is called now and then
    /// with the time of the last cycle, s; if it returns false, the run ends there.
    ///
    /// # Errors
    /// If a file cannot be read or written.
    fn again(
        &self,
        recording: &Path,
        set: &[String],
        out: &Path,
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Result<(), Failure>;

    /// Compares two recordings.
    ///
    /// # Errors
    /// If a file cannot be read.
    fn compare(&self, one: &Path, other: &Path) -> Result<Compared, Failure>;
}

/// Result of a comparison.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Compared {
    /// All cycles are equal.
    Equal {
        /// Number of compared cycles.
        cycles: u64,
    },
    /// They are not.
    Different {
        /// Cycle of the first difference.
        cycle: u64,
        /// Its time, µs.
        time_us: u64,
        /// What differs.
        field: String,
        /// The difference, for people.
        text: String,
        /// The first decisions that differ.
        decisions: serde_json::Value,
    },
}

impl From<ReplayReport> for Compared {
    fn from(report: ReplayReport) -> Self {
        let Some(first) = report.first_difference else { return Self::Equal { cycles: report.cycles } };
        let of = first.component.map(|name| format!("{name}, ")).unwrap_or_default();
        let text = format!("{of}{}: {} in one, {} in the other", first.field, first.recorded, first.repeated);
        let time_us = (first.t * 1e6).round() as u64;
        let decisions = serde_json::to_value(&report.decisions).unwrap_or_default();
        Self::Different { cycle: first.cycle, time_us, field: first.field, text, decisions }
    }
}
