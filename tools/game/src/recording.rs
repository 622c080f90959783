//! Recording of a game.

use std::path::Path;
use std::sync::mpsc::{Receiver, Sender, channel};

use bica::action::Action;
use bica::runner::{Cycle, Observer, Request};
use bica::{Probe, Refusal};
use bica_app::Failure;
use bica_field::GoalColour;
use bica_motion::robot::Sensors;
use bica_player::tunable::Forward;
use bica_recording::{
    Backpressure, ComponentCosts, Costs, Header, ImagePolicy, LogLine, Recorder, RecorderOptions, Report, SetUp, create,
};
use bica_sim::SharedImage;
use bica_sim::referee::TimedEvent;
use serde::Serialize;

use crate::event;
use crate::meter::Meter;
use crate::rules::{Rules, WorldKind};
use crate::scene::GRAPH;

/// Number of cycles between two records of the components' costs.
const COSTS_EVERY: u64 = 100;

/// Level of a note in the log of a recording: information.
const NOTE_LEVEL: u8 = 2;

/// Where and how a game is recorded.
#[derive(Clone, Copy, Debug)]
pub struct RecordOptions<'a> {
    /// The file.
    pub path: &'a Path,
    /// What is stored of each cycle.
    pub images: ImagePolicy,
    /// Whether an existing file is replaced.
    pub force: bool,
}

/// Summary of a recording, for JSON.
#[derive(Clone, Debug, Serialize)]
pub struct RecordingSummary {
    /// The file.
    pub file: String,
    /// Number of recorded cycles.
    pub recorded_cycles: u64,
    /// Number of images that were dropped because the disk was slow.
    pub dropped_images: u64,
    /// Why the recording ended before the game.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
    /// Length of the file, bytes; it depends on the speed of the computer.
    pub wall_bytes: u64,
}

impl RecordingSummary {
    fn new(path: &Path, report: Report) -> Self {
        let Report { cycles, bytes, dropped_images, reason } = report;
        let file = path.display().to_string();
        Self { file, recorded_cycles: cycles, dropped_images, reason, wall_bytes: bytes }
    }

    /// Returns a line for people.
    pub(crate) fn describe(&self) -> String {
        let Self { file, recorded_cycles, dropped_images, reason, wall_bytes } = self;
        let size = *wall_bytes as f64 * 1e-6;
        let dropped = match dropped_images {
            0 => String::new(),
            count => format!("; {count} images dropped, the disk was too slow"),
        };
        let ended = reason.as_ref().map_or_else(String::new, |reason| format!("; it ended before the game: {reason}"));
        format!("{recorded_cycles} cycles, {size:.2} MB in {file}{dropped}{ended}")
    }
}

/// Observer that records a game, if that is requested.
pub(crate) struct GameRecorder<'a> {
    recorder: Option<Recorder>,
    path: Option<&'a Path>,
    /// Receives the reason if the recording ends before the game.
    ended: Receiver<String>,
    /// Runs and time of each component at the last record of costs.
    costs: Vec<ComponentCosts>,
    cycles: u64,
}

impl<'a> GameRecorder<'a> {
    /// Makes the file and writes its header.
    pub(crate) fn new(
        options: Option<RecordOptions<'a>>,
        rules: &Rules,
        attacks: GoalColour,
        (robot, actions): (&Forward, &[Action]),
        image: SharedImage,
    ) -> Result<Self, Failure> {
        let (sender, ended) = channel();
        let open = |options: RecordOptions<'a>| {
            let header = recording_header(rules, attacks, options.images).with_actions(actions).of_robot(robot);
            let recorder = open(&options, &header, rules, sender.clone())?;
            Ok::<_, Failure>(recorder.sharing_blobs(move |pixels| image.owner_of(pixels)))
        };
        let (path, recorder) = (options.map(|options| options.path), options.map(open).transpose()?);
        Ok(Self { recorder, path, ended, costs: vec![ComponentCosts::default(); GRAPH.nodes.len()], cycles: 0 })
    }

    /// Records an event of the referee.
    pub(crate) fn event(&self, event: &TimedEvent) {
        if let Some(recorder) = &self.recorder {
            recorder.event(event::recorded(event));
        }
    }

    /// Records a note of a person.
    pub(crate) fn note(&self, text: &str) {
        if let Some(recorder) = &self.recorder {
            recorder.log(LogLine { level: NOTE_LEVEL, text: format!("note: {text}") });
        }
    }

    /// Returns the reason once if the recording has ended before the game.
    pub(crate) fn newly_ended(&self) -> Option<String> {
        self.ended.try_recv().ok()
    }

    /// Records the costs of the components once a second.
    pub(crate) fn costs(&mut self, meter: &Meter) {
        let Some(recorder) = &self.recorder else { return };
        self.cycles += 1;
        if !self.cycles.is_multiple_of(COSTS_EVERY) {
            return;
        }
        let total = meter.activity.iter().map(|activity| (activity.runs as u32, activity.time.as_nanos() as u64));
        let since = |((runs, ns), last): ((u32, u64), &mut ComponentCosts)| {
            let since = ComponentCosts { runs: runs.wrapping_sub(last.runs), ns: ns - last.ns };
            *last = ComponentCosts { runs, ns };
            since
        };
        recorder.costs(Costs { components: total.zip(&mut self.costs).map(since).collect() });
    }

    /// Closes the file.
    pub(crate) fn finish(self, result: &str, fault: Option<&str>) -> Option<RecordingSummary> {
        let (recorder, path) = self.recorder.zip(self.path)?;
        if let Some(fault) = fault {
            recorder.log(LogLine { level: 4, text: format!("fault: {fault}") });
        }
        Some(RecordingSummary::new(path, recorder.finish(result)))
    }
}

fn open(
    options: &RecordOptions<'_>,
    header: &Header,
    rules: &Rules,
    ended: Sender<String>,
) -> Result<Recorder, Failure> {
    let RecordOptions { path, force, .. } = *options;
    let help = if path.exists() && !force {
        "--force replaces an existing file"
    } else {
        "name a file that can be made, or written to, with --record"
    };
    let file = create(path, force).map_err(|error| Failure::of_path("write", path, &error, help))?;
    // Without a clock nothing has to be lost.
    let backpressure = if rules.realtime { Backpressure::Drop } else { Backpressure::Wait };
    let on_end = move |reason: &str| {
        // The receiver is gone only when the game has ended.
        let _ = ended.send(reason.to_owned());
    };
    Recorder::start(file, header, RecorderOptions { backpressure, ..RecorderOptions::default() }, on_end)
        .map_err(|error| Failure::of_path("write", path, &error, "is the disk full?"))
}

/// Returns the header of a game's recording, without parameters and information.
#[must_use]
pub fn recording_header(rules: &Rules, attacks: GoalColour, images: ImagePolicy) -> Header {
    let world = match rules.world {
        _ if rules.firmware.is_some() => "firmware",
        WorldKind::BuiltIn => "built-in",
        #[cfg(feature = "mujoco")]
        WorldKind::Mujoco => "mujoco",
    };
    let (width, height) = rules.size.size();
    let attacks = match attacks {
        GoalColour::Yellow => "yellow",
        GoalColour::SkyBlue => "sky-blue",
    };
    let set_up = [
        ("attacks", attacks.into()),
        ("model", "nao".into()),
        ("profile", rules.world.profile_name().into()),
        ("robots", rules.robots.into()),
        ("seconds", rules.limit.as_secs_f64().into()),
        ("seed", rules.seed.into()),
        ("size", vec![width, height].into()),
        ("world", world.into()),
    ];
    let set_up: SetUp = set_up.into_iter().map(|(name, value)| (name.to_owned(), value)).collect();
    Header::new(&GRAPH, set_up, images)
}

impl Probe for GameRecorder<'_> {}

impl Observer<Forward> for GameRecorder<'_> {
    fn requested(&mut self, now: bica::Instant, request: &Request<'_>) {
        Observer::<Forward>::requested(&mut self.recorder, now, request);
    }

    fn refused(&mut self, now: bica::Instant, request: &Request<'_>, refusal: &Refusal) {
        Observer::<Forward>::refused(&mut self.recorder, now, request, refusal);
    }

    fn sensing(&mut self, now: bica::Instant, sensors: &Sensors<'_>) {
        Observer::<Forward>::sensing(&mut self.recorder, now, sensors);
    }

    fn acted(&mut self, cycle: &Cycle<'_, Forward>) {
        self.recorder.acted(cycle);
    }
}
