//! The real-time loop of an operating system.

use core::ops::DerefMut;
use core::sync::atomic::{AtomicBool, Ordering};
use std::sync::Arc;
use std::thread;
use std::time;

use bica_core::Instant;

use crate::jobs::Jobs;
use crate::observer::Observer;
use crate::request::Requests;
use crate::robot::Robot;
use crate::runner::Runner;
use crate::schedule::{RunError, Schedule};
use crate::world::World;

/// Monotonic clock of the operating system; it starts at zero when it is created.
#[derive(Clone, Copy, Debug)]
pub struct Clock(time::Instant);

impl Clock {
    /// Creates a clock that starts now.
    #[must_use]
    pub fn start() -> Self {
        Self(time::Instant::now())
    }

    /// Time since the start of the clock, as the instant of a tick.
    #[must_use]
    pub fn now(&self) -> Instant {
        Instant::from_micros(self.0.elapsed().as_micros() as u64)
    }

    /// Sleeps until an instant of this clock; returns at once if it has passed.
    pub fn sleep_until(&self, due: Instant) {
        let left = due.saturating_duration_since(self.now());
        thread::sleep(time::Duration::from_micros(left.as_micros()));
    }
}

/// Flag that ends loops; clones share it.
#[derive(Clone, Debug, Default)]
pub struct Stop(Arc<AtomicBool>);

impl Stop {
    /// Creates a flag that is not raised.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Creates a flag that the first Ctrl-C, SIGTERM or SIGHUP raises.
    ///
    /// # Errors
    /// If the process already has a handler, or the operating system rejects one.
    #[cfg(feature = "ctrlc")]
    pub fn on_ctrl_c() -> Result<Self, ctrlc::Error> {
        let stop = Self::new();
        let raised = stop.clone();
        ctrlc::set_handler(move || raised.stop())?;
        Ok(stop)
    }

    /// Raises the flag.
    pub fn stop(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// Whether the flag is raised.
    #[must_use]
    pub fn is_stopped(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

impl<T, W, Q, O, J> Runner<T, W, Q, O, J>
where
    T: DerefMut<Target: Robot>,
    W: World<T::Target>,
    Q: Requests,
    O: Observer<T::Target>,
    J: Jobs<T::Target>,
{
    /// Runs cycles at the rate of `schedule` until `continues` is false or `stop` is raised.
    ///
    /// Each cycle waits until its absolute deadline on a monotonic clock. Afterwards `schedule` contains the
    /// statistics; a later call can continue with it.
    ///
    /// # Errors
    /// [`RunError::Sense`]; [`RunError::Overrun`] if the schedule's policy is to abort.
    pub fn run(
        &mut self,
        schedule: &mut Schedule,
        stop: &Stop,
        mut continues: impl FnMut(&mut Self) -> bool,
    ) -> Result<(), RunError<<T::Target as Robot>::Error>> {
        let clock = Clock::start();
        schedule.restart();
        while !stop.is_stopped() && continues(self) {
            clock.sleep_until(schedule.deadline(clock.now()));
            schedule.begin(clock.now());
            self.cycle().map_err(RunError::Sense)?;
            if let Some(overrun) = schedule.end(clock.now()) {
                self.observer_mut().overrun(&overrun);
                if schedule.aborts() {
                    return Err(RunError::Overrun(overrun));
                }
            }
        }
        Ok(())
    }
}
