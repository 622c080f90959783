//! Instructions of what CI gates, counted by valgrind.
//!
//! `cargo xtask budget` counts, and compares with `benches/instructions.txt`. Nothing here depends on the time, and so
//! that nothing depends on the computer either, the C library is told to use none of its copies of a function that are
//! made for some processor.

#[path = "../support/alone.rs"]
mod alone;
mod body;
mod eyes;
mod forward;
mod framework;
#[path = "../../tests/forward/game.rs"]
mod game;
#[path = "../support/recording.rs"]
mod recording;
#[path = "../vision/rendered.rs"]
mod rendered;
#[path = "../vision/shot.rs"]
#[expect(dead_code, reason = "benchmarks of time name frames and sizes")]
mod shot;
mod slow;
#[path = "../trees/mod.rs"]
mod trees;
#[path = "../vision/worst.rs"]
#[expect(dead_code, reason = "benchmarks of time look at all of these frames")]
mod worst;

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
