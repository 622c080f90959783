//! Whether one component is active.

use core::cell::Cell;

use crate::hold::Hold;

/// Parity of a cycle: cycles alternate between the two values.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) struct Parity(u8);

impl Parity {
    pub(crate) const EVEN: Self = Self(0);
    pub(crate) const ODD: Self = Self(1);

    /// The parity of the next cycle, and of the previous one.
    #[inline]
    pub(crate) const fn other(self) -> Self {
        Self(self.0 ^ 1)
    }
}

/// Not active. This and the following values stand in place of a parity.
const LATENT: u8 = 2;
/// Not active, and held latent.
const HELD_LATENT: u8 = 3;
/// Active in the last cycle and held latent since then: it stops in the next cycle.
const LEAVING: u8 = 4;
/// Active when a tick unwound: it stops at the beginning of the next tick.
const INTERRUPTED: u8 = 5;

/// Added to a parity: the next visit reads the component's period.
///
/// A component that declares no rate runs in every cycle as long as nothing borrows its rate. So its visit compares one
/// byte and reads no period. A visit that makes a component active reads the period in any case.
const READS_PERIOD: u8 = 8;

/// Added to any value: the component is visited at the end of the cycle.
const DEFERRED: u8 = 16;

/// Activation of one component: the parity of the last cycle that visited it while it is active, or why it is not.
///
/// It is a byte for each component and not a bit, so that the processor can write those of two components
/// independently. A component that is not visited any more loses its parity at the end of the cycle, so the parity of an
/// old cycle is never taken for that of a new one.
#[derive(PartialEq)]
pub(crate) struct Activation {
    value: Cell<u8>,
    hold: Cell<Hold>,
}

impl Activation {
    pub(crate) const fn new() -> Self {
        Self { value: Cell::new(LATENT), hold: Cell::new(Hold::Tree) }
    }

    /// Records a visit if the component was active in the previous cycle, which had that parity, is not visited yet in
    /// this one, and need not read the period; returns whether it did.
    #[inline]
    pub(crate) fn visits_as_before(&self, previous: Parity) -> bool {
        let usual = self.value.get() == previous.0;
        if usual {
            self.value.set(previous.other().0);
        }
        usual
    }

    /// Whether the component was visited in the cycle of that parity, this one or the last one.
    #[inline]
    fn was_visited(&self, parity: Parity) -> bool {
        self.value.get() & !READS_PERIOD == parity.0
    }

    /// Whether the component is latent and not held so.
    #[inline]
    pub(crate) fn is_latent(&self) -> bool {
        self.value.get() == LATENT
    }

    /// Whether the component was visited in this cycle and its next visit need not read the period. It is faster than
    /// [`is_closed`](Self::is_closed), and never true if that is false.
    #[inline]
    pub(crate) fn is_visited_as_before(&self, parity: Parity) -> bool {
        self.value.get() == parity.0
    }

    /// Whether a visit ends here: the component was visited in this cycle, or it is held latent.
    #[inline]
    pub(crate) fn is_closed(&self, parity: Parity) -> bool {
        self.hold.get() == Hold::Latent || self.was_visited(parity)
    }

    /// Records a visit.
    #[inline]
    pub(crate) fn visit(&self, parity: Parity) {
        self.value.set(parity.0);
    }

    /// Whether the component is latent, held so or not.
    pub(crate) fn is_any_latent(&self) -> bool {
        matches!(self.value.get() & !DEFERRED, LATENT | HELD_LATENT)
    }

    /// Makes the next visit read the period, which may change.
    #[inline]
    pub(crate) fn read_period(&self) {
        let value = self.value.get();
        if value & !DEFERRED <= Parity::ODD.0 {
            self.value.set(value | READS_PERIOD);
        }
    }

    /// Makes a component latent that was active in the previous cycle and was not visited in this one; returns whether
    /// it did.
    #[inline]
    pub(crate) fn end_unless_visited(&self, previous: Parity, parity: Parity) -> bool {
        let value = self.value.get();
        // Most components are one or the other.
        if value == LATENT || value == parity.0 {
            return false;
        }
        if value == previous.0 || value == previous.0 | READS_PERIOD {
            self.value.set(LATENT);
            return true;
        }
        if value == LEAVING {
            self.value.set(HELD_LATENT);
        }
        value == LEAVING
    }

    /// Records that a tick unwound while the component was active, if it was.
    pub(crate) fn interrupt(&self) {
        self.takes_deferred();
        if !matches!(self.value.get(), LATENT | HELD_LATENT) {
            self.value.set(INTERRUPTED);
        }
    }

    /// Puts a visit off to the end of the cycle.
    #[inline]
    pub(crate) fn defer(&self) {
        self.value.set(self.value.get() | DEFERRED);
    }

    /// Returns whether a visit was put off in this cycle, once.
    #[inline]
    pub(crate) fn takes_deferred(&self) -> bool {
        let value = self.value.get();
        self.value.set(value & !DEFERRED);
        value & DEFERRED != 0
    }

    /// Makes a component latent that was active when a tick unwound; returns whether it was.
    pub(crate) fn end_if_interrupted(&self) -> bool {
        let ends = self.value.get() == INTERRUPTED;
        if ends {
            self.value.set(if self.hold.get() == Hold::Latent { HELD_LATENT } else { LATENT });
        }
        ends
    }

    /// Returns, between two cycles, whether the component was visited in the last one.
    pub(crate) fn is_active(&self, last: Parity) -> bool {
        self.was_visited(last) || matches!(self.value.get(), LEAVING | INTERRUPTED)
    }

    pub(crate) fn held(&self) -> Hold {
        self.hold.get()
    }

    /// Holds the component, between two cycles.
    pub(crate) fn hold(&self, hold: Hold, last: Parity) {
        let after = match (hold, self.is_active(last)) {
            (_, true) if self.value.get() == INTERRUPTED => INTERRUPTED,
            (Hold::Latent, true) => LEAVING,
            (Hold::Latent, false) => HELD_LATENT,
            // A hold does not change whether the next visit reads the period.
            (_, true) if self.was_visited(last) => self.value.get(),
            (_, true) => last.0 | READS_PERIOD,
            (_, false) => LATENT,
        };
        self.value.set(after);
        self.hold.set(hold);
    }
}
