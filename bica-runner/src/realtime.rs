//! The real-time loop of an operating system.

use core::ops::DerefMut;
use core::sync::atomic::{AtomicBool, Ordering};
use std::sync::Arc;
use std::thread;
use std::time;

use bica_core::Instant;

use crate::observer::Observer;
use crate::request::Requests;
use crate::robot::Robot;
use crate::runner::Runner;
use crate::schedule::{RunError, Schedule};
use crate::world::World;

/// The monotonic clock of the operating system, from zero when it is made.
#[derive(Clone, Copy, Debug)]
pub struct Clock(time::Instant);

impl Clock {
    /// A clock that begins now.
    #[must_use]
    pub fn start() -> Self {
        Self(time::Instant::now())
    }

    /// Time since the clock began, as the instant that trees take.
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

/// A flag that ends loops; clones share it.
#[derive(Clone, Debug, Default)]
pub struct Stop(Arc<AtomicBool>);

impl Stop {
    /// A flag that is not raised.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// A flag that the first Ctrl-C raises.
    ///
    /// # Errors
    /// If the process has a handler already, or the operating system refuses one.
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

impl<T, W, Q, O> Runner<T, W, Q, O>
where
    T: DerefMut<Target: Robot>,
    W: World<T::Target>,
    Q: Requests,
    O: Observer<T::Target>,
{
    /// Runs cycles at the rate of `schedule` until `goes_on` is false or `stop` is raised.
    ///
    /// Each cycle sleeps until its absolute deadline on a monotonic clock. `schedule` holds the statistics afterwards, and
    /// can be handed in again to go on.
    ///
    /// # Errors
    /// [`RunError::Sense`]; [`RunError::Overrun`] if the schedule's policy is to abort.
    pub fn run(
        &mut self,
        schedule: &mut Schedule,
        stop: &Stop,
        mut goes_on: impl FnMut(&mut Self) -> bool,
    ) -> Result<(), RunError<<T::Target as Robot>::Error>> {
        let clock = Clock::start();
        schedule.restart();
        while !stop.is_stopped() && goes_on(self) {
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
