//! `run`: the robot in a world.

mod args;
mod report;
mod story;

use std::fmt;
use std::thread;
use std::time::Duration;

use bica::Instant;
use bica::runner::realtime::Clock;
use bica::runner::{Observer, OverrunPolicy, Robot, Runner, Schedule, World};
use bica_console::{Console, Failure, Outcome, interrupt};
use bica_link::{LinkObserver, LinkRequests, LinkServer, ServerOptions};
use bica_recording::{Header, Recordable, Recorder};
use bica_wire::message::Offers;

use crate::params::Layer;
use crate::record::RecordedFile;
use crate::world::{RegisteredWorld, WorldOptions};
pub(crate) use args::RunArgs;
pub use args::seconds;
use report::{End, Report};
use story::Story;

/// Exit codes of a program, for its help.
pub(crate) const EXIT_CODES: &str = "\
Exit codes: 0 the command is done, 1 the run ended before its aim, 2 wrong arguments or files, 130 stopped by Ctrl-C,
141 the reader of the output is gone. Without a terminal, or if NO_COLOR is set, the output has no colours.";

/// Time between two polls of the requests of a paused world.
const BETWEEN_REQUESTS: Duration = Duration::from_millis(5);

/// Runs the robot in one of the worlds as the command line requests.
pub(crate) fn run<R, L>(
    worlds: &[RegisteredWorld<R>],
    is_done: Option<fn(&R) -> bool>,
    args: &RunArgs<L>,
) -> Result<Outcome, Failure>
where
    R: Recordable<Error: fmt::Display> + Default + 'static,
    L: Layer,
{
    let unknown = || Failure::new(format!("there is no world `{}`", args.world), "--help lists the worlds");
    let registered = worlds.iter().find(|world| world.name == args.world).ok_or_else(unknown)?;
    let options = WorldOptions::new(args.seed, &args.option)?;
    let set_up = options.set_up(registered.name);
    let world = registered.open(&options)?;
    let mut robot = Box::<R>::default();
    args.tuning.layers(const { &R::GRAPH }, registered.name)?.apply(&mut *robot)?;
    let console = Console::new(args.json);
    let is_paced = args.realtime || registered.is_device || (args.link.serve.is_some() && !args.link.unpaced);
    let (server, requests, view) = serve::<R>(args, registered.is_device, is_paced, console)?;
    let header = |images| Header::new(const { &R::GRAPH }, set_up, images).of_robot(&*robot);
    let (file, recorder) = args.record.start(header, is_paced)?.unzip();
    let observers = (Story::new(const { &R::GRAPH }), (view, recorder));
    let mut running = Running {
        start: world.now(),
        runner: Runner::new(robot, world).with_requests(requests).with_observer(observers),
        pace: is_paced.then(|| Pace::new(R::GRAPH.cycle_hz)),
        cycles: 0,
        file,
    };
    // Monitors may look at a robot that has reached its aim.
    let aim = is_done.filter(|_| args.link.serve.is_none());
    let end = running.run(aim, args.seconds, console)?;
    // Monitors get the last values before the result is printed.
    drop(server);
    let Running { runner, start, pace, cycles, file } = running;
    let (_, world, _, (story, (_, recorder))) = runner.into_parts();
    if let Some((file, recorder)) = file.zip(recorder) {
        file.finish(recorder, end.text(), console)?;
    }
    let mut text = String::new();
    world.report(&mut text).map_err(|fmt::Error| Failure::new("the world cannot write its report", "correct it"))?;
    let seconds = world.now().saturating_duration_since(start).as_micros() as f64 * 1e-6;
    let report = Report::new(args, end, seconds, cycles, &story.changes, &text);
    report.print(console, pace.as_ref().map(|pace| &pace.schedule))?;
    Ok(match end {
        End::Interrupted => Outcome::Interrupted,
        End::Over | End::Limit if is_done.is_some() => Outcome::Unsuccessful,
        End::Done | End::Over | End::Limit => Outcome::Success,
    })
}

/// Halves of the link in the loop.
type Served<R> = (Option<LinkServer>, Option<LinkRequests>, Option<LinkObserver<R>>);

/// Starts the server, if that is requested.
fn serve<R: Robot>(
    args: &RunArgs<impl Layer>,
    is_device: bool,
    realtime: bool,
    console: Console,
) -> Result<Served<R>, Failure> {
    let Some(address) = &args.link.serve else { return Ok((None, None, None)) };
    let offers = if is_device { Offers::default() } else { Offers::PAUSE };
    let options = ServerOptions { anywhere: args.link.listen_anywhere, realtime, offers, ..ServerOptions::default() };
    let (server, requests, observer) =
        LinkServer::start::<R>(address, options).map_err(|error| Failure::new(error.to_string(), error.help()))?;
    console.print_row("link", &format!("monitors attach at {}", server.address()))?;
    Ok((Some(server), Some(requests), Some(observer)))
}

/// Deadlines of a run in real time.
struct Pace {
    clock: Clock,
    schedule: Schedule,
}

impl Pace {
    fn new(hz: f32) -> Self {
        Self { clock: Clock::start(), schedule: Schedule::new(hz, OverrunPolicy::Skip) }
    }

    fn begin(&mut self) {
        let due = self.schedule.deadline(self.clock.now());
        self.clock.sleep_until(due);
        self.schedule.begin(self.clock.now());
    }
}

type Loop<R> = Runner<Box<R>, Box<dyn World<R>>, Option<LinkRequests>, Observers<R>>;

type Observers<R> = (Story, (Option<LinkObserver<R>>, Option<Recorder>));

struct Running<R: Robot> {
    runner: Loop<R>,
    /// Time of the world at the start.
    start: Instant,
    /// None: as fast as possible.
    pace: Option<Pace>,
    cycles: u64,
    file: Option<RecordedFile>,
}

impl<R: Recordable<Error: fmt::Display>> Running<R> {
    /// Runs until the aim is reached, the world is over, the time is up, or Ctrl-C.
    fn run(&mut self, is_done: Option<fn(&R) -> bool>, seconds: Option<f64>, console: Console) -> Result<End, Failure> {
        let limit = seconds.map(|seconds| bica::Duration::from_micros((seconds * 1e6) as u64));
        loop {
            let elapsed = self.runner.world().now().saturating_duration_since(self.start);
            let end = match () {
                () if is_done.is_some_and(|is_done| is_done(self.runner.robot())) => Some(End::Done),
                () if self.runner.world().is_over() => Some(End::Over),
                () if limit.is_some_and(|limit| elapsed >= limit) => Some(End::Limit),
                () if interrupt::requested() => Some(End::Interrupted),
                () => None,
            };
            if let Some(end) = end {
                return Ok(end);
            }
            if self.begins_cycle() {
                self.cycle()?;
                self.runner.observer_mut().0.print(console)?;
                self.file.iter().for_each(RecordedFile::warn);
            }
        }
    }

    /// Whether an operator lets the world go on; if not, the requests are applied.
    fn begins_cycle(&mut self) -> bool {
        if self.runner.requests_mut().as_mut().is_none_or(LinkRequests::begins_cycle) {
            return true;
        }
        self.runner.apply_requests();
        thread::sleep(BETWEEN_REQUESTS);
        if let Some(pace) = &mut self.pace {
            pace.schedule.restart();
        }
        false
    }

    fn cycle(&mut self) -> Result<(), Failure> {
        if let Some(pace) = &mut self.pace {
            pace.begin();
        }
        let rejected =
            |error: R::Error| format!("the robot rejected the sensor values of cycle {}: {error}", self.cycles);
        self.runner.cycle().map_err(|error| Failure::new(rejected(error), "choose another world or other options"))?;
        self.cycles += 1;
        let overrun = self.pace.as_mut().and_then(|pace| pace.schedule.end(pace.clock.now()));
        if let Some(overrun) = overrun {
            Observer::<R>::overrun(self.runner.observer_mut(), &overrun);
        }
        Ok(())
    }
}
