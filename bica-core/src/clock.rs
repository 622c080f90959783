//! What the framework remembers of one component from cycle to cycle.

use core::cell::Cell;

use embassy_time::{Duration, Instant};

use crate::mark::Mark;
use crate::pulse::Pulse;
use crate::rate::REST;

/// In place of a state: never active.
const NEVER: u16 = u16::MAX;
/// In place of a state: no state machine.
const NONE: u16 = u16::MAX - 1;

/// How a component becomes active.
#[derive(Clone, Copy)]
pub(crate) struct Begin {
    initial: u16,
    resume: bool,
}

impl Begin {
    /// In a state, if it has any; or in the state in which it became latent, if it resumes.
    pub(crate) const fn new(initial: Option<usize>, resume: bool) -> Self {
        Self { initial: place(initial), resume }
    }
}

const fn place(state: Option<usize>) -> u16 {
    match state {
        Some(index) => index as u16,
        None => NONE,
    }
}

/// Times and state of one component, in ticks of the clock.
pub struct Clock {
    /// The last point of the grid on which the component runs.
    grid: Cell<u64>,
    /// The last run.
    ran: Cell<u64>,
    /// When the state was entered.
    entered: Cell<u64>,
    state: Cell<u16>,
    /// It has nothing to do with time, but there is room for it here.
    mark: Mark,
}

impl Clock {
    pub(crate) const fn new() -> Self {
        Self {
            grid: Cell::new(0),
            ran: Cell::new(0),
            entered: Cell::new(0),
            state: Cell::new(NEVER),
            mark: Mark::new(),
        }
    }

    /// Whether the component is active.
    #[inline]
    pub(crate) const fn mark(&self) -> &Mark {
        &self.mark
    }

    /// Starts the grid here, and enters the first state unless it resumes one; whether it entered.
    #[inline]
    pub(crate) fn begin(&self, now: Instant, begin: Begin) -> bool {
        self.grid.set(now.as_ticks());
        self.ran.set(now.as_ticks());
        let entering = !begin.resume || self.state().is_none();
        if entering {
            self.enter_at(begin.initial, now);
        }
        entering
    }

    /// Whether a run is due, and if so moves the grid on.
    ///
    /// Late by less than a period keeps the grid; later than that starts it anew from now. So does a clock that was set
    /// back by more than a period behind the grid.
    #[expect(clippy::trivially_copy_pass_by_ref, reason = "a period takes two registers of a small processor")]
    #[inline]
    pub(crate) fn due(&self, pulse: &Pulse, period: &u64) -> bool {
        let (now, period, grid) = (pulse.now().as_ticks(), *period, self.grid.get());
        let Some(elapsed) = now.checked_sub(grid) else { return self.jumped(now, period) };
        if elapsed < period {
            return false;
        }
        if elapsed - period < period && period != REST {
            self.grid.set(grid + period);
            return true;
        }
        self.jumped(now, period)
    }

    /// Whether a run is due by a clock that was set back, or is more than two periods after the grid.
    #[cold]
    #[inline(never)]
    fn jumped(&self, now: u64, period: u64) -> bool {
        if period == 0 {
            return true;
        }
        let back = self.grid.get().saturating_sub(now);
        let anew = period != REST && (back == 0 || back > period);
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

    /// Enters a state and counts the time in it from now.
    #[inline]
    pub(crate) fn enter(&self, state: usize, now: Instant) {
        self.enter_at(place(Some(state)), now);
    }

    fn enter_at(&self, place: u16, now: Instant) {
        self.state.set(place);
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
