//! Instructions of what CI gates, counted by valgrind.
//!
//! `cargo xtask budget` counts, and compares with `benches/instructions.txt`. Nothing here depends on the time, and so
//! that nothing depends on the computer either, the C library is told to use none of its copies of a function that are
//! made for some processor.

mod body;
mod eyes;
mod forward;
mod framework;
mod slow;

use gungraun::prelude::*;

use body::motion;
use eyes::frames;
use forward::{components, whole_loop};
use framework::trees as framework_trees;

/// Without them glibc takes what is written for any x86-64.
const PLAIN: &str =
    "glibc.cpu.hwcaps=-AVX2,-AVX512F,-AVX512VL,-ERMS,-FSRM,-AVX_Fast_Unaligned_Load,-BMI2,-SSE4_2,-SSSE3";

gungraun::main!(
    config = LibraryBenchmarkConfig::default().env("GLIBC_TUNABLES", PLAIN);
    library_benchmark_groups = framework_trees, motion, components, whole_loop, frames
);
