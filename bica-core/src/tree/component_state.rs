//! What the framework stores of one component from cycle to cycle.

use core::cell::Cell;

use embassy_time::{Duration, Instant};

use super::activation::Activation;
use crate::rate::{Grid, Period, Tolerance};

/// In place of a state index: the component was never active, or its history was discarded.
const NEVER: u16 = u16::MAX;
/// In place of a state index: the component has no states.
const STATELESS: u16 = u16::MAX - 1;
/// Bits of a state index: a machine has at most 255 states.
const INDEX: u16 = 0xff;
/// Added to a state index: the machine begins anew in its next visit, because its activator entered a state that asks for its result.
const ANEW: u16 = 1 << 8;
/// Added to a state index: one transition with `times` that was taken. There are at most 126, so that no sum is [`STATELESS`].
const TAKEN: u16 = 1 << 9;

/// How a component starts and how exactly it keeps its rate: constant for each component of a tree.
#[derive(Clone, Copy)]
pub(crate) struct Policy {
    initial: u16,
    resume: bool,
    pub(crate) tolerance: Tolerance,
}

impl Policy {
    /// `initial` is the index of the initial state; `resume` keeps the state in which the component became latent.
    pub(crate) const fn new(initial: Option<usize>, resume: bool, tolerance: Tolerance) -> Self {
        let initial = match initial {
            Some(index) => index as u16,
            None => STATELESS,
        };
        Self { initial, resume, tolerance }
    }

    /// Index of the initial state of a state machine.
    pub(crate) const fn initial(&self) -> usize {
        self.initial as usize
    }
}

/// Times, in clock ticks, state and activation of one component.
pub struct ComponentState {
    /// Whole ticks of the grid.
    origin: Cell<u64>,
    /// Instant of the last run.
    ran: Cell<u64>,
    /// Instant at which the state was entered.
    entered: Cell<u64>,
    /// Fraction of a tick of the grid; it lies here and not in a struct with the whole ticks, which would need padding.
    fraction: Cell<u32>,
    state: Cell<u16>,
    activation: Activation,
}

impl ComponentState {
    pub(crate) const fn new() -> Self {
        Self {
            origin: Cell::new(0),
            ran: Cell::new(0),
            entered: Cell::new(0),
            fraction: Cell::new(0),
            state: Cell::new(NEVER),
            activation: Activation::new(),
        }
    }

    #[inline]
    pub(crate) const fn activation(&self) -> &Activation {
        &self.activation
    }

    #[inline]
    pub(crate) const fn grid(&self) -> Grid<'_> {
        Grid { origin: &self.origin, fraction: &self.fraction }
    }

    /// Starts the grid at `now`, and enters the initial state unless the component resumes one; returns whether it
    /// entered.
    #[inline]
    pub(crate) fn start(&self, now: u64, policy: &Policy) -> bool {
        self.grid().start(now, policy.tolerance);
        self.ran.set(now);
        let entering = !policy.resume || self.state().is_none();
        if entering {
            self.state.set(policy.initial);
            self.entered.set(now);
        }
        entering
    }

    /// Starts the grid at `now` and enters the initial state, whether the component resumes one or not.
    pub(crate) fn restart(&self, now: u64, policy: &Policy) {
        self.discard_history();
        self.start(now, policy);
    }

    /// Discards the state, so that the component starts as if it had never been active.
    pub(crate) fn discard_history(&self) {
        self.state.set(NEVER);
    }

    /// Returns whether a run is due, and if so moves the grid on.
    #[inline]
    pub(crate) fn is_due(&self, now: u64, period: &Period, tolerance: Tolerance) -> bool {
        self.grid().is_due(now, period, tolerance)
    }

    /// Records a run.
    #[inline]
    pub(crate) fn record_run(&self, now: Instant) {
        self.ran.set(now.as_ticks());
    }

    #[inline]
    pub(crate) fn since_run(&self, now: Instant) -> Duration {
        Duration::from_ticks(now.as_ticks().saturating_sub(self.ran.get()))
    }

    /// Returns the time in the state, exact to a tick. If the clock was set back to before the entry, the time counts
    /// from now on.
    #[inline]
    pub(crate) fn in_state(&self, now: Instant) -> Duration {
        let (now, entered) = (now.as_ticks(), self.entered.get());
        if now < entered {
            self.entered.set(now);
            return Duration::from_ticks(0);
        }
        Duration::from_ticks(now - entered)
    }

    /// Whether the component has been in its state for at least `ms` milliseconds.
    #[inline]
    pub(crate) fn has_been_in_state(&self, ms: u32, now: Instant) -> bool {
        self.in_state(now) >= Duration::from_millis(ms as u64)
    }

    /// Returns when the state was entered; `None` if the component was never active.
    pub(crate) fn since(&self) -> Option<Instant> {
        (self.state.get() != NEVER).then(|| Instant::from_ticks(self.entered.get()))
    }

    /// Enters a state and counts the time in it from now on.
    #[inline]
    pub(crate) fn enter(&self, state: usize, now: Instant) {
        self.state.set(state as u16);
        self.entered.set(now.as_ticks());
    }

    /// Returns the index of the state of an active state machine that takes no transition with `times`.
    #[inline]
    pub(crate) fn state_index(&self) -> usize {
        self.state.get() as usize
    }

    /// Returns the index of the state of an active state machine, and how many transitions with `times` it took in a row.
    #[inline]
    pub(crate) fn counted_state(&self) -> (usize, u8) {
        let state = self.state.get();
        (usize::from(state & INDEX), (state / TAKEN) as u8)
    }

    /// Sets how many transitions with `times` the active state machine took in a row.
    #[inline]
    pub(crate) fn count(&self, taken: u8) {
        self.state.set((self.state.get() & INDEX) | (u16::from(taken) * TAKEN));
    }

    /// Makes a machine begin anew in its next visit; from now on it has no result.
    pub(crate) fn begin_anew(&self) {
        if self.state().is_some() {
            self.state.set(self.state.get() | ANEW);
        }
    }

    /// Whether the machine is to begin anew.
    pub(crate) fn begins_anew(&self) -> bool {
        self.state().is_some() && self.state.get() & ANEW != 0
    }

    /// Returns the index of the state of a state machine, also of a latent one; `None` without states.
    #[inline]
    pub(crate) fn state(&self) -> Option<usize> {
        let state = self.state.get();
        (state < STATELESS).then_some(usize::from(state & INDEX))
    }
}
