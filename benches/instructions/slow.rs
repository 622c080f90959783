//! What is counted made slower on purpose, to see every gate fail.

use std::hint::black_box;

/// `cargo xtask budget --slow` asks for it when this is compiled: what is counted otherwise holds no trace of it.
const SLOW: bool = option_env!("BICA_SLOW").is_some();

/// Dawdles, if that is asked for, more than in proportion to `size`.
#[inline(always)]
pub(crate) fn dawdle(size: usize) {
    if SLOW {
        for turn in 0..4 * size * size {
            black_box(turn);
        }
    }
}
