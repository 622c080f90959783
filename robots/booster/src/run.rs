//! The thread that owns the robot's topics: its commands do not wait for the robot program.

use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use bica_motion::robot::{Command, Sensors};

use crate::driver::{Counts, Driver, Inputs};
use crate::firmware::Motion;
use crate::guard::Guard;
use crate::options::Options;
use crate::transport::Transport;

/// Time between two looks at the topics.
const LOOK: Duration = Duration::from_millis(1);

/// How far a run is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Course {
    /// The robot program may command.
    #[default]
    Runs,
    /// The robot program should end its motion.
    Ends,
    /// The robot was given back in order.
    GivenBack,
    /// The robot did not answer at the end, or the thread has panicked.
    Failed,
}

/// What the thread and the world exchange.
#[derive(Default)]
pub(crate) struct Exchange {
    /// Sensor values of a cycle that the robot program has not begun yet, with its time since the start.
    pub(crate) cycle: Option<(Duration, Sensors<'static>)>,
    /// Answer of the robot program.
    pub(crate) command: Option<(Command, Motion)>,
    pub(crate) course: Course,
    /// Whether the world was dropped.
    pub(crate) is_dropped: bool,
    pub(crate) counts: Counts,
}

/// The exchange and its signal for a new cycle.
#[derive(Default)]
pub(crate) struct Shared {
    exchange: Mutex<Exchange>,
    pub(crate) news: Condvar,
}

impl Shared {
    pub(crate) fn lock(&self) -> MutexGuard<'_, Exchange> {
        self.exchange.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Ends the run for the world even if the thread panics.
struct Ended(Arc<Shared>);

impl Drop for Ended {
    fn drop(&mut self) {
        let mut exchange = self.0.lock();
        if exchange.course != Course::GivenBack {
            exchange.course = Course::Failed;
        }
        drop(exchange);
        self.0.news.notify_all();
    }
}

/// Runs the driver until it is over.
pub(crate) fn run(mut transport: impl Transport, mut options: Options, shared: &Arc<Shared>) {
    let ended = Ended(Arc::clone(shared));
    let mut driver = Driver::new(options.body, options.gait, options.client);
    let guard = options.guard.take().map(Guard::start).transpose();
    let mut guard = guard.unwrap_or_else(|error| {
        (options.say)(&format!("the guard cannot be started, so a killed program leaves the robot as it is: {error}"));
        None
    });
    let start = Instant::now();
    while !driver.is_over() {
        let now = start.elapsed();
        let (command, is_dropped) = {
            let mut exchange = shared.lock();
            (exchange.command.take(), exchange.is_dropped)
        };
        let is_late = options.limit.is_some_and(|limit| now.as_secs_f64() >= limit);
        let stop = is_dropped || is_late || (options.stop)();
        let cycle = exchange(&mut transport, &mut driver, now, command.as_ref(), stop, options.say);
        if let Some(guard) = &mut guard {
            guard.tell(driver.has_robot());
        }
        let mut exchange = shared.lock();
        exchange.counts = driver.counts();
        exchange.course = match () {
            () if driver.is_given_back() => Course::GivenBack,
            () if driver.is_ending() => Course::Ends,
            () => Course::Runs,
        };
        if let Some(sensors) = cycle {
            exchange.cycle = Some((now, sensors));
            shared.news.notify_all();
        }
        drop(exchange);
        thread::sleep(LOOK);
    }
    let hangs = driver.hangs(start.elapsed());
    drop((guard, ended));
    if hangs {
        (options.abandon)();
    }
}

/// Passes what has come to the driver, and what it sends to the robot; returns the sensor values of a new cycle.
pub(crate) fn exchange(
    transport: &mut impl Transport,
    driver: &mut Driver,
    now: Duration,
    command: Option<&(Command, Motion)>,
    stop: bool,
    say: fn(&str),
) -> Option<Sensors<'static>> {
    let received = transport.receive();
    let inputs = Inputs {
        states: &received.states,
        fall: received.fall,
        answers: &received.answers,
        command: command.map(|(command, motion)| (command, *motion)),
        stop,
    };
    let outputs = driver.step(now, &inputs);
    outputs.command.into_iter().for_each(|command| transport.command(command));
    outputs.requests.into_iter().for_each(|request| transport.request(request));
    outputs.notes.iter().for_each(|note| say(note));
    outputs.cycle
}
