//! Ours made slower on purpose, to see every gate fail.

use std::hint::black_box;

use bica::Probe;

/// A probe that dawdles at the end of every cycle, more than in proportion to the `N` components of the tree.
pub struct Dawdle<const N: u32>;

impl<const N: u32> Probe for Dawdle<N> {
    fn cycle_end(&mut self) {
        for turn in 0..N * N * 4 {
            black_box(turn);
        }
    }
}
