//! Recordings of the forward run again.

use std::path::Path;

use bica_console::Failure;
use bica_game::{ReplayOptions, replay, rerun};
use serde_json::Value;

use bica_monitor::program::{Compared, Replay};

/// Runs recordings of the forward again.
pub(super) struct GameReplay;

impl Replay for GameReplay {
    fn again(
        &self,
        recording: &Path,
        set: &[String],
        out: &Path,
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Result<(), Failure> {
        rerun(recording, set, out, progress).map(drop)
    }

    fn compare(&self, one: &Path, other: &Path) -> Result<Compared, Failure> {
        let result = replay(&ReplayOptions { against: Some(other), ..ReplayOptions::whole(one) })?;
        let Some(first) = result.first_difference else { return Ok(Compared::Equal { cycles: result.cycles }) };
        let of = first.component.map(|name| format!("{name}, ")).unwrap_or_default();
        let text = format!("{of}{}: {} in one, {} in the other", first.field, first.recorded, first.repeated);
        let time_us = (first.t * 1e6).round() as u64;
        let decisions = serde_json::to_value(&result.decisions).unwrap_or(Value::Null);
        Ok(Compared::Different { cycle: first.cycle, time_us, field: first.field, text, decisions })
    }
}
