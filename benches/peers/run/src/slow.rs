//! Artificial slowdown of BICA, which shows that each check of a claim can fail.

use std::hint::black_box;

use bica::Probe;

/// Probe that takes time at the end of every cycle, quadratic in the number `N` of components and longer than a step.
pub struct SlowProbe<const N: u32>;

impl<const N: u32> Probe for SlowProbe<N> {
    fn cycle_end(&mut self) {
        for iteration in 0..N * N * 4 + 60 {
            black_box(iteration);
        }
    }
}
