//! What all components of a tree share in a cycle.

use core::cell::Cell;

use embassy_time::Instant;

use super::activation::Parity;
use super::component_state::{ComponentState, Policy};
use crate::rate::Period;

/// Number of cycles after a transition or hold change in which the active set is rechecked. It is two because in the
/// first one the requirements of the state that was left are still active.
const RECHECKED: u8 = 2;

/// The time and the parity of a cycle, and whether the active set may differ from that of the previous cycle.
#[derive(PartialEq)]
pub(crate) struct CycleState {
    now: Cell<u64>,
    parity: Cell<Parity>,
    /// Parity of the previous cycle, and of the next one.
    previous: Cell<Parity>,
    /// Number of cycles in which the active set is still to be rechecked.
    recheck: Cell<u8>,
    /// Whether the last tick unwound.
    interrupted: Cell<bool>,
}

/// Outcome of a visit, as bits: asking for one of them takes one instruction.
#[derive(Clone, Copy)]
pub struct VisitOutcome(u8);

impl VisitOutcome {
    /// The component is not to be visited: it was visited in this cycle, or it is held latent.
    pub const CLOSED: Self = Self(0);
    /// The component stays active and is not due.
    pub(crate) const WAITING: Self = Self(1);
    /// The component stays active and is due.
    pub const DUE: Self = Self(1 | 2);
    /// The component became active in the state in which it became latent.
    const RESUMED: Self = Self(1 | 2 | 4);
    /// The component became active in its initial state.
    const ENTERED: Self = Self(1 | 2 | 4 | 8);

    /// Whether the visit ends here.
    #[inline]
    #[must_use]
    pub const fn is_closed(self) -> bool {
        self.0 == Self::CLOSED.0
    }

    /// Whether the component is to run.
    #[inline]
    #[must_use]
    pub const fn is_due(self) -> bool {
        self.0 & 2 != 0
    }

    /// Whether the component became active.
    #[inline]
    pub(crate) const fn is_started(self) -> bool {
        self.0 & 4 != 0
    }

    /// Whether a state machine begins in its initial state.
    #[inline]
    #[must_use]
    pub const fn is_entering(self) -> bool {
        self.0 & 8 != 0
    }
}

impl CycleState {
    pub(crate) const fn new() -> Self {
        Self {
            now: Cell::new(0),
            parity: Cell::new(Parity::EVEN),
            previous: Cell::new(Parity::ODD),
            recheck: Cell::new(0),
            interrupted: Cell::new(false),
        }
    }

    pub(crate) fn copy_from(&self, other: &Self) {
        self.now.set(other.now.get());
        self.parity.set(other.parity.get());
        self.previous.set(other.previous.get());
        self.recheck.set(other.recheck.get());
        self.interrupted.set(other.interrupted.get());
    }

    /// Begins a cycle.
    #[inline]
    pub(crate) fn begin(&self, now: Instant) {
        self.now.set(now.as_ticks());
        self.parity.swap(&self.previous);
    }

    #[inline]
    pub(crate) fn now(&self) -> Instant {
        Instant::from_ticks(self.now.get())
    }

    #[inline]
    pub(crate) fn parity(&self) -> Parity {
        self.parity.get()
    }

    #[inline]
    pub(crate) fn previous(&self) -> Parity {
        self.previous.get()
    }

    /// Records that the active set may change.
    #[inline]
    pub(crate) fn request_recheck(&self) {
        self.recheck.set(RECHECKED);
    }

    /// Returns whether the active set may have changed in this cycle. If no machine changed its state and no hold
    /// changed, the same components are visited as in the previous cycle.
    #[inline]
    pub(crate) fn takes_recheck(&self) -> bool {
        let left = self.recheck.get();
        if left > 0 {
            self.recheck.set(left - 1);
        }
        left > 0
    }

    /// Records that the tick unwinds.
    pub(crate) fn interrupt(&self) {
        self.interrupted.set(true);
    }

    /// Returns whether the last tick unwound, once.
    pub(crate) fn takes_interruption(&self) -> bool {
        self.interrupted.replace(false)
    }

    /// Returns the outcome of a visit in all cases; a component that was latent starts.
    #[cold]
    #[inline(never)]
    pub(crate) fn visit(&self, state: &ComponentState, period: &Period, policy: &Policy) -> VisitOutcome {
        let (parity, activation, now) = (self.parity(), state.activation(), self.now.get());
        if activation.is_closed(parity) {
            return VisitOutcome::CLOSED;
        }
        let goes_on = activation.is_awaited(self.previous());
        activation.visit(parity);
        match goes_on {
            true if state.is_due(now, period, policy.tolerance) => VisitOutcome::DUE,
            true => VisitOutcome::WAITING,
            false if state.start(now, policy) => VisitOutcome::ENTERED,
            false => VisitOutcome::RESUMED,
        }
    }
}
