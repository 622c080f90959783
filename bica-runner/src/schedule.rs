//! When the cycles of a real-time loop are due.

use core::fmt;

use bica_core::{Duration, Instant};

use crate::timing::Timing;

/// The deadlines of a loop with a fixed rate, and what became of them.
///
/// Deadline number n is `start + n / rate`, computed anew from n, so the grid does not drift. Rates are kept in
/// millihertz. The loop calls [`begin`](Self::begin) and [`end`](Self::end) around each cycle and waits for
/// [`deadline`](Self::deadline) in between.
#[derive(Clone, Copy, Debug)]
pub struct Schedule {
    millihertz: u64,
    policy: OverrunPolicy,
    /// When the grid began; `None` before the first cycle.
    start: Option<Instant>,
    /// Number of the next deadline.
    number: u64,
    begun: Instant,
    /// The delays from each deadline to the beginning of its cycle.
    pub jitter: Timing,
    /// The execution times of the cycles.
    pub execution: Timing,
    /// Number of cycles that were not over when the next one was due.
    pub overruns: u64,
    /// Number of deadlines without a cycle of their own.
    pub skipped: u64,
}

/// What a loop does after a cycle that took too long.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum OverrunPolicy {
    /// Begins the next cycle at once and keeps the grid; deadlines that lie a period or more back are skipped.
    #[default]
    Skip,
    /// Begins the next cycle at once, and a new grid with it.
    Shift,
    /// Ends the loop with [`RunError::Overrun`].
    Abort,
}

/// A cycle that was not over when the next one was due.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Overrun {
    /// How long after that deadline it ended.
    pub late: Duration,
    /// Deadlines that are skipped because of it.
    pub skipped: u64,
}

/// The reason why a real-time loop ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RunError<E> {
    /// The robot refused the sensor values.
    Sense(E),
    /// A cycle took too long, under [`OverrunPolicy::Abort`].
    Overrun(Overrun),
}

impl<E: fmt::Display> fmt::Display for RunError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Sense(error) => write!(f, "the robot refused the sensor values: {error}"),
            Self::Overrun(overrun) => {
                write!(f, "a cycle ended {} µs after the next one was due", overrun.late.as_micros())
            }
        }
    }
}

impl<E: fmt::Debug + fmt::Display> core::error::Error for RunError<E> {}

impl Schedule {
    /// A schedule of `hz` cycles per second, from 0.001 to 1,000,000; a rate beyond these bounds is brought to the nearer
    /// one. It begins with the first deadline that is asked for.
    #[must_use]
    pub const fn new(hz: f32, policy: OverrunPolicy) -> Self {
        let millihertz = (hz.clamp(0.001, 1e6) as f64 * 1000.0 + 0.5) as u64;
        Self {
            millihertz: if millihertz == 0 { 1 } else { millihertz },
            policy,
            start: None,
            number: 0,
            begun: Instant::MIN,
            jitter: Timing::new(),
            execution: Timing::new(),
            overruns: 0,
            skipped: 0,
        }
    }

    /// Begins a new grid at the next deadline that is asked for; the statistics go on.
    pub const fn restart(&mut self) {
        (self.start, self.number) = (None, 0);
    }

    /// When the next cycle is due. The first one is due at `now`.
    pub fn deadline(&mut self, now: Instant) -> Instant {
        let start = *self.start.get_or_insert(now);
        self.at(start, self.number)
    }

    /// Deadline `number` of the grid from `start`.
    fn at(&self, start: Instant, number: u64) -> Instant {
        let us = u128::from(number) * 1_000_000_000 / u128::from(self.millihertz);
        start.saturating_add(Duration::from_micros(us as u64))
    }

    /// A cycle begins.
    pub fn begin(&mut self, now: Instant) {
        let due = self.deadline(now);
        self.jitter.add(now.saturating_duration_since(due));
        self.begun = now;
    }

    /// The cycle has ended: chooses the next deadline.
    ///
    /// Returns the overrun if that deadline has passed already.
    pub fn end(&mut self, now: Instant) -> Option<Overrun> {
        self.execution.add(now.saturating_duration_since(self.begun));
        self.number += 1;
        let start = self.start?;
        let due = self.at(start, self.number);
        if now <= due {
            return None;
        }
        let late = now.saturating_duration_since(due);
        // The last deadline that has passed, from the elapsed time; rounding may leave it one too early.
        let elapsed = u128::from(now.saturating_duration_since(start).as_micros());
        let mut last = (elapsed * u128::from(self.millihertz) / 1_000_000_000) as u64;
        if self.at(start, last + 1) <= now {
            last += 1;
        }
        let skipped = last.saturating_sub(self.number);
        match self.policy {
            OverrunPolicy::Skip | OverrunPolicy::Abort => self.number += skipped,
            OverrunPolicy::Shift => (self.start, self.number) = (Some(now), 0),
        }
        self.overruns += 1;
        self.skipped += skipped;
        Some(Overrun { late, skipped })
    }

    /// Whether the loop ends after an overrun.
    #[must_use]
    pub const fn aborts(&self) -> bool {
        matches!(self.policy, OverrunPolicy::Abort)
    }
}

/// One line: cycles, overruns, jitter, execution time.
impl fmt::Display for Schedule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} cycles at {} Hz, {} overruns, {} deadlines skipped",
            self.execution.count(),
            self.millihertz as f64 / 1000.0,
            self.overruns,
            self.skipped
        )?;
        for (name, timing) in [("jitter", &self.jitter), ("execution", &self.execution)] {
            write!(
                f,
                "; {name}: mean {} µs, 99 % below {} µs, max {} µs",
                timing.mean().as_micros(),
                timing.quantile(0.99).as_micros(),
                timing.max().as_micros()
            )?;
        }
        Ok(())
    }
}
