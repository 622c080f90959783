//! `monitor`: a web page that shows, tunes, drives and records the robot.

use std::fmt;
use std::sync::Arc;

use bica::runner::Robot;
use bica_link::{LinkRequests, LinkServer, ServerOptions};
use bica_monitor::cli::Arguments;
use bica_monitor::program::{Extension, Game, LocalWorld, Program, WorldRun, WorldSetup};
use bica_monitor::sessions::Options;
use bica_recording::{Header, LogLine, LogSource, Recordable};
use bica_tuning::Layers;
use bica_wire::message::Offers;
use bica_wire::model::Invalid;
use clap::{Args, Command};
use log::LevelFilter;

use crate::console::{Failure, Outcome, interrupt};
use crate::log::Lines;
use crate::record::{Images, RecordArgs, RecordedFile};
use crate::replay::rerun;
use crate::run::{Running, observers, workers};
use crate::world::{Pace, RegisteredWorld, Robots, WorldOptions};

/// Level of a note in the log of a recording: information.
const NOTE_LEVEL: u8 = 2;

type Worlds<R> = Arc<Vec<RegisteredWorld<R>>>;

/// Returns the command.
pub(crate) fn command() -> Command {
    let about = "Serve a web page that shows, tunes, drives and records the robot in a world, robots behind a link, or recordings";
    Arguments::augment_args(Command::new("monitor")).about(about)
}

/// Serves the page until Ctrl-C.
pub(crate) fn run(program: Program, args: &Arguments) -> Result<Outcome, Failure> {
    bica_monitor::run(args, Options::default(), program, &interrupt::requested)?;
    Ok(Outcome::Success)
}

/// Returns this program's worlds and panels for the monitor.
pub(crate) fn program<R: Recordable<Error: fmt::Display> + 'static>(
    worlds: Vec<RegisteredWorld<R>>,
    robots: Robots<R>,
    extensions: Vec<Box<dyn Extension>>,
) -> Program {
    let worlds = Arc::new(worlds);
    let simulated = (0..worlds.len()).filter(|&index| worlds[index].pace == Pace::Program);
    let local = |index| Box::new(Simulated { worlds: Arc::clone(&worlds), index, robots }) as Box<dyn LocalWorld>;
    Program {
        graph: Some(const { &R::GRAPH }),
        worlds: simulated.map(local).collect(),
        rerun: Some(Box::new(move |recording, set, out, progress| {
            rerun(&worlds, robots, recording, set, out, progress)
        })),
        extensions,
        ..Program::default()
    }
}

/// World of this program in the form that the monitor uses.
struct Simulated<R: Robot> {
    worlds: Worlds<R>,
    index: usize,
    robots: Robots<R>,
}

impl<R: Recordable<Error: fmt::Display> + 'static> LocalWorld for Simulated<R> {
    fn name(&self) -> &str {
        self.worlds[self.index].name
    }

    fn prepare(&self, setup: &WorldSetup) -> Result<Game, Invalid> {
        let mut layers = Layers::new(const { &R::GRAPH });
        if let Some(tune) = &setup.tune {
            layers.read(tune)?;
        }
        setup.set.iter().try_for_each(|assignment| layers.assign(assignment, "the page"))?;
        layers.apply(&mut *(self.robots.make)())?;
        let options: Vec<_> = setup.options.iter().map(|(name, value)| format!("{name}={value}")).collect();
        let options = WorldOptions::new(setup.seed, &options)?;
        let Self { worlds, index, robots } = self;
        let (worlds, index, robots) = (Arc::clone(worlds), *index, *robots);
        Ok(Box::new(move |run| Ok(play(&worlds[index], &options, &layers, robots, run)?)))
    }
}

/// Runs a world until the monitor ends it. The world pauses when the robot reaches its aim.
fn play<R: Recordable<Error: fmt::Display> + 'static>(
    registered: &RegisteredWorld<R>,
    options: &WorldOptions,
    layers: &Layers,
    Robots { make, is_done }: Robots<R>,
    run: &WorldRun,
) -> Result<(), Failure> {
    let set_up = options.set_up(registered.name);
    let mut world = registered.open(options)?;
    let actions = world.actions().map_or(&[][..], |actions| actions.list());
    let mut robot = make();
    layers.apply(&mut *robot)?;
    let header = |images| {
        let header = Header::new(const { &R::GRAPH }, set_up, images).with_actions(actions);
        header.with_scenery(|scene| world.scenery(scene)).of_robot(&*robot)
    };
    // Sensor values are not stored: a replay creates the same world again from its set-up.
    let record = RecordArgs {
        record: Some(run.recording().to_owned()),
        images: Images::None,
        topics: None,
        split: None,
        force: true,
    };
    let started = record.start(header, true).unwrap_or_else(|failure| {
        run.not_recorded(&Invalid::from(failure).what);
        None
    });
    let (file, recorder) = started.unzip();
    let recorder = recorder.map(|recorder| recorder.measuring(const { &R::GRAPH }));
    let offers = ServerOptions { offers: Offers::PAUSE, actions, ..ServerOptions::default() };
    let (server, requests, view) = LinkServer::start_in_world::<R>(&run.address(), offers, &*world)?;
    let lines = Lines::new(const { &R::GRAPH }, LevelFilter::Info);
    let workers = workers(Pace::Program, lines.as_ref());
    let observers = observers(None, lines, Some(view), recorder);
    let mut running = Running::new(robot, world, Some(requests), observers, (true, workers));
    running.figures()?;
    while !run.is_ended() {
        if let Some(end) = running.end(is_done, None).filter(|_| run.over()) {
            server.set_result(&running.result(end));
            running.runner.requests_mut().iter_mut().for_each(LinkRequests::pause);
        }
        running.step()?;
        let (_, (_, (_, recorder))) = running.runner.observer();
        if let (Some(recorder), Some(note)) = (recorder, run.note()) {
            recorder.log(LogLine { level: NOTE_LEVEL, source: LogSource::Note, text: note });
        }
        if let Some(reason) = file.as_ref().and_then(RecordedFile::newly_ended) {
            run.not_recorded(&reason);
        }
    }
    let figures = running.figures()?;
    let (_, _, _, (_, (_, (_, recorder)))) = running.runner.into_parts();
    recorder.map(|mut recorder| {
        recorder.set_figures(figures);
        recorder.finish("ended by the monitor")
    });
    Ok(())
}
