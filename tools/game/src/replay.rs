//! Replay of a recording: the code runs again on what was recorded.

mod rerun;
mod run;
mod set_up;
mod world;

use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use bica_console::{Failure, interrupt};
use bica_recording::{Comparison, Decision, Difference, Error, ImagePolicy, Program, RecordedCycle, Recording};
use indicatif::ProgressBar;
use serde::Serialize;

use run::{Other, Repeated, Run, is_gap};
use set_up::check_tree;

pub use rerun::rerun;

/// Number of bytes after which the progress bar moves.
const PROGRESS_STEP: u64 = 1 << 16;

/// What is replayed.
#[derive(Clone, Copy, Debug)]
pub struct ReplayOptions<'a> {
    /// The recording.
    pub path: &'a Path,
    /// Time from which on cycles are compared, s.
    pub from: f64,
    /// Time up to which the run is repeated, s.
    pub until: f64,
    /// Recording to compare with, instead of running the code.
    pub against: Option<&'a Path>,
    /// Parameters `Component.name=value` that are not those of the recording.
    pub set: &'a [String],
    /// Whether the simulated world runs again, also if the recording has images.
    pub closed_loop: bool,
}

impl<'a> ReplayOptions<'a> {
    /// The code on a whole recording, with the recorded parameters.
    #[must_use]
    pub const fn whole(path: &'a Path) -> Self {
        Self { path, from: 0.0, until: f64::INFINITY, against: None, set: &[], closed_loop: false }
    }
}

/// Result of a replay.
#[derive(Clone, Debug, Serialize)]
pub struct Replayed {
    /// The recording.
    pub file: String,
    /// Source of the repeated run: `stored` sensor values and images, `rules` of the game, or another `recording`.
    pub source: &'static str,
    /// `open`: the inputs are those of the recorded run, whatever the code decides; `closed`: the world runs again. None if two
    /// recordings are compared.
    #[serde(rename = "loop")]
    pub feedback: Option<&'static str>,
    /// Whether the recording is of a simulated world, which can run again.
    pub simulated: bool,
    /// Whether the same build wrote the recording.
    pub same_build: bool,
    /// Parameters that are not those of the recording.
    pub set: Vec<String>,
    /// Whether all cycles before the first gap were equal, bit for bit.
    pub equal: bool,
    /// Number of compared cycles before the first gap.
    pub cycles: u64,
    /// Time of the last cycle, s.
    pub seconds: f64,
    /// What is wrong with the file; none if it is complete.
    pub damage: Option<String>,
    /// The first difference.
    pub first_difference: Option<Difference>,
    /// The first 1000 decisions that differ.
    pub decisions: Vec<Decision>,
    /// Number of all decisions that differ.
    pub total_decisions: u64,
    /// Cycles whose images were dropped while recording.
    pub gaps: Vec<u64>,
    /// What follows the first gap.
    pub after_gap: Option<AfterGap>,
}

/// Comparison of the cycles from the first gap on: a difference may be due to the missing image.
#[derive(Clone, Debug, Serialize)]
pub struct AfterGap {
    /// Number of cycles.
    pub cycles: u64,
    /// The first difference.
    pub first_difference: Option<Difference>,
    /// Number of decisions that differ.
    pub total_decisions: u64,
}

type FileRecording = Recording<BufReader<File>>;

/// Runs the code again on a recording, or compares two recordings.
///
/// # Errors
/// If a file cannot be read, or the recording cannot be replayed by this program.
pub fn replay(options: &ReplayOptions<'_>) -> Result<Replayed, Failure> {
    let mut recording = open(options.path)?;
    let header = recording.header().clone();
    let is_stored = header.images == ImagePolicy::All && !options.closed_loop;
    let (mut other, source, feedback): (Box<dyn Run>, _, _) = if let Some(path) = options.against {
        (Box::new(Other::open(path, &header)?), "recording", None)
    } else {
        check_tree(&header)?;
        let (source, feedback) = if is_stored { ("stored", "open") } else { ("rules", "closed") };
        (Box::new(Repeated::new(&header, options.set, options.closed_loop)?), source, Some(feedback))
    };
    let mut compared = Compared {
        detects_gaps: source == "stored",
        before: Comparison::new(header.tree.clone()),
        after: Comparison::new(header.tree),
        gaps: Vec::new(),
        seconds: 0.0,
    };
    let damage = compared.compare(options, &mut recording, &mut *other)?;
    let Compared { before, after, gaps, seconds, .. } = compared;
    let after_gap =
        AfterGap { cycles: after.cycles, first_difference: after.first, total_decisions: after.total_decisions };
    Ok(Replayed {
        file: options.path.display().to_string(),
        source,
        feedback,
        simulated: header.rules.is_some(),
        same_build: options.against.is_none() && Program::current().is_same_build(&header.program),
        set: options.set.to_vec(),
        equal: before.is_equal(),
        cycles: before.cycles,
        seconds,
        damage,
        first_difference: before.first,
        decisions: before.decisions,
        total_decisions: before.total_decisions,
        after_gap: (!gaps.is_empty()).then_some(after_gap),
        gaps,
    })
}

/// Opens a recording of a run. What a monitor recorded cannot be repeated or compared.
fn open(path: &Path) -> Result<FileRecording, Failure> {
    let recording = FileRecording::open(path).map_err(|error| failure(path, &error))?;
    let Some(monitor) = &recording.header().monitor else { return Ok(recording) };
    let (path, address) = (path.display(), &monitor.address);
    let what = format!(
        "`{path}` holds what a monitor received from `{address}`, without sensor values and commands: it can be looked at, \
         not run again or compared"
    );
    Err(Failure::new(what, "record where the robot runs: `player play --serve ADDRESS --record FILE`"))
}

fn failure(path: &Path, error: &Error) -> Failure {
    Failure::of_path("read", path, error, error.help())
}

/// Comparison of a recording, before and after its first gap.
struct Compared {
    /// Whether a cycle without its image is a gap.
    detects_gaps: bool,
    before: Comparison,
    after: Comparison,
    gaps: Vec<u64>,
    /// Time of the last cycle, s.
    seconds: f64,
}

impl Compared {
    /// Compares cycle by cycle; returns what is wrong with the file.
    fn compare(
        &mut self,
        options: &ReplayOptions<'_>,
        recording: &mut FileRecording,
        other: &mut dyn Run,
    ) -> Result<Option<String>, Failure> {
        let bar = ProgressBar::new(std::fs::metadata(options.path).map_or(0, |data| data.len()));
        let tick_hz = recording.header().tree.tick_hz.max(1) as f64;
        let (mut cycle, mut is_whole) = (0, false);
        let damage = loop {
            if interrupt::requested() {
                return Ok(Some("stopped by Ctrl-C".to_owned()));
            }
            let recorded = match recording.next_cycle() {
                Ok(Some(recorded)) => recorded,
                Ok(None) => {
                    is_whole = true;
                    break None;
                }
                Err(error @ (Error::CutOff { .. } | Error::Damaged { .. })) => break Some(error),
                Err(error) => return Err(failure(options.path, &error)),
            };
            let t = recorded.tick.instant as f64 / tick_hz;
            if t > options.until {
                break None;
            }
            (self.seconds, cycle) = (t, recorded.tick.cycle);
            if recording.position() >= bar.position() + PROGRESS_STEP {
                bar.set_position(recording.position());
            }
            let repeated = other.next(&recorded)?;
            if self.detects_gaps && is_gap(&recorded) {
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
        bar.finish_and_clear();
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
        // It depends on all cycles before.
        repeated.tick.fingerprint = recorded.tick.fingerprint;
        self.after.add(recorded, &repeated);
    }

    /// Refuses a span that has no cycle, or, in a whole recording with a time between cycles, s, one that goes beyond its end.
    fn check_span(
        &self,
        options: &ReplayOptions<'_>,
        damage: Option<&Error>,
        whole: Option<f64>,
    ) -> Result<(), Failure> {
        let (path, end) = (options.path.display(), self.seconds);
        let help = "give a span within the recording with --from and --until; `player record info FILE` shows it";
        if self.before.cycles + self.after.cycles == 0 && self.before.is_equal() {
            let what = match (damage, whole) {
                (Some(damage), _) if options.from <= end => {
                    let what = format!("no cycle was compared: `{path}` has none before its damage: {damage}");
                    return Err(Failure::new(what, damage.help()));
                }
                (Some(damage), _) => format!("no cycle was compared: `{path}` ends at {end:.2} s ({damage})"),
                (None, Some(_)) => format!("no cycle was compared: `{path}` ends at {end:.2} s"),
                (None, None) => format!("no cycle was compared: `{path}` has none in the span"),
            };
            return Err(Failure::new(what, help));
        }
        if whole.is_some_and(|period| options.until.is_finite() && options.until > end + period) {
            return Err(Failure::new(
                format!("--until is after the end of the recording: `{path}` ends at {end:.2} s"),
                help,
            ));
        }
        Ok(())
    }
}
