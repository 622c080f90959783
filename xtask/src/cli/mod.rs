//! The command line.

use std::time::Duration;

use clap::{Args, Parser, Subcommand};

const AFTER: &str = "\
What a chore needs beyond Rust it installs, and says so. `cargo xtask help CHORE` tells more of one.

Exit codes: 0 all holds (or what was asked is done), 1 something failed, 2 wrong arguments.";

/// What the command line says.
#[derive(Debug, Parser)]
#[command(
    name = "xtask",
    bin_name = "cargo xtask",
    about = "Chores of the BICA workspace.",
    after_help = AFTER,
    subcommand_value_name = "CHORE",
    subcommand_help_heading = "Chores"
)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) chore: Option<Chore>,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Chore {
    /// Build what runs on a robot for thumbv7em-none-eabihf, without a heap
    ///
    /// Builds every crate that runs on a robot for a Cortex-M, and links the forward without an allocator. Gets the target
    /// first: by rustup, else Debian's Rust and a build of `core` from source.
    NoStd,
    /// Build the image for the microcontroller, boot it in QEMU, play games on it
    ///
    /// Every cycle of the games is thought on the host too, and must come to the same; size, stack and instructions are held
    /// to their limits. Gets the target and QEMU first.
    Firmware(Firmware),
    /// Install what `play --world mujoco` needs
    ///
    /// Puts MuJoCo's library into target/mujoco (from PyPI, with pip), for the feature `mujoco`, and installs EGL with Mesa's
    /// software renderer (with apt).
    Mujoco,
    /// Count the instructions of the benchmarks that are gated, and hold them to benches/instructions.txt
    ///
    /// Each must be within 2 % of its committed count. Gets valgrind (with apt) and gungraun-runner (built once) first.
    Budget(Budget),
    /// Measure what one waits for the compiler
    ///
    /// Times a change to a component until its test has run, and a clean build of the facade, and fails if either takes too
    /// long.
    Buildtime(Buildtime),
    /// Feed any frames to the eyes, and any bytes to the decoder of the robot's link
    ///
    /// Fetches cargo-fuzz into target/ first.
    Fuzz(Fuzz),
    /// Time the eyes beside OpenCV
    ///
    /// Both see the same frames on one core, in turn. Fetches OpenCV into target/ first (needs Python 3), and fails unless the
    /// eyes take a tenth of the time or less.
    Opencv,
    /// Run the framework's tests in Miri, which stops at undefined behaviour
    ///
    /// Installs a nightly compiler that has Miri first (with rustup).
    Miri,
    /// Do the same work in BICA and its peers, and judge what is promised of speed
    ///
    /// Times copper-rs, statig, smlang and other designs beside BICA, and fails if a promise about speed is broken.
    Peers(Peers),
    /// Check all that CI checks, in CI's order
    ///
    /// Format, lints, docs, tests, twenty games, Miri, instructions, MuJoCo, no-std, firmware.
    Ci,
}

#[derive(Debug, Default, Args)]
#[group(multiple = false)]
#[expect(clippy::struct_excessive_bools, reason = "each is an option of its own, and the group lets one be")]
pub(crate) struct Firmware {
    /// Only build the image
    #[arg(long)]
    pub(crate) build: bool,
    /// Tell what takes how much of the flash
    #[arg(long)]
    pub(crate) size: bool,
    /// Take the new figures as right
    #[arg(long)]
    pub(crate) bless: bool,
    /// Damage the link for twice ten minutes, instead of the games
    #[arg(long)]
    pub(crate) fuzz: bool,
}

#[derive(Debug, Default, Args)]
#[group(multiple = false)]
pub(crate) struct Budget {
    /// Take the new counts as right
    #[arg(long)]
    pub(crate) bless: bool,
    /// Count trees and frames made slower on purpose: fails unless every gate does
    #[arg(long)]
    pub(crate) slow: bool,
}

#[derive(Debug, Args)]
pub(crate) struct Buildtime {
    /// What each may take, s, instead of what is promised: to see the gate fail
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    pub(crate) limit: Option<Duration>,
}

#[derive(Debug, Args)]
pub(crate) struct Fuzz {
    /// How long each of the two is fed, s
    #[arg(long, value_name = "N", default_value_t = 60, value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) seconds: u32,
}

#[derive(Debug, Args)]
#[group(multiple = false)]
pub(crate) struct Peers {
    /// A look: one process, few rounds; too few to judge by
    #[arg(long)]
    pub(crate) quick: bool,
    /// A look at BICA made slower on purpose: every promise about time must break
    #[arg(long)]
    pub(crate) slow: bool,
}

fn seconds(text: &str) -> Result<Duration, String> {
    let seconds = text.parse().ok().and_then(|seconds| Duration::try_from_secs_f64(seconds).ok());
    seconds.ok_or_else(|| "a time in seconds is needed, such as 0.1".to_owned())
}

#[cfg(test)]
mod tests;
