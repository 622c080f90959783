//! Artificial slowdown, which shows that each check of the instruction counts can fail.

use std::hint::black_box;

/// Whether `benches/scripts/budget.py --slow` compiles this program; otherwise no instruction of the slowdown is compiled in.
const SLOW: bool = option_env!("BICA_SLOW").is_some();

/// Executes additional instructions, quadratic in `size`, if the slowdown is compiled in.
#[inline(always)]
pub(crate) fn slow_down(size: usize) {
    if SLOW {
        for iteration in 0..4 * size * size {
            black_box(iteration);
        }
    }
}
