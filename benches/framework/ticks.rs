//! Repeated ticks of a tree.

use std::hint::black_box;

use bica::{Instant, Tree};
use criterion::Bencher;

/// Ticks a tree in steps of 1 ms.
pub(crate) fn ticks(bencher: &mut Bencher<'_>, tree: &mut impl Tree) {
    let mut now = 0;
    bencher.iter(|| {
        now += 1;
        black_box(&mut *tree).tick(Instant::from_millis(now));
    });
}
