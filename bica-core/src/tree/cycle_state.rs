//! What all components of a tree share in a cycle.

use core::cell::Cell;

use embassy_time::Instant;

use super::activation::Parity;
use super::component_state::{ComponentState, Policy};
use crate::hold::Hold;
use crate::rate::Period;

/// Number of cycles after a transition or hold change in which the active set is rechecked. It is two because in the
/// first one the requirements of the state that was left are still active.
const RECHECKED: u8 = 2;
/// In place of 0, or added to the number: components are held active.
const HELD_ACTIVE: u8 = 1 << 7;
/// In place of the index of a component, of which there are at most 255.
const NOBODY: u8 = u8::MAX;

/// The time and the parity of a cycle, and whether the active set may differ from that of the previous cycle.
#[derive(PartialEq)]
pub(crate) struct CycleState {
    now: Cell<u64>,
    parity: Cell<Parity>,
    /// Parity of the previous cycle, and of the next one.
    previous: Cell<Parity>,
    /// Number of cycles in which the active set is still to be rechecked. With [`HELD_ACTIVE`] it is not 0 as long as
    /// components are held active.
    rechecks_left: Cell<u8>,
    /// Whether the last tick unwound.
    interrupted: Cell<bool>,
    /// Whether the next tick is steady.
    steady: Cell<bool>,
    /// Number of components that are held active.
    held_active: Cell<u16>,
    /// Machine that goes to a state in the next cycle, and that state.
    going: Cell<(u8, u8)>,
}

/// Outcome of a visit, as bits: asking for one of them takes one instruction.
#[derive(Clone, Copy)]
pub struct VisitOutcome(u8);

impl VisitOutcome {
    /// The component is not to be visited: it was visited in this cycle, or it is held latent.
    pub const CLOSED: Self = Self(0);
    /// The component stays active and is not due.
    pub const WAITING: Self = Self(1);
    /// The component stays active and is due.
    pub const DUE: Self = Self(1 | 2);
    /// The component became active in the state in which it became latent.
    const RESUMED: Self = Self(1 | 2 | 4);
    /// The component became active in its initial state.
    pub(crate) const ENTERED: Self = Self(1 | 2 | 4 | 8);

    /// Whether the visit ends here.
    #[inline]
    #[must_use]
    pub const fn is_closed(self) -> bool {
        self.0 & 1 == 0
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
    /// With `rechecked` the active set is rechecked in the first cycle.
    pub(crate) const fn new(rechecked: bool) -> Self {
        Self {
            now: Cell::new(0),
            parity: Cell::new(Parity::EVEN),
            previous: Cell::new(Parity::ODD),
            rechecks_left: Cell::new(rechecked as u8),
            interrupted: Cell::new(false),
            steady: Cell::new(false),
            held_active: Cell::new(0),
            going: Cell::new((NOBODY, 0)),
        }
    }

    /// Records that a machine goes to a state in the next cycle, which takes the recheck; returns false if another one does.
    pub(crate) fn goes(&self, component: usize, state: usize) -> bool {
        let (other, _) = self.going.get();
        let accepts = other == NOBODY || usize::from(other) == component;
        if accepts {
            self.going.set((component as u8, state as u8));
            self.request_recheck();
        }
        accepts
    }

    /// Forgets the machine that did not go, because it was not visited or began in this cycle.
    pub(crate) fn ends_going(&self) {
        self.going.set((NOBODY, 0));
    }

    /// Whether the machine goes to a state.
    #[inline]
    pub(crate) fn is_going(&self, component: usize) -> bool {
        usize::from(self.going.get().0) == component
    }

    /// Returns the state to which the machine goes, once.
    pub(crate) fn takes_going(&self) -> usize {
        self.going.replace((NOBODY, 0)).1.into()
    }

    /// Begins a cycle. If the tree `keeps_parity`, a steady tick has the parity of the previous one.
    #[inline]
    pub(crate) fn begin(&self, now: Instant, keeps_parity: bool) {
        self.now.set(now.as_ticks());
        if !(keeps_parity && self.steady.get()) {
            self.parity.swap(&self.previous);
        }
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
        self.rechecks_left.set(RECHECKED);
    }

    /// Records how a component is held, which the active set depends on.
    pub(crate) fn hold(&self, before: Hold, hold: Hold) {
        let is_active = |hold| u16::from(hold == Hold::Active);
        self.held_active.set(self.held_active.get() + is_active(hold) - is_active(before));
        self.request_recheck();
    }

    /// Number of components that are held active.
    pub(crate) fn held_active(&self) -> u16 {
        self.held_active.get()
    }

    /// Whether nothing is left to do after the visit of the root: no component is held active, no machine changed its
    /// state, and no hold changed. Then the same components are visited as in the previous cycle.
    #[inline]
    pub(crate) fn is_settled(&self) -> bool {
        self.rechecks_left.get() == 0
    }

    /// Returns whether the active set may have changed in this cycle, which is not settled.
    pub(crate) fn takes_recheck(&self) -> bool {
        let rechecks_left = self.rechecks_left.get();
        if self.held_active.get() == 0 {
            self.rechecks_left.set(rechecks_left.wrapping_sub(1));
            return true;
        }
        let count = rechecks_left & !HELD_ACTIVE;
        self.rechecks_left.set(HELD_ACTIVE | count.saturating_sub(1));
        count > 0
    }

    /// Whether the tick is steady, or between two cycles whether the next one is.
    #[inline]
    pub(crate) fn is_steady(&self) -> bool {
        self.steady.get()
    }

    pub(crate) fn set_steady(&self, steady: bool) {
        self.steady.set(steady);
    }

    /// Records that the tick unwinds.
    pub(crate) fn interrupt(&self) {
        self.interrupted.set(true);
        self.steady.set(false);
        self.ends_going();
        self.request_recheck();
    }

    /// Whether the last tick unwound.
    #[inline]
    pub(crate) fn is_interrupted(&self) -> bool {
        self.interrupted.get()
    }

    /// Records that what was active when the last tick unwound is stopped.
    pub(crate) fn recover(&self) {
        self.interrupted.set(false);
    }

    /// Returns the outcome of a visit in all cases; a component that was latent starts.
    #[cold]
    #[inline(never)]
    pub(crate) fn visit(&self, state: &ComponentState, period: &Period, policy: &Policy) -> VisitOutcome {
        let (parity, activation, now) = (self.parity(), state.activation(), self.now.get());
        if activation.is_latent() {
            activation.visit(parity);
            return if state.start(now, policy) { VisitOutcome::ENTERED } else { VisitOutcome::RESUMED };
        }
        if activation.is_closed(parity) {
            return VisitOutcome::CLOSED;
        }
        activation.visit(parity);
        if state.is_due(now, period, policy.tolerance) { VisitOutcome::DUE } else { VisitOutcome::WAITING }
    }
}
