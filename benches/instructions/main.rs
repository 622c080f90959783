//! Instruction counts that CI checks, taken by valgrind.
//!
//! `cargo xtask budget` counts and compares with `benches/instructions.txt`. Counts do not depend on time. To make them
//! independent of the computer too, `GLIBC_TUNABLES` disables the variants of C library functions that are specific to
//! a processor.

mod body;
mod forward;
mod framework;
mod slow;
mod vision;

use gungraun::prelude::*;

use body::motion;
use forward::{components, whole_loop};
use framework::trees as framework_trees;
use vision::frames;

/// Without these features glibc uses its baseline functions for x86-64.
const PLAIN: &str =
    "glibc.cpu.hwcaps=-AVX2,-AVX512F,-AVX512VL,-ERMS,-FSRM,-AVX_Fast_Unaligned_Load,-BMI2,-SSE4_2,-SSSE3";

gungraun::main!(
    config = LibraryBenchmarkConfig::default().env("GLIBC_TUNABLES", PLAIN);
    library_benchmark_groups = framework_trees, motion, components, whole_loop, frames
);
