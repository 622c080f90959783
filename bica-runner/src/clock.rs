//! Time of the cycles from the clock of a world, without its steps.

use core::fmt;

use bica_core::{Duration, Instant};

/// Longest time from one cycle to the next; a longer one is a step of the clock.
const LONGEST: Duration = Duration::from_secs(60);

/// Step of a world's clock from one cycle to the next: back, or forth by more than a minute, as of a clock that is set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ClockStep {
    /// Time of the last cycle on the world's clock.
    pub from: Instant,
    /// Time of the cycle on the world's clock.
    pub to: Instant,
}

impl fmt::Display for ClockStep {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let seconds = |instant: Instant| instant.as_micros() as f64 * 1e-6;
        let (from, to) = (seconds(self.from), seconds(self.to));
        write!(f, "the world's clock stepped from {from:.2} s to {to:.2} s; the robot's time goes on without its steps")
    }
}

/// Time of the cycles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Clock {
    last: Option<Instant>,
    /// Ticks from the world's time to that of the cycles, modulo 2⁶⁴.
    offset: u64,
    has_stepped: bool,
}

impl Clock {
    pub(crate) const fn new() -> Self {
        Self { last: None, offset: 0, has_stepped: false }
    }

    /// Returns the time of the cycles at a time of the world.
    pub(crate) const fn at(&self, world: Instant) -> Instant {
        Instant::from_ticks(world.as_ticks().wrapping_add(self.offset))
    }

    /// Begins the cycle at a time of the world, in a tree with this rate; returns the first step of the clock.
    pub(crate) fn begin(&mut self, world: Instant, hz: f32) -> Option<ClockStep> {
        let from = self.last.replace(world)?;
        if (from..=from.saturating_add(LONGEST)).contains(&world) {
            return None;
        }
        let period = Duration::from_micros((1e6 / hz) as u64).as_ticks();
        let next = from.as_ticks().wrapping_add(period);
        self.offset = self.offset.wrapping_add(next.wrapping_sub(world.as_ticks()));
        let is_first = !core::mem::replace(&mut self.has_stepped, true);
        is_first.then_some(ClockStep { from, to: world })
    }
}
