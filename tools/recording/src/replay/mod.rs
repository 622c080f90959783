//! Replay of a recording: the code runs again on the recorded data.

mod compared;
mod rerun;
mod run;
mod subject;

use std::fmt::Display;
use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use bica::runner::Robot;
use bica_wire::Recordable;
use bica_wire::model::Invalid;
use serde::Serialize;

use crate::compare::{Comparison, Decision, Difference};
use crate::header::{Header, ImagePolicy};
use crate::program::Program;
use crate::recording::Recording;
use compared::Compared;
pub use rerun::rerun;
use run::{Other, Repeated, Run};
pub(crate) use subject::check_tree;
pub use subject::{RepeatedWorld, Subject};

/// Options of a replay.
#[derive(Clone, Copy, Debug)]
pub struct ReplayOptions<'a> {
    /// The recording.
    pub path: &'a Path,
    /// Time since the first cycle from which on cycles are compared, s.
    pub from: f64,
    /// Time since the first cycle up to which the run is repeated, s.
    pub until: f64,
    /// Recording to compare with, instead of running the code.
    pub against: Option<&'a Path>,
    /// Parameters `Component.name=value` that replace those of the recording.
    pub set: &'a [String],
    /// Whether the simulated world runs again, even if the recording has sensor values.
    pub closed_loop: bool,
}

impl<'a> ReplayOptions<'a> {
    /// Returns options for the code on a whole recording, with the recorded parameters.
    #[must_use]
    pub const fn whole(path: &'a Path) -> Self {
        Self { path, from: 0.0, until: f64::INFINITY, against: None, set: &[], closed_loop: false }
    }
}

/// Result of a replay.
#[derive(Clone, Debug, Serialize)]
pub struct ReplayReport {
    /// The recording.
    pub file: String,
    /// Source of the repeated run: `stored` sensor values, `rules` of the simulated world, or another `recording`.
    pub source: &'static str,
    /// `open`: the inputs are those of the recorded run, whatever the code decides; `closed`: the world runs again. None if two
    /// recordings are compared.
    #[serde(rename = "loop")]
    pub feedback: Option<&'static str>,
    /// Whether the recording is of a simulated world, which can run again.
    pub simulated: bool,
    /// Whether the same build wrote the recording.
    pub same_build: bool,
    /// Kinds of the [processors](crate::processor()) of the recorded and the repeated run, if they differ.
    pub processors: Option<[String; 2]>,
    /// Parameters that are not those of the recording.
    pub set: Vec<String>,
    /// Whether all cycles before the first gap were equal, bit for bit.
    pub equal: bool,
    /// Number of compared cycles before the first gap.
    pub cycles: u64,
    /// Time of the last cycle since the first one, s.
    pub seconds: f64,
    /// Damage of the file; none if it is complete.
    pub damage: Option<String>,
    /// The first difference.
    pub first_difference: Option<Difference>,
    /// The first 1000 decisions that differ.
    pub decisions: Vec<Decision>,
    /// Number of all decisions that differ.
    pub total_decisions: u64,
    /// Cycles whose images were dropped while recording.
    pub gaps: Vec<u64>,
    /// Comparison after the first gap.
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
/// `subject` makes the robot with the parameters of the header, replaced by those of [`ReplayOptions::set`]. If its second
/// argument is true, it also makes the world. It is not called if two recordings are compared. `progress` is called repeatedly
/// with the number of bytes that were read; if it returns false, the replay ends there.
///
/// # Errors
/// If a file cannot be read, or the recording cannot be replayed by this program.
pub fn replay<R>(
    options: &ReplayOptions<'_>,
    subject: impl FnOnce(&Header, bool) -> Result<Subject<R>, Invalid>,
    mut progress: impl FnMut(u64) -> bool,
) -> Result<ReplayReport, Invalid>
where
    R: Recordable + 'static,
    <R as Robot>::Error: Display,
{
    let recording = open(options.path)?;
    if let Some(path) = options.against {
        let mut other = Other::open(path, recording.header())?;
        return report(options, recording, &mut other, ("recording", None), &mut progress);
    }
    check_start(options.path, recording.header())?;
    let is_stored = recording.header().images == ImagePolicy::All && !options.closed_loop;
    let subject = subject::checked(recording.header(), !is_stored, subject)?;
    let differs = !options.set.is_empty() || !is_stored;
    let source = if is_stored { ("stored", Some("open")) } else { ("rules", Some("closed")) };
    report(options, recording, &mut Repeated::new(subject, differs), source, &mut progress)
}

/// Compares two recordings of one tree.
///
/// # Errors
/// If a file cannot be read, or they are of different trees.
pub fn compare(one: &Path, other: &Path) -> Result<ReplayReport, Invalid> {
    let recording = open(one)?;
    let mut run = Other::open(other, recording.header())?;
    let options = ReplayOptions { against: Some(other), ..ReplayOptions::whole(one) };
    report(&options, recording, &mut run, ("recording", None), &mut |_| true)
}

/// Compares a recording with a run.
fn report(
    options: &ReplayOptions<'_>,
    mut recording: FileRecording,
    other: &mut dyn Run,
    (source, feedback): (&'static str, Option<&'static str>),
    progress: &mut dyn FnMut(u64) -> bool,
) -> Result<ReplayReport, Invalid> {
    let header = recording.header().clone();
    let mut compared = Compared {
        detects_gaps: source == "stored",
        before: Comparison::new(&header),
        after: Comparison::new(&header),
        gaps: Vec::new(),
        seconds: 0.0,
    };
    let program = other.program().unwrap_or_else(Program::bica);
    let damage = compared.compare(options, &mut recording, other, progress)?;
    let Compared { before, after, gaps, seconds, .. } = compared;
    let after_gap =
        AfterGap { cycles: after.cycles, first_difference: after.first, total_decisions: after.total_decisions };
    Ok(ReplayReport {
        file: options.path.display().to_string(),
        source,
        feedback,
        simulated: header.is_simulated(),
        same_build: options.against.is_none() && program.is_same_build(&header.program),
        processors: header.program.other_processor(&program),
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

/// Opens a recording of a run. A recording of a monitor is refused, because it cannot be repeated or compared.
fn open(path: &Path) -> Result<FileRecording, Invalid> {
    let recording = FileRecording::open(path).map_err(|error| error.of(path))?;
    let Some(monitor) = &recording.header().monitor else { return Ok(recording) };
    let (path, address) = (path.display(), &monitor.address);
    let what = format!(
        "`{path}` holds what a monitor received from `{address}`, without sensor values and commands: it can be looked at, \
         not run again or compared"
    );
    Err(Invalid::new(what, "record where the robot runs, with `--serve ADDR --record FILE`"))
}

/// Refuses to run a part again that is not the first one of its run.
fn check_start(path: &Path, header: &Header) -> Result<(), Invalid> {
    header.part.as_ref().map_or(Ok(()), |part| part.check_first(path))
}
