//! What all components of a tree have in common in a cycle.

use core::cell::Cell;

use embassy_time::Instant;

use crate::clock::{Begin, Clock};
use crate::mark::Beat;

/// For so many cycles what is active may change after a machine's state, or a hold, has: in the first, what the old
/// state required is still active.
const UNSETTLED: u8 = 2;

/// The time and the beat of a cycle, and whether what is active may differ from the cycle before.
pub(crate) struct Pulse {
    now: Cell<u64>,
    beat: Cell<Beat>,
    /// The beat of the cycle before, and of the next.
    before: Cell<Beat>,
    unsettled: Cell<u8>,
}

/// What a visit finds: bits, so that the code that asks for one of them is there once.
#[derive(Clone, Copy)]
pub(crate) struct Found(u8);

impl Found {
    /// It is not to be visited, or was in this cycle.
    pub(crate) const CLOSED: Self = Self(0);
    /// It goes on and is not due.
    pub(crate) const WAITING: Self = Self(1);
    /// It goes on and is due.
    pub(crate) const DUE: Self = Self(1 | 2);
    /// It became active, in the state in which it became latent.
    const RESUMED: Self = Self(1 | 2 | 4);
    /// It became active, as new.
    const ENTERED: Self = Self(1 | 2 | 4 | 8);

    #[inline]
    pub(crate) const fn is_closed(self) -> bool {
        self.0 == Self::CLOSED.0
    }

    #[inline]
    pub(crate) const fn is_due(self) -> bool {
        self.0 & 2 != 0
    }

    #[inline]
    pub(crate) const fn began(self) -> bool {
        self.0 & 4 != 0
    }

    #[inline]
    pub(crate) const fn entered(self) -> bool {
        self.0 & 8 != 0
    }
}

impl Pulse {
    pub(crate) const fn new() -> Self {
        Self {
            now: Cell::new(0),
            beat: Cell::new(Beat::FIRST),
            before: Cell::new(Beat::SECOND),
            unsettled: Cell::new(0),
        }
    }

    /// Begins a cycle.
    #[inline]
    pub(crate) fn begin(&self, now: Instant) {
        self.now.set(now.as_ticks());
        self.beat.swap(&self.before);
    }

    #[inline]
    pub(crate) fn now(&self) -> Instant {
        Instant::from_ticks(self.now.get())
    }

    #[inline]
    pub(crate) fn beat(&self) -> Beat {
        self.beat.get()
    }

    #[inline]
    pub(crate) fn before(&self) -> Beat {
        self.before.get()
    }

    /// What is active may change.
    #[inline]
    pub(crate) fn unsettle(&self) {
        self.unsettled.set(UNSETTLED);
    }

    /// Whether it may have changed in this cycle: if no machine changed its state and nobody its hold, the same are
    /// visited as in the cycle before.
    #[inline]
    pub(crate) fn may_have_changed(&self) -> bool {
        let left = self.unsettled.get();
        if left > 0 {
            self.unsettled.set(left - 1);
        }
        left > 0
    }

    /// What a visit of a component finds in all cases; it becomes active if it was not.
    #[expect(clippy::trivially_copy_pass_by_ref, reason = "a period takes two registers of a small processor")]
    #[cold]
    #[inline(never)]
    pub(crate) fn look(&self, clock: &Clock, period: &u64, begin: Begin) -> Found {
        let (beat, mark) = (self.beat(), clock.mark());
        if mark.is_closed(beat) {
            return Found::CLOSED;
        }
        let goes_on = mark.is_awaited(self.before());
        mark.visit(beat);
        match goes_on {
            true if clock.due(self, period) => Found::DUE,
            true => Found::WAITING,
            false if clock.begin(self.now(), begin) => Found::ENTERED,
            false => Found::RESUMED,
        }
    }
}
