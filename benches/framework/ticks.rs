//! Cycle after cycle.

use std::hint::black_box;

use bica::{Instant, Tree};
use criterion::Bencher;

/// Ticks a tree once a millisecond.
pub(crate) fn ticks(bencher: &mut Bencher<'_>, tree: &mut impl Tree) {
    let mut now = 0;
    bencher.iter(|| {
        now += 1;
        black_box(&mut *tree).tick(Instant::from_millis(now));
    });
}
