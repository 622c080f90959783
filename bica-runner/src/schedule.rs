//! Deadlines of the cycles of a real-time loop.

use core::fmt;

use bica_core::{Duration, Instant};

use crate::timing::Timing;

/// Deadlines of a loop with a fixed rate, with statistics.
///
/// Deadline number n is `start + n / rate`, computed from n each time, so the grid does not drift. Rates are stored in
/// millihertz. The loop calls [`begin`](Self::begin) and [`end`](Self::end) around each cycle and waits for
/// [`deadline`](Self::deadline) in between.
#[derive(Clone, Copy, Debug)]
pub struct Schedule {
    millihertz: u64,
    policy: OverrunPolicy,
    /// Start of the grid; `None` before the first cycle.
    start: Option<Instant>,
    /// Number of the next deadline.
    number: u64,
    begun: Instant,
    /// Delays from each deadline to the beginning of its cycle.
    pub jitter: Timing,
    /// Execution times of the cycles.
    pub execution: Timing,
    /// Number of cycles that ended after the next one was due.
    pub overruns: u64,
    /// Number of deadlines without a cycle of their own.
    pub skipped: u64,
}

/// Reaction of a loop to a cycle that took too long.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum OverrunPolicy {
    /// Begins the next cycle at once and keeps the grid; deadlines that are at least one period old are skipped.
    #[default]
    Skip,
    /// Begins the next cycle and a new grid at once.
    Shift,
    /// Ends the loop with [`RunError::Overrun`].
    Abort,
}

/// Cycle that ended after the next one was due.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Overrun {
    /// Time from that deadline to the end of the cycle.
    pub late: Duration,
    /// Number of deadlines skipped because of it.
    pub skipped: u64,
}

/// Reason for which a real-time loop ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RunError<E> {
    /// The robot rejected the sensor values.
    Sense(E),
    /// A cycle took too long, under [`OverrunPolicy::Abort`].
    Overrun(Overrun),
}

impl<E: fmt::Display> fmt::Display for RunError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Sense(error) => write!(f, "the robot rejected the sensor values: {error}"),
            Self::Overrun(overrun) => {
                write!(f, "a cycle ended {} µs after the next one was due", overrun.late.as_micros())
            }
        }
    }
}

impl<E: fmt::Debug + fmt::Display> core::error::Error for RunError<E> {}

impl Schedule {
    /// Creates a schedule of `hz` cycles per second, limited to 0.001 to 1,000,000. The grid begins with the first call
    /// of [`deadline`](Self::deadline).
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

    /// Begins a new grid at the next call of [`deadline`](Self::deadline); the statistics are kept.
    pub const fn restart(&mut self) {
        (self.start, self.number) = (None, 0);
    }

    /// Returns the next deadline. The first one is `now`. If the policy is to skip, deadlines that are at least one period old are
    /// skipped here too: the loop may have been held up between two cycles.
    pub fn deadline(&mut self, now: Instant) -> Instant {
        let start = *self.start.get_or_insert(now);
        if !matches!(self.policy, OverrunPolicy::Shift) {
            self.skip(self.missed(start, now));
        }
        self.at(start, self.number)
    }

    /// Number of deadlines before the last one that has passed, from the next one on.
    fn missed(&self, start: Instant, now: Instant) -> u64 {
        // From the elapsed time; rounding may make it too small by one.
        let elapsed = u128::from(now.saturating_duration_since(start).as_micros());
        let mut last = (elapsed * u128::from(self.millihertz) / 1_000_000_000) as u64;
        if self.at(start, last + 1) <= now {
            last += 1;
        }
        last.saturating_sub(self.number)
    }

    fn skip(&mut self, count: u64) {
        self.number += count;
        self.skipped += count;
    }

    /// Deadline `number` of the grid that begins at `start`.
    fn at(&self, start: Instant, number: u64) -> Instant {
        let us = u128::from(number) * 1_000_000_000 / u128::from(self.millihertz);
        start.saturating_add(Duration::from_micros(us as u64))
    }

    /// Records the beginning of a cycle.
    pub fn begin(&mut self, now: Instant) {
        let due = self.start.map_or(now, |start| self.at(start, self.number));
        self.jitter.add(now.saturating_duration_since(due));
        self.begun = now;
    }

    /// Records the end of a cycle and selects the next deadline.
    ///
    /// Returns the overrun if that deadline has already passed.
    pub fn end(&mut self, now: Instant) -> Option<Overrun> {
        self.execution.add(now.saturating_duration_since(self.begun));
        self.number += 1;
        let start = self.start?;
        let due = self.at(start, self.number);
        if now <= due {
            return None;
        }
        let late = now.saturating_duration_since(due);
        let skipped = self.missed(start, now);
        self.skip(skipped);
        if matches!(self.policy, OverrunPolicy::Shift) {
            (self.start, self.number) = (Some(now), 0);
        }
        self.overruns += 1;
        Some(Overrun { late, skipped })
    }

    /// Whether the loop ends after an overrun.
    #[must_use]
    pub const fn aborts(&self) -> bool {
        matches!(self.policy, OverrunPolicy::Abort)
    }
}

/// Formats one line: cycles, overruns, jitter, execution time.
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
