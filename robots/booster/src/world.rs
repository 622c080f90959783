//! The real robot as a world.

use std::io;
use std::sync::Arc;
use std::thread::{self, JoinHandle};
use std::time::Duration;

use bica::Instant;
use bica_motion::robot::{Command, Sensors};

use crate::driver::Counts;
use crate::firmware::Motion;
use crate::options::Options;
use crate::run::{Course, Shared, run};
use crate::transport::Transport;

/// Longest wait for news of the thread before its state is looked at again.
const WAIT: Duration = Duration::from_millis(100);

/// A T1 or K1 behind its topics.
///
/// The robot program gets a cycle every 10 ms while it commands the robot. A thread sends the commands, so that a robot program that is
/// late or paused leaves the robot with its last targets. When the run ends, for whatever reason, the firmware gets the robot back; so it
/// does when this value is dropped.
pub struct BoosterWorld {
    shared: Arc<Shared>,
    thread: Option<JoinHandle<()>>,
    now: Duration,
    sensors: Sensors<'static>,
    motion: Motion,
    counts: Counts,
}

impl BoosterWorld {
    /// Waits until the robot stands and follows. Returns before if the program is asked to end.
    ///
    /// # Errors
    /// If there is no thread.
    pub fn open(transport: impl Transport + 'static, options: Options) -> io::Result<Self> {
        let shared = Arc::<Shared>::default();
        let of_thread = Arc::clone(&shared);
        let work = move || run(transport, options, &of_thread);
        let thread = Some(thread::Builder::new().name("booster".into()).spawn(work)?);
        let (motion, counts) = (Motion::default(), Counts::default());
        let mut world = Self { shared, thread, now: Duration::ZERO, sensors: Sensors::UNMEASURED, motion, counts };
        world.advance();
        Ok(world)
    }

    /// Measurements of this cycle; all zero if the run ended before the first one.
    #[must_use]
    pub const fn sense(&self) -> Sensors<'static> {
        self.sensors
    }

    /// Sends a command within the limits, and waits for the next cycle.
    pub fn command(&mut self, command: &Command) {
        self.shared.lock().command = Some((*command, self.motion));
        self.advance();
    }

    /// Sets what the next commands request of the firmware's gait.
    pub const fn request(&mut self, motion: Motion) {
        self.motion = motion;
    }

    /// Whether the robot program should end its motion.
    #[must_use]
    pub fn is_ending(&self) -> bool {
        self.shared.lock().course != Course::Runs
    }

    /// Whether the firmware has the robot back, or nothing can be done any more.
    #[must_use]
    pub fn has_ended(&self) -> bool {
        matches!(self.shared.lock().course, Course::GivenBack | Course::Failed)
    }

    /// Whether the run goes on, or the robot was given back in order.
    #[must_use]
    pub fn is_in_order(&self) -> bool {
        self.shared.lock().course != Course::Failed
    }

    /// Time of this cycle since the start.
    #[must_use]
    pub const fn time(&self) -> Instant {
        Instant::from_micros(self.now.as_micros() as u64)
    }

    /// Numbers of the run so far.
    #[must_use]
    pub const fn counts(&self) -> Counts {
        self.counts
    }

    /// Waits for the next cycle, or the end.
    fn advance(&mut self) {
        let mut exchange = self.shared.lock();
        loop {
            self.counts = exchange.counts;
            if let Some((now, sensors)) = exchange.cycle.take() {
                (self.now, self.sensors) = (now, sensors);
                return;
            }
            if matches!(exchange.course, Course::GivenBack | Course::Failed) {
                return;
            }
            exchange = match self.shared.news.wait_timeout(exchange, WAIT) {
                Ok((exchange, _)) => exchange,
                Err(poisoned) => poisoned.into_inner().0,
            };
        }
    }
}

impl Counts {
    /// Writes the numbers for people.
    ///
    /// # Errors
    /// If `out` cannot be written.
    pub fn write(&self, out: &mut dyn core::fmt::Write) -> core::fmt::Result {
        let Self { states, rejected, cycles, late } = self;
        write!(out, "{states} states, {rejected} not used; {cycles} cycles, {late} commands repeated")
    }
}

impl Drop for BoosterWorld {
    fn drop(&mut self) {
        self.shared.lock().is_dropped = true;
        if let Some(thread) = self.thread.take() {
            // A panic of the thread was printed.
            _ = thread.join();
        }
    }
}
