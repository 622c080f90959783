//! Replay of a recording: the code runs again on what was recorded.

mod rerun;
mod world;

use std::fs::File;
use std::io::BufReader;
use std::path::Path;
use std::time::Duration;

use bica::runner::{Cycle, Observer, OwnedRequest, RequestQueue, Robot, Runner};
use bica::{Instant, Probe};
use bica_console::{Failure, interrupt};
use bica_field::GoalColour;
use bica_motion::model::{Nao, Profile, RobotModel};
use bica_motion::robot::{self, CameraId};
use bica_player::input::RobotProfile;
use bica_player::perception::GoalDetector;
use bica_player::tunable::Forward;
use bica_recording::{
    Comparison, Decision, Difference, Error, Header, ImagePolicy, Parameter, Program, RecordedCycle, RecordedRules,
    Recording, RequestRecord, RunningFingerprint, TreeInfo, command_digest, image_digest, sensors_digest, tree_record,
};
use bica_sim::setup::Frame;
use bica_tuning::Layers;
use bica_wire::message::{Command as CommandMessage, Sensors as SensorsMessage};
use indicatif::ProgressBar;
use serde::Serialize;

use crate::rules::{Rules, WorldKind};
use crate::scene::GRAPH;
use crate::world_factory;
use world::ReplayWorld;

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
}

/// Result of a replay.
#[derive(Clone, Debug, Serialize)]
pub struct Replayed {
    /// The recording.
    pub file: String,
    /// Source of the repeated run: `stored` sensor values and images, `rules` of the game, or another `recording`.
    pub source: &'static str,
    /// Whether the same build wrote the recording.
    pub same_build: bool,
    /// Parameters that are not those of the recording.
    pub set: Vec<String>,
    /// Whether all compared cycles were equal, bit for bit.
    pub equal: bool,
    /// Number of compared cycles.
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
}

type FileRecording = Recording<BufReader<File>>;

/// Runs the code again on a recording, or compares two recordings.
///
/// # Errors
/// If a file cannot be read, or the recording cannot be replayed by this program.
pub fn replay(options: &ReplayOptions<'_>) -> Result<Replayed, Failure> {
    let mut recording = open(options.path)?;
    let header = recording.header().clone();
    let (mut other, source): (Box<dyn Run>, _) = if let Some(path) = options.against {
        (Box::new(Other::open(path, &header)?), "recording")
    } else {
        check_tree(&header)?;
        let source = if header.images == ImagePolicy::All { "stored" } else { "rules" };
        (Box::new(Repeated::new(&header, options.set)?), source)
    };
    let mut comparison = Comparison::new(header.tree.clone());
    let (seconds, damage) = compare(options, &mut recording, &mut *other, &mut comparison)?;
    Ok(Replayed {
        file: options.path.display().to_string(),
        source,
        same_build: options.against.is_none() && Program::current().is_same_build(&header.program),
        set: options.set.to_vec(),
        equal: comparison.is_equal(),
        cycles: comparison.cycles,
        seconds,
        damage,
        first_difference: comparison.first,
        decisions: comparison.decisions,
        total_decisions: comparison.total_decisions,
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

/// Compares cycle by cycle; returns the time of the last cycle and what is wrong with the file.
fn compare(
    options: &ReplayOptions<'_>,
    recording: &mut FileRecording,
    other: &mut dyn Run,
    comparison: &mut Comparison,
) -> Result<(f64, Option<String>), Failure> {
    let bar = ProgressBar::new(std::fs::metadata(options.path).map_or(0, |data| data.len()));
    let tick_hz = recording.header().tree.tick_hz.max(1) as f64;
    let (mut seconds, mut cycle) = (0.0, 0);
    let damage = loop {
        if interrupt::requested() {
            break Some("stopped by Ctrl-C".to_owned());
        }
        let recorded = match recording.next_cycle() {
            Ok(Some(recorded)) => recorded,
            Ok(None) => break None,
            Err(error @ (Error::CutOff { .. } | Error::Damaged { .. })) => break Some(error.to_string()),
            Err(error) => return Err(failure(options.path, &error)),
        };
        let t = recorded.tick.instant as f64 / tick_hz;
        if t > options.until {
            return Ok((seconds, None));
        }
        (seconds, cycle) = (t, recorded.tick.cycle);
        if recording.position() >= bar.position() + PROGRESS_STEP {
            bar.set_position(recording.position());
        }
        let repeated = other.next(&recorded)?;
        if t >= options.from {
            let Some(repeated) = repeated else {
                comparison.end(cycle, t, true);
                return Ok((seconds, None));
            };
            comparison.add(&recorded, &repeated);
        }
    };
    bar.finish_and_clear();
    if damage.is_none() && other.goes_on()? {
        comparison.end(cycle + 1, seconds, false);
    }
    Ok((seconds, damage))
}

/// The run that a recording is compared with.
trait Run {
    /// Returns the cycle that corresponds to a recorded one; none after the last.
    fn next(&mut self, recorded: &RecordedCycle) -> Result<Option<RecordedCycle>, Failure>;

    /// Returns whether there are cycles beyond those of the recording.
    fn goes_on(&mut self) -> Result<bool, Failure> {
        Ok(false)
    }
}

/// Another recording.
struct Other<'a> {
    path: &'a Path,
    recording: FileRecording,
}

impl<'a> Other<'a> {
    fn open(path: &'a Path, header: &Header) -> Result<Self, Failure> {
        let recording = open(path)?;
        if recording.header().tree.components != header.tree.components {
            let what = format!("`{}` is a recording of another tree", path.display());
            return Err(Failure::new(what, "compare recordings of one tree"));
        }
        Ok(Self { path, recording })
    }
}

impl Run for Other<'_> {
    fn next(&mut self, _recorded: &RecordedCycle) -> Result<Option<RecordedCycle>, Failure> {
        self.recording.next_cycle().map_err(|error| failure(self.path, &error))
    }

    fn goes_on(&mut self) -> Result<bool, Failure> {
        Ok(self.next(&RecordedCycle::default())?.is_some())
    }
}

/// The forward of this program.
struct Repeated {
    runner: Runner<Box<Forward>, ReplayWorld, RequestQueue, Taken>,
    fingerprint: RunningFingerprint,
    cycle: u64,
}

impl Repeated {
    fn new(header: &Header, set: &[String]) -> Result<Self, Failure> {
        let (world, profile, attacks) = set_up(header)?;
        let mut robot = Box::new(Forward::new());
        bica::Tree::get_mut::<RobotProfile>(&mut *robot).set(profile);
        bica::Tree::get_mut::<GoalDetector>(&mut *robot).attack(attacks);
        layers(header, set)?.apply(&mut *robot)?;
        let runner = Runner::new(robot, world).with_requests(RequestQueue::new()).with_observer(Taken::default());
        Ok(Self { runner, fingerprint: RunningFingerprint::default(), cycle: 0 })
    }
}

impl Run for Repeated {
    fn next(&mut self, recorded: &RecordedCycle) -> Result<Option<RecordedCycle>, Failure> {
        if self.cycle == 0 && recorded.tick.cycle > 0 {
            let what = format!("the recording begins with cycle {}", recorded.tick.cycle);
            return Err(Failure::new(what, "a replay needs the start of the run: give the file that was trimmed"));
        }
        let mut requests = Vec::with_capacity(recorded.requests.len());
        for request in &recorded.requests {
            match *request {
                // A placement that the repeated world refuses is a difference.
                RequestRecord::Ball { x, y } if self.runner.world_mut().place_ball([x, y]).is_err() => continue,
                RequestRecord::Ball { .. } => {}
                _ => self.runner.requests_mut().push(request_of(request)?),
            }
            self.fingerprint.add_request(request);
            requests.push(request.clone());
        }
        if let ReplayWorld::Stored(cycle) = self.runner.world_mut() {
            if recorded.sensors.is_some_and(|sensors| sensors.image.is_some()) && recorded.image.is_none() {
                let what = format!("the image of cycle {} was dropped while recording", recorded.tick.cycle);
                return Err(Failure::new(what, "replay the time before it with --until"));
            }
            (**cycle).clone_from(recorded);
        }
        self.runner.cycle().map_err(|error| Failure::new(error.to_string(), "record with a smaller --size"))?;
        let mut repeated = std::mem::take(&mut self.runner.observer_mut().0);
        repeated.tick.cycle = self.cycle;
        repeated.requests = requests;
        repeated.tick.fingerprint = self.fingerprint.add_tick(&repeated.tick);
        self.cycle += 1;
        Ok(Some(repeated))
    }
}

/// Returns the parameters of a recording, and over them the assignments of the command line.
fn layers(header: &Header, set: &[String]) -> Result<Layers, Failure> {
    let mut layers = Layers::new(&GRAPH);
    for Parameter { component, name, value, .. } in &header.parameters {
        layers.assign(&format!("{component}.{name}={value}"), "the recording")?;
    }
    for assignment in set {
        layers.assign(assignment, "--set")?;
    }
    Ok(layers)
}

fn request_of(request: &RequestRecord) -> Result<OwnedRequest, Failure> {
    request.to_request().ok_or_else(|| {
        let what = format!("the recording has a request that this program does not know: {request:?}");
        Failure::new(what, "replay it with the program that recorded it")
    })
}

/// Checks that the recording is of this program's tree.
fn check_tree(header: &Header) -> Result<(), Failure> {
    let own = TreeInfo::new(&GRAPH);
    if own.hash == header.tree.hash && own.tick_hz == header.tree.tick_hz {
        return Ok(());
    }
    let names = |tree: &TreeInfo| tree.components.iter().map(|one| one.name.clone()).collect::<Vec<_>>();
    let (recorded, present) = (names(&header.tree), names(&own));
    let only = |one: &[String], two: &[String]| {
        one.iter().filter(|name| !two.contains(name)).cloned().collect::<Vec<_>>().join(", ")
    };
    let (gone, new) = (only(&recorded, &present), only(&present, &recorded));
    let what = match (gone.as_str(), new.as_str()) {
        ("", "") => "rates, links, states or transitions differ".to_owned(),
        (gone, new) => format!("components only in the recording: [{gone}], only in this program: [{new}]"),
    };
    let help = "`player record info FILE` shows the commit that recorded it; build that to replay it";
    Err(Failure::new(format!("the recording is of another activation tree, so it is not run again: {what}"), help))
}

/// Returns world, motion profile and attacked goal of a recording.
fn set_up(header: &Header) -> Result<(ReplayWorld, &'static Profile, GoalColour), Failure> {
    let unknown = |what: &str| {
        Failure::new(format!("the recording has an unknown {what}"), "replay it with the program that recorded it")
    };
    let profile = match header.robot.profile.as_str() {
        "kinematic" => Nao::KINEMATIC_PROFILE,
        "dynamic" => Nao::DYNAMIC_PROFILE,
        _ => return Err(unknown("motion profile")),
    };
    let attacks = match header.robot.attacks.as_str() {
        "yellow" => GoalColour::Yellow,
        "sky-blue" => GoalColour::SkyBlue,
        _ => return Err(unknown("goal colour")),
    };
    let world = match header.images {
        ImagePolicy::All => ReplayWorld::Stored(Box::default()),
        ImagePolicy::None => {
            let rules = header.rules.as_ref().ok_or_else(|| unknown("world, and no images"))?;
            ReplayWorld::Simulated(world_factory::open(&rules_of(rules)?)?)
        }
    };
    Ok((world, profile, attacks))
}

fn rules_of(rules: &RecordedRules) -> Result<Rules, Failure> {
    let world = match rules.world.as_str() {
        "built-in" | "firmware" => WorldKind::BuiltIn,
        #[cfg(feature = "mujoco")]
        "mujoco" => WorldKind::Mujoco,
        other => {
            let what = format!("the game was played in the world `{other}`, which this program does not have");
            return Err(Failure::new(
                what,
                "for MuJoCo build with `--features mujoco`; recordings with images need no world",
            ));
        }
    };
    let [width, height] = rules.size;
    let unknown =
        || Failure::new(format!("the recording has images of {width}x{height}"), "known are 160x120, 320x240, 640x480");
    let limit = Duration::try_from_secs_f64(rules.seconds).unwrap_or(Duration::MAX);
    let size = Frame::of_size(width, height).ok_or_else(unknown)?;
    Ok(Rules {
        world,
        seed: rules.seed,
        size,
        robots: rules.robots,
        limit,
        realtime: false,
        firmware: None,
        settings: &[],
    })
}

/// Observer that keeps the cycle as it would have been recorded.
#[derive(Default)]
struct Taken(RecordedCycle);

impl Probe for Taken {}

impl Observer<Forward> for Taken {
    fn sensing(&mut self, now: Instant, sensors: &<Forward as Robot>::Sensors<'_>) {
        let message = SensorsMessage::new(now.as_micros(), sensors, 0);
        self.0.tick.sensors = sensors_digest(&message);
        self.0.tick.image = sensors.image.map_or(0, |robot::Image { camera, width, height, yuyv }| {
            image_digest(camera == CameraId::Bottom, width, height, yuyv)
        });
        self.0.sensors = Some(message);
    }

    fn acted(&mut self, cycle: &Cycle<'_, Forward>) {
        let command = CommandMessage::new(cycle.now.as_micros(), cycle.command);
        self.0.tick.instant = cycle.now.as_ticks();
        self.0.tick.command = command_digest(&command);
        self.0.tree = tree_record(cycle.robot);
        self.0.tick.tree = self.0.tree.digest();
        self.0.command = Some(command);
    }
}
