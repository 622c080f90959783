//! The real-time loop on embassy-time.

use core::ops::DerefMut;

use bica_core::Instant;
use embassy_time::Timer;

use crate::jobs::Jobs;
use crate::observer::Observer;
use crate::request::Requests;
use crate::robot::Robot;
use crate::runner::Runner;
use crate::schedule::{RunError, Schedule};
use crate::world::World;

impl Schedule {
    /// Waits for the next deadline and returns it. Can be cancelled, so it can be combined with a link in a `select`. Other tasks run
    /// meanwhile, also if the deadline has passed: a `select` that polls a link first, which always has bytes, never returns then.
    ///
    /// A loop that uses this function calls [`begin`](Self::begin) and [`end`](Self::end) around each cycle.
    pub async fn wait(&mut self) -> Instant {
        let due = self.deadline(Instant::now());
        Timer::at(due).await;
        due
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
    /// Runs cycles at the rate of `schedule`, other tasks and slices of jobs in between; returns only with an error. A slice that takes
    /// longer than the time until the next deadline delays a cycle.
    pub async fn run_async(&mut self, schedule: &mut Schedule) -> RunError<<T::Target as Robot>::Error> {
        schedule.restart();
        loop {
            let due = schedule.deadline(Instant::now());
            while Instant::now() < due && self.idle() {
                // Other tasks run between two slices.
                Timer::at(Instant::MIN).await;
            }
            schedule.wait().await;
            schedule.begin(Instant::now());
            if let Err(error) = self.cycle() {
                return RunError::Sense(error);
            }
            if let Some(overrun) = schedule.end(Instant::now()) {
                self.observer_mut().overrun(&overrun);
                if schedule.aborts() {
                    return RunError::Overrun(overrun);
                }
            }
        }
    }
}
