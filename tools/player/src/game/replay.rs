//! Replay of a game: the forward, and the world created again from the rules.

use std::path::Path;
use std::time::Duration;

use bica::action::Actions;
use bica::runner::World;
use bica::{Instant, Tree};
use bica_app::{Failure, Progress, interrupt};
use bica_field::GoalColour;
use bica_motion::model::simulation::NAO;
use bica_motion::robot::{Command, Sensors};
use bica_player::input::RobotProfile;
use bica_player::perception::GoalDetector;
use bica_player::tunable::Forward;
use bica_recording::{Header, RepeatedWorld, ReplayOptions, ReplayReport, Report, RunEvent, SetUp, Subject};
use bica_sim::SpectatorView;
use bica_sim::setup::Frame;
use bica_tuning::Layers;
use bica_wire::model::Invalid;
use serde::de::DeserializeOwned;

use crate::game::rules::{Rules, WorldKind};
use crate::game::scene::GRAPH;
use crate::game::world_factory;

/// Runs the code again on a recording, or compares two recordings.
///
/// # Errors
/// If a file cannot be read, or the recording cannot be replayed by this program.
pub fn replay(options: &ReplayOptions<'_>) -> Result<ReplayReport, Failure> {
    let bar = Progress::new(std::fs::metadata(options.path).map_or(0, |data| data.len()));
    let progress = |position| {
        bar.show(position, "");
        !interrupt::requested()
    };
    let subject = |header: &Header, runs_world| subject(header, options.set, runs_world);
    Ok(bica_recording::replay(options, subject, progress)?)
}

/// Runs the code again on a recording, with other parameters, and records the new run with images. `progress` is called
/// periodically with the time of the last cycle, s; the run ends if it returns false.
///
/// # Errors
/// If a file cannot be read or written, or the recording cannot be replayed by this program.
pub fn rerun(
    path: &Path,
    set: &[String],
    out: &Path,
    mut progress: impl FnMut(f64) -> bool,
) -> Result<Report, Invalid> {
    let subject = |header: &Header, runs_world| subject(header, set, runs_world);
    let progress = |seconds| !interrupt::requested() && progress(seconds);
    bica_recording::rerun(path, out, subject, progress)
}

/// Returns the forward as it was at the start of a recorded game, with other parameters, and its world if that runs again.
fn subject(header: &Header, set: &[String], runs_world: bool) -> Result<Subject<Forward>, Invalid> {
    let unknown = |what: &str| {
        Invalid::new(format!("the recording has an unknown {what}"), "replay it with the program that recorded it")
    };
    let text = |name| header.set_up.get(name).and_then(|value| value.as_str()).unwrap_or_default();
    let profile = match text("profile") {
        "kinematic" => NAO.kinematic_profile,
        "dynamic" => NAO.dynamic_profile,
        _ => return Err(unknown("motion profile")),
    };
    let attacks = match text("attacks") {
        "yellow" => GoalColour::Yellow,
        "sky-blue" => GoalColour::SkyBlue,
        _ => return Err(unknown("goal colour")),
    };
    let mut robot = Box::new(Forward::new());
    robot.get_mut::<RobotProfile>().set(profile);
    robot.get_mut::<GoalDetector>().attack(attacks);
    layers(header, set)?.apply(&mut *robot)?;
    let world = |()| -> Result<Box<dyn RepeatedWorld<Forward>>, Invalid> {
        let world = world_factory::open(&rules_of(&header.set_up)?)?;
        Ok(Box::new(Field { world, events: 0 }))
    };
    Ok(Subject { robot, world: runs_world.then_some(()).map(world).transpose()? })
}

/// Returns the parameters of a recording, overridden by the assignments of the command line.
fn layers(header: &Header, set: &[String]) -> Result<Layers, Invalid> {
    let mut layers = Layers::new(&GRAPH);
    header.assignments().try_for_each(|assignment| layers.assign(&assignment, "the recording"))?;
    set.iter().try_for_each(|assignment| layers.assign(assignment, "--set"))?;
    Ok(layers)
}

fn rules_of(set_up: &SetUp) -> Result<Rules, Invalid> {
    let world: String = value(set_up, "world")?;
    let world = match world.as_str() {
        "built-in" | "firmware" => WorldKind::BuiltIn,
        #[cfg(feature = "mujoco")]
        "mujoco" => WorldKind::Mujoco,
        other => {
            let what = format!("the game was played in the world `{other}`, which this program does not have");
            let help = "for MuJoCo build with `--features mujoco`; recordings with images need no world";
            return Err(Invalid::new(what, help));
        }
    };
    let [width, height]: [usize; 2] = value(set_up, "size")?;
    let unknown =
        || Invalid::new(format!("the recording has images of {width}x{height}"), "known are 160x120, 320x240, 640x480");
    // Recordings from before the introduction of options have none.
    let options: Vec<String> = if set_up.contains_key("options") { value(set_up, "options")? } else { Vec::new() };
    Ok(Rules {
        world,
        seed: value(set_up, "seed")?,
        size: Frame::of_size(width, height).ok_or_else(unknown)?,
        robots: value(set_up, "robots")?,
        limit: Duration::try_from_secs_f64(value(set_up, "seconds")?).unwrap_or(Duration::MAX),
        realtime: false,
        firmware: None,
        settings: &[],
        options: options.leak(),
    })
}

fn value<T: DeserializeOwned>(set_up: &SetUp, name: &str) -> Result<T, Invalid> {
    let value = set_up.get(name).and_then(|value| serde_json::from_value(value.clone()).ok());
    value.ok_or_else(|| {
        let what = format!("the set-up in the recording has no valid `{name}`");
        Invalid::new(what, "replay it with the program that recorded it")
    })
}

/// World of a game that is simulated again.
struct Field {
    world: Box<dyn SpectatorView>,
    /// Number of events that have been taken.
    events: usize,
}

impl World<Forward> for Field {
    fn now(&self) -> Instant {
        World::<Forward>::now(&self.world)
    }

    fn sensors(&mut self) -> Sensors<'_> {
        World::<Forward>::sensors(&mut self.world)
    }

    fn act(&mut self, command: &Command) {
        World::<Forward>::act(&mut self.world, command);
    }

    fn actions(&mut self) -> Option<&mut dyn Actions> {
        World::<Forward>::actions(&mut self.world)
    }
}

impl RepeatedWorld<Forward> for Field {
    fn take_events(&mut self) -> Vec<RunEvent> {
        let events = &self.world.referee().events()[self.events..];
        self.events += events.len();
        events.iter().map(crate::game::event::recorded).collect()
    }
}
