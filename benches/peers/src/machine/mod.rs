//! A machine of five states in a ring, each with its own code. Three states are left on a condition, two by a timer.
//!
//! A step first tries the transition out of the current state. Then it runs the code of the state, which is the new one
//! after a transition.

mod by_hand;
mod smlang;
mod statig;

pub use by_hand::ByHand;
pub use smlang::Smlang;
pub use statig::Statig;

use crate::part;
use crate::subject::CYCLE_US;

/// Duration of state B, ms.
pub const B_MS: u32 = 50;
/// Duration of state D, ms.
pub const D_MS: u32 = 30;

const B_US: u64 = B_MS as u64 * 1000;
const D_US: u64 = D_MS as u64 * 1000;

/// Input of the machine at `now`, µs.
#[inline]
#[must_use]
pub const fn input(now: u64) -> u32 {
    (now / CYCLE_US) as u32
}

/// Applies the code of a state, given by its index in the ring, to the number.
#[inline]
#[must_use]
pub fn work<const STATE: usize>(number: u64) -> u64 {
    let factor = [31, 37, 41, 43, 47][STATE];
    part::work(number.wrapping_mul(factor).wrapping_add(STATE as u64 + 1))
}
