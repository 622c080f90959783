//! Whether one component is active.

use core::cell::Cell;

use crate::hold::Hold;

/// Which of two cycles this is: they take turns, the first and the second.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) struct Beat(u8);

impl Beat {
    pub(crate) const FIRST: Self = Self(0);
    pub(crate) const SECOND: Self = Self(1);
}

/// In place of a beat: not active.
const LATENT: u8 = 2;
/// In place of a beat: not active, and held so.
const BARRED: u8 = 3;
/// In place of a beat: held latent since the last cycle, in which it was active.
const LEAVING: u8 = 4;

/// Whether one component is active: the beat of the last cycle in which it was visited, as long as it is.
///
/// A byte for each component and not a bit: the marks of two components are then written without waiting for each
/// other. What is not active any more loses its mark at the end of the cycle, so an old beat is never taken for a new one.
pub(crate) struct Mark {
    seen: Cell<u8>,
    hold: Cell<Hold>,
}

impl Mark {
    pub(crate) const fn new() -> Self {
        Self { seen: Cell::new(LATENT), hold: Cell::new(Hold::Tree) }
    }

    /// Whether it was active in the cycle before, which had that beat, and is not visited yet in this one.
    #[inline]
    pub(crate) fn is_awaited(&self, before: Beat) -> bool {
        self.seen.get() == before.0
    }

    /// Whether it was visited in this cycle.
    #[inline]
    pub(crate) fn was_visited(&self, now: Beat) -> bool {
        self.seen.get() == now.0
    }

    /// Whether a visit ends here: there was one in this cycle, or it is held latent.
    #[inline]
    pub(crate) fn is_closed(&self, now: Beat) -> bool {
        self.was_visited(now) || matches!(self.seen.get(), BARRED | LEAVING)
    }

    /// Notes a visit.
    #[inline]
    pub(crate) fn visit(&self, now: Beat) {
        self.seen.set(now.0);
    }

    /// At the end of a cycle: whether it was active in the one before and is not any more. Says so once.
    pub(crate) fn has_ended(&self, before: Beat) -> bool {
        let after = match self.seen.get() {
            LEAVING => BARRED,
            seen if seen == before.0 => LATENT,
            _ => return false,
        };
        self.seen.set(after);
        true
    }

    /// Between two cycles: whether it was visited in the last one.
    pub(crate) fn is_active(&self, last: Beat) -> bool {
        self.was_visited(last) || self.seen.get() == LEAVING
    }

    pub(crate) fn held(&self) -> Hold {
        self.hold.get()
    }

    /// Between two cycles: holds it.
    pub(crate) fn hold(&self, hold: Hold, last: Beat) {
        let after = match (hold, self.is_active(last)) {
            (Hold::Latent, true) => LEAVING,
            (Hold::Latent, false) => BARRED,
            (_, true) => last.0,
            (_, false) => LATENT,
        };
        self.seen.set(after);
        self.hold.set(hold);
    }
}
