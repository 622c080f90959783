//! `run`: the robot in a world.

mod args;
mod report;
mod running;
mod story;

use std::fmt;

use bica::action::Action;
use bica::runner::World;
use bica_link::{LinkObserver, LinkRequests, LinkServer, ServerOptions};
use bica_recording::{Header, Recordable};
use bica_wire::message::Offers;
use bica_wire::model::Description;
use log::LevelFilter;

use crate::console::{Console, Failure, Outcome, interrupt};
use crate::link::RosNode;
use crate::log::Lines;
use crate::params::{self, Layer};
use crate::record::RecordedFile;
use crate::world::{Pace, RegisteredWorld, Robots, WorldOptions};
pub use args::RunArgs;
use report::{End, Report};
pub(crate) use running::{Running, observers, workers};
use story::Story;

/// Exit codes of a program, for its help.
pub(crate) const EXIT_CODES: &str = "\
Exit codes: 0 the command is done, 1 the run ended before its aim, 2 wrong arguments or files, 130 stopped by Ctrl-C,
141 the reader of the output is gone. Without a terminal, or if NO_COLOR is set, the output has no colours.";

/// Runs the robot in one of the worlds as the command line requests, and shows it to a function after each cycle.
pub(crate) fn run<R, L>(
    worlds: &[RegisteredWorld<R>],
    Robots { make, is_done }: Robots<R>,
    args: &RunArgs<L>,
    show: &mut dyn FnMut(&R),
) -> Result<Outcome, Failure>
where
    R: Recordable<Error: fmt::Display> + 'static,
    L: Layer,
{
    let unknown = || Failure::new(format!("there is no world `{}`", args.world), "--help lists the worlds");
    let registered = worlds.iter().find(|world| world.name == args.world).ok_or_else(unknown)?;
    let options = WorldOptions::new(args.seed, &args.option)?;
    let set_up = options.set_up(registered.name);
    let mut world = registered.open(&options)?;
    let actions = world.actions().map_or(&[][..], |actions| actions.list());
    let mut robot = make();
    let layers = args.tuning.layers(const { &R::GRAPH }, registered.name)?;
    layers.apply(&mut *robot)?;
    let (console, layers) = (Console::new(args.json), params::in_force(&layers));
    params::print_in_force(console, &layers)?;
    let is_realtime = args.realtime || registered.pace != Pace::Program || args.link.is_paced();
    let is_paced = is_realtime && registered.pace != Pace::World;
    let can_pause = registered.pace == Pace::Program;
    let (served, requests, view) = serve::<R>(args, &*world, can_pause, actions, is_realtime, console)?;
    let header = |images| {
        let header = Header::new(const { &R::GRAPH }, set_up, images).with_actions(actions);
        header.with_scenery(|scene| world.scenery(scene)).of_robot(&*robot)
    };
    let (file, recorder) = args.record.start(header, is_realtime)?.unzip();
    let recorder = recorder.map(|recorder| recorder.measuring(const { &R::GRAPH }));
    let lines = Lines::new(const { &R::GRAPH }, args.log.unwrap_or(LevelFilter::Info));
    let workers = workers(registered.pace, lines.as_ref());
    let observers = observers(Some(Story::new(const { &R::GRAPH })), lines, view, recorder);
    let mut running = Running::new(robot, world, requests, observers, (is_paced, workers));
    running.figures()?;
    // A served run has no aim: monitors may still inspect a robot that has reached it.
    let aim = is_done.filter(|_| served.is_none());
    let limit = args.seconds.map(|seconds| bica::Duration::from_micros((seconds * 1e6) as u64));
    let end = loop {
        // A world with the pace `World` must bring its robot to rest before its run ends.
        let interrupted = || (registered.pace != Pace::World && interrupt::requested()).then_some(End::Interrupted);
        if let Some(end) = running.end(aim, limit).or_else(interrupted) {
            break end;
        }
        if running.step()? {
            show(running.runner.robot());
            running.print(console)?;
            if let Some(reason) = file.as_ref().and_then(RecordedFile::newly_ended) {
                eprintln!("warning: the recording ended, the run goes on: {reason}");
            }
        }
    };
    // Monitors get the last values before the result is printed.
    if let Some((server, _)) = served {
        server.set_result(&running.result(end));
    }
    let figures = running.figures()?;
    let (seconds, cycles, schedule) = (running.elapsed().as_micros() as f64 * 1e-6, running.cycles, running.schedule());
    let (_, world, _, (story, (_, (_, recorder)))) = running.runner.into_parts();
    let mut text = String::new();
    world.report(&mut text).map_err(|fmt::Error| Failure::new("the world cannot write its report", "correct it"))?;
    if let Some((file, mut recorder)) = file.zip(recorder) {
        recorder.set_figures(figures.clone());
        let result = std::iter::once(end.text()).chain(text.lines()).collect::<Vec<_>>().join("; ");
        console.print_row("recording", &file.describe(&recorder.finish(&result)))?;
    }
    for jobs in story.iter().flat_map(Story::jobs) {
        console.print_row("work", &jobs)?;
    }
    let story = story.map(|story| story.changes).unwrap_or_default();
    let measured = (seconds, cycles, &story[..]);
    Report::new(args, end, measured, &text, (figures, layers)).print(console, schedule.as_ref())?;
    Ok(match end {
        End::Interrupted => Outcome::Interrupted,
        End::Over | End::Limit if is_done.is_some() => Outcome::Unsuccessful,
        End::Done | End::Over | End::Limit => Outcome::Success,
    })
}

/// Link of a run: server with the ROS node, request queue and observer; all are `None` if the run is not served.
type Served<R> = (Option<(LinkServer, Option<RosNode>)>, Option<LinkRequests>, Option<LinkObserver<R>>);

/// Starts the server if the arguments request it.
fn serve<R: Recordable>(
    args: &RunArgs<impl Layer>,
    world: &dyn World<R>,
    can_pause: bool,
    actions: &'static [Action],
    realtime: bool,
    console: Console,
) -> Result<Served<R>, Failure> {
    let Some(address) = args.link.address() else { return Ok((None, None, None)) };
    let offers = if can_pause { Offers::PAUSE } else { Offers::default() };
    let options =
        ServerOptions { anywhere: args.link.listen_anywhere, realtime, offers, actions, ..ServerOptions::default() };
    let (server, mut requests, observer) = LinkServer::start_in_world::<R>(&address, options, world)?;
    let tree = Description::of(const { &R::GRAPH }).with_actions(actions);
    args.link.pause(&tree, can_pause, &mut requests)?;
    let node = args.link.started(console, &tree, &address, server.address())?;
    Ok((Some((server, node)), Some(requests), Some(observer)))
}
