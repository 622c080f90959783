//! Recording of a game.

use std::path::Path;

use bica::action::Action;
use bica::runner::{Cycle, Observer, Request};
use bica::visual::Scene;
use bica::{Probe, Refusal};
use bica_app::{Failure, RecordedFile};
use bica_field::GoalColour;
use bica_motion::robot::Sensors;
use bica_player::tunable::Forward;
use bica_recording::{Header, ImagePolicy, LogLine, LogSource, Program, Recorder, Report, SetUp, Split, Topics};
use bica_sim::SharedImage;
use bica_sim::referee::TimedEvent;
use serde::Serialize;

use crate::game::event;
use crate::game::meter::Meter;
use crate::game::rules::Rules;
use crate::game::scene::GRAPH;

/// Level of a note in the log of a recording: information.
const NOTE_LEVEL: u8 = 2;
/// Level of a fault: error.
const FAULT_LEVEL: u8 = 4;

/// File and content of a game's recording.
#[derive(Clone, Copy, Debug)]
pub struct RecordOptions<'a> {
    /// The file.
    pub path: &'a Path,
    /// Data stored for each cycle.
    pub images: ImagePolicy,
    /// Topics for other programs.
    pub topics: Topics,
    /// Limit at which the recording continues in another file.
    pub split: Option<Split>,
    /// Whether an existing file is replaced.
    pub force: bool,
}

/// Summary of a recording, for JSON.
#[derive(Clone, Debug, Serialize)]
pub struct RecordingSummary {
    /// The file.
    pub file: String,
    /// Number of parts of a split recording; `file` is the first part.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub parts: Option<u32>,
    /// Number of recorded cycles.
    pub recorded_cycles: u64,
    /// Number of images that were dropped because the disk was slow.
    pub dropped_images: u64,
    /// Why the recording ended before the game.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
    /// Length of the file, bytes; it depends on the speed of the computer.
    pub wall_bytes: u64,
    /// Text about the recording, one line.
    #[serde(skip)]
    pub(crate) text: String,
}

impl RecordingSummary {
    fn new(file: &RecordedFile, report: Report) -> Self {
        let text = file.describe(&report);
        let Report { cycles, bytes, dropped_images, reason, parts } = report;
        let file = file.path().display().to_string();
        Self { file, parts, recorded_cycles: cycles, dropped_images, reason, wall_bytes: bytes, text }
    }
}

/// Observer that records a game, if that is requested.
pub(crate) struct GameRecorder {
    recorder: Option<Recorder>,
    file: Option<RecordedFile>,
}

impl GameRecorder {
    /// Creates the file and writes its header.
    pub(crate) fn new(
        options: Option<RecordOptions<'_>>,
        rules: &Rules,
        attacks: GoalColour,
        (robot, actions): (&Forward, &'static [Action]),
        image: SharedImage,
        scenery: impl FnOnce(&mut dyn Scene),
    ) -> Result<Self, Failure> {
        let start = |RecordOptions { path, images, topics, split, force }: RecordOptions<'_>| {
            let header = recording_header(rules, attacks, images).with_actions(actions).with_scenery(scenery);
            let header = Header { topics, ..header }.of_robot(robot);
            let (file, recorder) = RecordedFile::start(path, force, split, &header, rules.realtime)?;
            Ok::<_, Failure>((file, recorder.sharing_blobs(move |pixels| image.owner_of(pixels))))
        };
        let (file, recorder) = options.map(start).transpose()?.unzip();
        Ok(Self { recorder, file })
    }

    /// Records an event of the referee.
    pub(crate) fn event(&self, event: &TimedEvent) {
        if let Some(recorder) = &self.recorder {
            recorder.event(event::recorded(event));
        }
    }

    /// Records a note that a person has entered.
    pub(crate) fn note(&self, text: &str) {
        if let Some(recorder) = &self.recorder {
            recorder.log(LogLine { level: NOTE_LEVEL, source: LogSource::Note, text: text.to_owned() });
        }
    }

    /// Records a fault of the robot or the world.
    pub(crate) fn fault(&self, text: &str) {
        if let Some(recorder) = &self.recorder {
            recorder.log(LogLine { level: FAULT_LEVEL, source: LogSource::Robot, text: text.to_owned() });
        }
    }

    /// Returns the reason if the recording ended before the game; only once.
    pub(crate) fn newly_ended(&self) -> Option<String> {
        self.file.as_ref().and_then(RecordedFile::newly_ended)
    }

    /// Records the measurements of the last cycle.
    pub(crate) fn measured(&mut self, meter: &Meter) {
        if let Some(recorder) = &mut self.recorder {
            recorder.measured(&meter.costs);
        }
    }

    /// Closes the file.
    pub(crate) fn finish(self, result: &str) -> Option<RecordingSummary> {
        let (recorder, file) = self.recorder.zip(self.file)?;
        Some(RecordingSummary::new(&file, recorder.finish(result)))
    }
}

/// Returns the header of a game's recording, without parameters and outputs.
#[must_use]
pub fn recording_header(rules: &Rules, attacks: GoalColour, images: ImagePolicy) -> Header {
    let world = if rules.firmware.is_some() { "firmware" } else { rules.world.name() };
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
    let mut set_up: SetUp = set_up.into_iter().map(|(name, value)| (name.to_owned(), value)).collect();
    if !rules.options.is_empty() {
        set_up.insert("options".to_owned(), rules.options.into());
    }
    Header { program: Program::bica(), ..Header::new(&GRAPH, set_up, images) }
}

impl Probe for GameRecorder {}

impl Observer<Forward> for GameRecorder {
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
