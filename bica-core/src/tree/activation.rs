//! Whether one component is active.

use core::cell::Cell;

use crate::hold::Hold;

/// Parity of a cycle: cycles alternate between the two values.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) struct Parity(u8);

impl Parity {
    pub(crate) const EVEN: Self = Self(0);
    pub(crate) const ODD: Self = Self(1);
}

/// Not active. This and the following values stand in place of a parity.
const LATENT: u8 = 2;
/// Not active, and held latent.
const HELD_LATENT: u8 = 3;
/// Active in the last cycle and held latent since then: it stops in the next cycle.
const LEAVING: u8 = 4;
/// Active when a tick unwound: it stops at the beginning of the next tick.
const INTERRUPTED: u8 = 5;

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

    /// Whether the component was active in the previous cycle, which had that parity, and is not visited yet in this one.
    #[inline]
    pub(crate) fn is_awaited(&self, previous: Parity) -> bool {
        self.value.get() == previous.0
    }

    /// Whether the component was visited in the cycle of that parity, this one or the last one.
    #[inline]
    pub(crate) fn was_visited(&self, parity: Parity) -> bool {
        self.value.get() == parity.0
    }

    /// Whether a visit ends here: the component was visited in this cycle, or it is held latent.
    #[inline]
    pub(crate) fn is_closed(&self, parity: Parity) -> bool {
        self.was_visited(parity) || matches!(self.value.get(), HELD_LATENT | LEAVING)
    }

    /// Records a visit.
    #[inline]
    pub(crate) fn visit(&self, parity: Parity) {
        self.value.set(parity.0);
    }

    /// Makes a component latent that was active in the previous cycle and was not visited in this one; returns whether
    /// it did.
    pub(crate) fn end_unless_visited(&self, previous: Parity) -> bool {
        let ends = self.value.get() == LEAVING || self.is_awaited(previous);
        if ends {
            self.end();
        }
        ends
    }

    /// Records that a tick unwound while the component was active, if it was.
    pub(crate) fn interrupt(&self) {
        if !matches!(self.value.get(), LATENT | HELD_LATENT) {
            self.value.set(INTERRUPTED);
        }
    }

    /// Makes a component latent that was active when a tick unwound; returns whether it was.
    pub(crate) fn end_if_interrupted(&self) -> bool {
        let ends = self.value.get() == INTERRUPTED;
        if ends {
            self.end();
        }
        ends
    }

    fn end(&self) {
        self.value.set(if self.hold.get() == Hold::Latent { HELD_LATENT } else { LATENT });
    }

    /// Returns, between two cycles, whether the component was visited in the last one.
    pub(crate) fn is_active(&self, last: Parity) -> bool {
        self.was_visited(last) || matches!(self.value.get(), LEAVING | INTERRUPTED)
    }

    pub(crate) fn copy_from(&self, other: &Self) {
        self.value.set(other.value.get());
        self.hold.set(other.hold.get());
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
            (_, true) => last.0,
            (_, false) => LATENT,
        };
        self.value.set(after);
        self.hold.set(hold);
    }
}
