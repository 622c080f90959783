//! The loop of a run.

use std::fmt;
use std::thread;
use std::time::Duration;

use bica::Instant;
use bica::runner::realtime::Clock;
use bica::runner::workers::{self, Workers};
use bica::runner::{Observer, OverrunPolicy, Robot, Runner, Schedule, World};
use bica_link::{LinkObserver, LinkRequests};
use bica_recording::{Figure, LogLine, Recordable, Recorder};

use super::report::End;
use super::story::Story;
use crate::console::{Console, Failure};
use crate::log::Lines;

/// Time between two polls of the requests of a paused world.
const BETWEEN_REQUESTS: Duration = Duration::from_millis(5);

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

type Loop<R> = Runner<Box<R>, Box<dyn World<R>>, Option<LinkRequests>, Observers<R>, Workers<R>>;

type Observers<R> = (Option<Story>, (Option<Lines>, (Option<LinkObserver<R>>, Option<Recorder>)));

/// Observes a run from all sides: its lines of text go to the monitors and to the recording.
pub(crate) fn observers<R: Robot>(
    story: Option<Story>,
    lines: Option<Lines>,
    view: Option<LinkObserver<R>>,
    recorder: Option<Recorder>,
) -> Observers<R> {
    let lines = lines.map(|mut lines| {
        if let Some(view) = &view {
            let send = view.lines();
            lines.add(move |now, LogLine { level, source, text }| send(now, *level, *source, text));
        }
        if let Some(recorder) = &recorder {
            let record = recorder.lines();
            lines.add(move |_, line| record(line.clone()));
        }
        lines
    });
    (story, (lines, (view, recorder)))
}

/// Threads for the jobs of a robot: all processors but that of the loop. In a world that the program paces, results arrive when they are
/// due.
pub(crate) fn workers<R: Robot>(pace: crate::world::Pace, lines: Option<&Lines>) -> Workers<R> {
    let threads = thread::available_parallelism().map_or(1, |count| count.get() - 1);
    let simulated = pace == crate::world::Pace::Program;
    let workers = Workers::new(threads, if simulated { workers::Pace::Simulated } else { workers::Pace::RealTime });
    match lines {
        Some(lines) => workers.announcing(lines.of_jobs()),
        None => workers,
    }
}

/// Run of a robot in a world.
pub(crate) struct Running<R: Robot> {
    pub(crate) runner: Loop<R>,
    /// Time of the world at the start.
    start: Instant,
    /// Pace in real time; `None` runs as fast as possible.
    pace: Option<Pace>,
    pub(super) cycles: u64,
}

impl<R: Recordable<Error: fmt::Display>> Running<R> {
    /// Creates a run before its first cycle, in real time or as fast as possible.
    pub(crate) fn new(
        robot: Box<R>,
        world: Box<dyn World<R>>,
        requests: Option<LinkRequests>,
        observers: Observers<R>,
        (is_paced, workers): (bool, Workers<R>),
    ) -> Self {
        let (start, pace) = (world.now(), is_paced.then(|| Pace::new(R::GRAPH.cycle_hz)));
        let runner = Runner::new(robot, world).with_requests(requests).with_observer(observers).with_jobs(workers);
        Self { runner, start, pace, cycles: 0 }
    }

    /// Time of the world since the start.
    pub(super) fn elapsed(&self) -> bica::Duration {
        self.runner.now().saturating_duration_since(self.start)
    }

    /// Statistics of a run in real time.
    pub(super) fn schedule(&self) -> Option<Schedule> {
        self.pace.as_ref().map(|pace| pace.schedule)
    }

    /// Reason for which the run ends now, if it does: its aim, the end of the world, or the time limit.
    pub(crate) fn end(&self, is_done: Option<fn(&R) -> bool>, limit: Option<bica::Duration>) -> Option<End> {
        match () {
            () if is_done.is_some_and(|is_done| is_done(self.runner.robot())) => Some(End::Done),
            () if self.runner.world().is_over() => Some(End::Over),
            () if limit.is_some_and(|limit| self.elapsed() >= limit) => Some(End::Limit),
            () => None,
        }
    }

    /// Figures of the result so far.
    pub(crate) fn figures(&self) -> Result<Vec<Figure>, Failure> {
        Ok(Figure::all(&**self.runner.world())?)
    }

    /// Text of the result.
    pub(crate) fn result(&self, end: End) -> String {
        let result = format!("{} after {:.2} s", end.text(), self.elapsed().as_micros() as f64 * 1e-6);
        Figure::with(&result, &self.figures().unwrap_or_default())
    }

    /// Prints the changes of state and the lines of the log since the last call.
    pub(super) fn print(&mut self, console: Console) -> Result<(), Failure> {
        let (story, (lines, _)) = self.runner.observer_mut();
        story.as_mut().map_or(Ok(()), |story| story.print(console))?;
        lines.as_mut().map_or(Ok(()), |lines| lines.print(console))
    }

    /// Runs a cycle, or applies the requests of a paused world. Returns whether it ran a cycle.
    pub(crate) fn step(&mut self) -> Result<bool, Failure> {
        let begins_cycle = self.begins_cycle();
        if begins_cycle {
            self.cycle()?;
        }
        let (_, (_, (view, _))) = self.runner.observer();
        if let Some(view) = view {
            view.show_truth(&**self.runner.world());
        }
        Ok(begins_cycle)
    }

    /// Returns whether a cycle may begin. If an operator has paused the world, applies the requests instead.
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
