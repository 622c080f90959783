//! What the framework remembers of one component from cycle to cycle.

use core::cell::Cell;

use embassy_time::{Duration, Instant};

use crate::rate::REST;

/// In place of a state: never active.
const NEVER: u16 = u16::MAX;
/// In place of a state: no state machine.
const NONE: u16 = u16::MAX - 1;

/// Times and state of one component, in ticks of the clock.
pub struct Clock {
    /// The last point of the grid on which the component runs.
    grid: Cell<u64>,
    /// The last run.
    ran: Cell<u64>,
    /// When the state was entered.
    entered: Cell<u64>,
    state: Cell<u16>,
}

impl Clock {
    pub(crate) const fn new() -> Self {
        Self { grid: Cell::new(0), ran: Cell::new(0), entered: Cell::new(0), state: Cell::new(NEVER) }
    }

    /// Starts the grid here.
    #[inline]
    pub(crate) fn anchor(&self, now: Instant) {
        self.grid.set(now.as_ticks());
        self.ran.set(now.as_ticks());
    }

    /// Whether a run is due, and if so moves the grid on.
    ///
    /// Late by less than a period keeps the grid; later than that starts it anew from now. So does a clock that was set
    /// back by more than a period behind the grid.
    #[inline]
    pub(crate) fn due(&self, now: Instant, period: u64) -> bool {
        if period == 0 {
            return true;
        }
        let (now, grid) = (now.as_ticks(), self.grid.get());
        if now < grid {
            return self.set_back(now, period);
        }
        let elapsed = now - grid;
        if elapsed < period || period == REST {
            return false;
        }
        let late = elapsed - period;
        self.grid.set(if late < period { grid + period } else { now });
        true
    }

    #[cold]
    fn set_back(&self, now: u64, period: u64) -> bool {
        let anew = self.grid.get() - now > period;
        if anew {
            self.grid.set(now);
        }
        anew
    }

    /// Notes a run.
    #[inline]
    pub(crate) fn ran(&self, now: Instant) {
        self.ran.set(now.as_ticks());
    }

    #[inline]
    pub(crate) fn since_run(&self, now: Instant) -> Duration {
        Duration::from_ticks(now.as_ticks().saturating_sub(self.ran.get()))
    }

    /// The time in the state; a clock that was set back to before the entry counts it from now.
    #[inline]
    pub(crate) fn in_state(&self, now: Instant) -> Duration {
        let (now, entered) = (now.as_ticks(), self.entered.get());
        if now < entered {
            self.entered.set(now);
            return Duration::from_ticks(0);
        }
        Duration::from_ticks(now - entered)
    }

    /// When the state was entered, if the component was ever active.
    pub(crate) fn since(&self) -> Option<Instant> {
        (self.state.get() != NEVER).then(|| Instant::from_ticks(self.entered.get()))
    }

    /// Enters a state, or none at all, and counts the time in it from now.
    #[inline]
    pub(crate) fn enter(&self, state: Option<usize>, now: Instant) {
        self.state.set(state.map_or(NONE, |index| index as u16));
        self.entered.set(now.as_ticks());
    }

    /// Index of the state that an active machine is in.
    #[inline]
    pub(crate) fn place(&self) -> usize {
        self.state.get() as usize
    }

    /// Index of the state that the machine is in, or was in when it became latent.
    #[inline]
    pub(crate) fn state(&self) -> Option<usize> {
        let state = self.state.get();
        (state < NONE).then_some(state as usize)
    }
}
