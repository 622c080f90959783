//! Robot and world of a replay.

use std::fmt;
#[cfg(feature = "monitor")]
use std::path::Path;

use bica::runner::Robot;
use bica_recording::{Header, Recordable, RepeatedWorld, ReplayOptions, ReplayReport, Subject};
use bica_tuning::Layers;
use bica_wire::model::Invalid;

use crate::console::{Failure, interrupt};
use crate::world::{REPLAY_HELP, RegisteredWorld, Robots, WorldOptions};

/// Runs the code again on a recording of a robot in one of these worlds, or compares two recordings.
pub(crate) fn replay<R>(
    worlds: &[RegisteredWorld<R>],
    robots: Robots<R>,
    options: &ReplayOptions<'_>,
) -> Result<ReplayReport, Failure>
where
    R: Recordable<Error: fmt::Display> + 'static,
{
    let subject = |header: &Header, runs_world| subject(worlds, robots, header, options.set, runs_world);
    Ok(bica_recording::replay(options, subject, |_| !interrupt::requested())?)
}

/// Runs the code again on a recording with other parameters, and records the new run.
#[cfg(feature = "monitor")]
pub(crate) fn rerun<R>(
    worlds: &[RegisteredWorld<R>],
    robots: Robots<R>,
    path: &Path,
    set: &[String],
    out: &Path,
    mut progress: impl FnMut(f64) -> bool,
) -> Result<(), Invalid>
where
    R: Recordable<Error: fmt::Display> + 'static,
{
    let subject = |header: &Header, runs_world| subject(worlds, robots, header, set, runs_world);
    let progress = |seconds| !interrupt::requested() && progress(seconds);
    bica_recording::rerun(path, out, subject, progress).map(drop)
}

/// Returns the robot as it was at the start of the recording, with other parameters, and its world if that is simulated again.
fn subject<R: Robot + 'static>(
    worlds: &[RegisteredWorld<R>],
    robots: Robots<R>,
    header: &Header,
    set: &[String],
    runs_world: bool,
) -> Result<Subject<R>, Invalid> {
    let robot = recorded_robot(robots, header, set)?;
    let world = runs_world.then(|| world(worlds, header)).transpose()?;
    Ok(Subject { robot, world })
}

/// Returns the robot with the parameters of a recording, overridden by those in `set`.
pub(crate) fn recorded_robot<R: Robot>(robots: Robots<R>, header: &Header, set: &[String]) -> Result<Box<R>, Invalid> {
    let mut layers = Layers::new(const { &R::GRAPH });
    // The parameters of other trees are constants.
    if R::GRAPH.tunable {
        header.assignments().try_for_each(|assignment| layers.assign(&assignment, "the recording"))?;
    }
    set.iter().try_for_each(|assignment| layers.assign(assignment, "--set"))?;
    let mut robot = (robots.make)();
    layers.apply(&mut *robot)?;
    Ok(robot)
}

fn world<R: Robot + 'static>(
    worlds: &[RegisteredWorld<R>],
    header: &Header,
) -> Result<Box<dyn RepeatedWorld<R>>, Failure> {
    let name = header.set_up.get("world").and_then(|name| name.as_str()).unwrap_or_default();
    let world = worlds.iter().find(|world| world.name == name).ok_or_else(|| {
        let what = format!("the recording is of the world `{name}`, which this program does not have");
        Failure::new(what, REPLAY_HELP)
    })?;
    Ok(Box::new(world.open(&WorldOptions::of_set_up(&header.set_up)?)?))
}
