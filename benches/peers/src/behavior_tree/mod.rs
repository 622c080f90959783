//! Ten leaves of a behavior tree: a sequence, and a reactive fallback.
//!
//! In each cycle one leaf works. In the sequence a leaf succeeds after [`STEPS`] steps, and the next one begins in the same
//! cycle; the last is followed by the first. In the fallback all leaves fail but the one whose turn it is, for
//! [`TURN`] cycles; it is found anew in each cycle.

mod bonsai;
mod by_hand;

pub use bonsai::Bonsai;
pub use by_hand::ByHand;

use crate::part;
use crate::subject::CYCLE_US;

/// Number of leaves.
pub const LEAVES: usize = 10;
/// Cycles of a leaf's turn in the fallback.
pub const TURN: u64 = 7;
/// Steps of a leaf in the sequence.
pub const STEPS: u32 = 3;

/// Leaf whose turn it is in the fallback at `now`, µs.
#[inline]
#[must_use]
pub const fn turn(now: u64) -> usize {
    (now / CYCLE_US / TURN) as usize % LEAVES
}

/// Applies the code of a leaf to the number.
#[inline]
#[must_use]
pub fn work(leaf: usize, number: u64) -> u64 {
    part::work(number.wrapping_mul(31).wrapping_add(leaf as u64 + 1))
}
