//! A machine of five states in a ring, each with code of its own; three are left on a condition, two on a timer.
//!
//! In every step the way out of the state is tried, and then the code of the state runs: the new one's, if it was left.

mod by_hand;
mod smlang;
mod statig;

pub use by_hand::ByHand;
pub use smlang::Smlang;
pub use statig::Statig;

use crate::subject::CYCLE_US;

/// How long state B lasts, ms.
pub const B_MS: u32 = 50;
/// How long state D lasts, ms.
pub const D_MS: u32 = 30;

const B_US: u64 = B_MS as u64 * 1000;
const D_US: u64 = D_MS as u64 * 1000;

/// What the machine sees at `now`, µs.
#[inline]
#[must_use]
pub const fn input(now: u64) -> u32 {
    (now / CYCLE_US) as u32
}

/// What the code of a state does to the number, by the state's place in the ring.
#[inline]
#[must_use]
pub const fn work<const STATE: usize>(number: u64) -> u64 {
    let factor = [31, 37, 41, 43, 47][STATE];
    number.wrapping_mul(factor).wrapping_add(STATE as u64 + 1)
}
