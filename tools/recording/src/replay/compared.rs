//! Comparison of a recording, cycle by cycle, before and after its first gap.

use std::path::Path;

use super::run::Run;
use super::{FileRecording, ReplayOptions};
use crate::compare::Comparison;
use crate::error::Error;
use crate::recording::RecordedCycle;
use bica_wire::model::Invalid;

/// Comparison of a recording, before and after its first gap.
pub(super) struct Compared {
    /// Whether a cycle without its image is a gap.
    pub(super) detects_gaps: bool,
    pub(super) before: Comparison,
    pub(super) after: Comparison,
    pub(super) gaps: Vec<u64>,
    /// Time of the last cycle, s.
    pub(super) seconds: f64,
}

impl Compared {
    /// Compares cycle by cycle; returns the damage of the file, or that the user has stopped the comparison.
    pub(super) fn compare(
        &mut self,
        options: &ReplayOptions<'_>,
        recording: &mut FileRecording,
        other: &mut dyn Run,
        progress: &mut dyn FnMut(u64) -> bool,
    ) -> Result<Option<String>, Invalid> {
        let (mut first, mut cycle, mut is_whole) = (None, 0, false);
        let damage = loop {
            if !progress(recording.position()) {
                return Ok(Some("stopped by Ctrl-C".to_owned()));
            }
            let recorded = match recording.next_cycle() {
                Ok(Some(recorded)) => recorded,
                Ok(None) => {
                    is_whole = true;
                    break None;
                }
                Err(error @ (Error::CutOff { .. } | Error::Damaged { .. })) => break Some(error),
                Err(error) => return Err(error.of(options.path)),
            };
            let first = *first.get_or_insert(recorded.tick.instant);
            (self.before.first_instant, self.after.first_instant) = (first, first);
            let t = recording.header().seconds_since(first, recorded.tick.instant);
            if t > options.until {
                break None;
            }
            (self.seconds, cycle) = (t, recorded.tick.cycle);
            let repeated = other.next(&recorded)?;
            if self.detects_gaps && recorded.is_gap() {
                self.gaps.push(cycle);
            }
            match repeated {
                _ if t < options.from => {}
                Some(repeated) => self.add(&recorded, repeated),
                None => {
                    self.before.end(cycle, t, true);
                    break None;
                }
            }
        };
        self.check_span(options, damage.as_ref(), is_whole.then(|| recording.header().period() as f64 * 1e-9))?;
        if is_whole && other.goes_on()? {
            self.before.end(cycle + 1, self.seconds, false);
        }
        Ok(damage.map(|damage| damage.to_string()))
    }

    fn add(&mut self, recorded: &RecordedCycle, mut repeated: RecordedCycle) {
        if self.gaps.is_empty() {
            return self.before.add(recorded, &repeated);
        }
        // The fingerprint depends on all cycles before.
        repeated.tick.fingerprint = recorded.tick.fingerprint;
        self.after.add(recorded, &repeated);
    }

    /// Refuses a span that has no cycle, or, in a whole recording with a time between cycles, s, one that goes beyond its end.
    fn check_span(
        &self,
        options: &ReplayOptions<'_>,
        damage: Option<&Error>,
        whole: Option<f64>,
    ) -> Result<(), Invalid> {
        let (path, end) = (Path::display(options.path), self.seconds);
        let help = "give a span within the recording with --from and --until";
        if self.before.cycles + self.after.cycles == 0 && self.before.is_equal() {
            let what = match (damage, whole) {
                (Some(damage), _) if options.from <= end => {
                    let what = format!("no cycle was compared: `{path}` has none before its damage: {damage}");
                    return Err(Invalid::new(what, damage.help()));
                }
                (Some(damage), _) => format!("no cycle was compared: `{path}` ends at {end:.2} s ({damage})"),
                (None, Some(_)) => format!("no cycle was compared: `{path}` ends at {end:.2} s"),
                (None, None) => format!("no cycle was compared: `{path}` has none in the span"),
            };
            return Err(Invalid::new(what, help));
        }
        if whole.is_some_and(|period| options.until.is_finite() && options.until > end + period) {
            return Err(Invalid::new(
                format!("--until is after the end of the recording: `{path}` ends at {end:.2} s"),
                help,
            ));
        }
        Ok(())
    }
}
