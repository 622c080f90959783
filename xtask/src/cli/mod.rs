//! The command line.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};

use crate::ci::Step;

const AFTER: &str = "\
A task that needs more than Rust installs it and prints what it installs. `cargo xtask help TASK` describes one task.

Exit codes: 0 success, 1 a check or an installation failed, 2 wrong arguments.";

/// Command line of `cargo xtask`.
#[derive(Debug, Parser)]
#[command(
    name = "xtask",
    bin_name = "cargo xtask",
    about = "Development tasks of the BICA workspace.",
    after_help = AFTER,
    subcommand_value_name = "TASK",
    subcommand_help_heading = "Tasks"
)]
pub struct Cli {
    #[command(subcommand)]
    pub(crate) task: Option<Task>,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Task {
    /// Build the firmware, boot it in QEMU, and play games on it
    ///
    /// Every cycle of the games is computed on the host too, and both results must be equal. Size, stack and instructions
    /// are compared with firmware/figures.txt and firmware/figures-medium.txt. First installs the target and QEMU.
    Firmware(Firmware),
    /// Put the program on a real NAO V6, as a service that is started by hand
    ///
    /// Builds the program, copies it with profiles and parameters to HOST:bica (with rsync over ssh), and installs a service of systemd.
    /// `docs/nao-v6.md` says what can hurt the robot. Installs Rust's target, and ssh and rsync (with apt).
    Deploy(Deploy),
    /// Install what `play --world mujoco` needs
    ///
    /// Puts MuJoCo's library into target/mujoco (from PyPI, with pip), for the feature `mujoco`, and installs EGL with Mesa's
    /// software renderer (with apt).
    Mujoco,
    /// Install the server of the simulation league: what `play --world league` needs
    ///
    /// Puts `RCSSServerMJ` (`rcsssmj` 0.2.1 of `PyPI`, with pip) into target/league, an environment of its own.
    League,
    /// Fuzz the edits of VICODE, the vision, the packets, the reading of recordings, the link of monitors, and therapy sessions
    ///
    /// First installs cargo-fuzz into target/.
    Fuzz(Fuzz),
    /// Compare random trees with the second model of the semantics
    ///
    /// Writes trees with roles, results, found values, work, several writers, timers and rates as a crate in target/random-trees, and plays
    /// random scripts on them with holds, rates, jumps of the clock and functions that panic. Prints the smallest script in which a tree
    /// differs from the model.
    Trees(Trees),
    /// Compare the speed of BICA with other frameworks and designs
    ///
    /// Measures BICA, copper-rs, statig, smlang and other designs on the same workloads, and fails if a claim about
    /// speed does not hold.
    Peers(Peers),
    /// Check the Python package: lints, types, tests, notebook, wheel
    ///
    /// First installs `PostgreSQL` (with apt), and the package with Ray and Optuna (with pip) into target/python/venv, which is an
    /// environment to work in.
    Python,
    /// Run the program behind stand-ins for real robots
    ///
    /// A NAO V6 behind LoLA's socket and a Booster T1 and K1 behind their topics, with faults; each checks what it gets. First installs
    /// Cyclone DDS and MuJoCo (with pip) into target/robot, an environment in which the stand-ins of `robots/` also run by hand.
    Robot,
    /// Test robots as ROS 2 nodes with rclpy and with another DDS
    ///
    /// First installs both (with pip, no ROS is needed) into target/ros. Takes about seven minutes.
    Ros,
    /// Write the figures in the docs that a program computes
    ///
    /// They stand between marks, as `<!--=lines player/t1/src-->31<!--/-->`; `xtask/src/figures.rs` lists the kinds. First builds the
    /// program `player`, whose recordings are measured.
    Figures(Figures),
    /// Test JManager's page in a real browser
    ///
    /// Builds JManager, drives Chromium, and writes screenshots to target/browser. First installs Chromium (with apt).
    Browser(Browser),
    /// Run the tests that take minutes, which CI leaves out
    ///
    /// In a release build: a hundred games of the built-in world and twenty of MuJoCo that are recorded and replayed, five
    /// of the firmware over a damaged link, a thousand flipped bits in a recording, and fifty kills of a recording program, for which
    /// the machine should be otherwise idle; therapy sessions with twenty seeds in MuJoCo. First builds the firmware, and installs QEMU
    /// and MuJoCo. Takes more than an hour.
    Long(Long),
    /// Check everything that CI checks
    ///
    /// Installs the tools of all steps before the tests, and fails if one cannot be installed. The last line names the steps that were left
    /// out.
    Ci(Ci),
}

#[derive(Debug, Default, Args)]
#[group(multiple = false)]
#[expect(clippy::struct_excessive_bools, reason = "each is an option of its own, and the group allows one at a time")]
pub(crate) struct Firmware {
    /// Only build the image
    #[arg(long)]
    pub(crate) build: bool,
    /// Print the flash size of each part
    #[arg(long)]
    pub(crate) size: bool,
    /// Accept the new figures
    #[arg(long)]
    pub(crate) bless: bool,
    /// Inject errors into the link for ten minutes, instead of playing games
    #[arg(long)]
    pub(crate) fuzz: bool,
    /// Only build the image, and play ten games with each size of camera images
    #[arg(long)]
    pub(crate) games: bool,
}

#[derive(Debug, Args)]
pub(crate) struct Deploy {
    /// The robot: NAME, USER@NAME, or its address, as ssh knows it; with a key, since no password is asked for
    #[arg(value_name = "HOST")]
    pub(crate) host: String,
    /// Print the commands, and run none
    #[arg(long)]
    pub(crate) dry_run: bool,
    /// Processor and system of the robot
    #[arg(long, value_name = "TARGET", default_value = "x86_64-unknown-linux-musl")]
    pub(crate) target: String,
    /// Folder with tune files, which replace those of the robot
    #[arg(long, value_name = "FOLDER")]
    pub(crate) tune: Option<PathBuf>,
    /// Then start the service: the robot stands up
    #[arg(long)]
    pub(crate) start: bool,
    /// Only stop the service: the robot sits down
    #[arg(long, conflicts_with_all = ["start", "tune", "pull"])]
    pub(crate) stop: bool,
    /// Only copy the robot's recordings into this folder
    #[arg(long, value_name = "FOLDER", conflicts_with_all = ["start", "tune"])]
    pub(crate) pull: Option<PathBuf>,
}

#[derive(Debug, Default, Args)]
pub(crate) struct Figures {
    /// Write nothing, and fail if a figure has changed, as CI does
    #[arg(long)]
    pub(crate) check: bool,
}

#[derive(Debug, Default, Args)]
pub(crate) struct Browser {
    /// Also measure speed, and print the figures; they are not judged
    #[arg(long)]
    pub(crate) figures: bool,
}

#[derive(Debug, Default, Args)]
pub(crate) struct Long {
    /// Leave out the tests in MuJoCo
    #[arg(long)]
    pub(crate) without_mujoco: bool,
    /// Run only the tests of this package
    #[arg(long)]
    pub(crate) package: Option<String>,
}

#[derive(Debug, Default, Args)]
pub(crate) struct Ci {
    /// Leave these steps out, separated by commas
    #[arg(long, value_name = "STEPS", value_delimiter = ',')]
    pub(crate) without: Vec<Step>,
    /// Run only these steps, separated by commas
    #[arg(long, value_name = "STEPS", value_delimiter = ',', conflicts_with = "without")]
    pub(crate) only: Vec<Step>,
    /// Run beside other steps: the tools are installed, and the end says nothing of what was left out
    #[arg(long, hide = true)]
    pub(crate) lane: bool,
}

#[derive(Debug, Args)]
pub(crate) struct Fuzz {
    /// Duration of each target, s
    #[arg(long, value_name = "N", default_value_t = 60, value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) seconds: u32,
}

#[derive(Debug, Args)]
pub(crate) struct Trees {
    /// Number of trees
    #[arg(long = "trees", value_name = "N", default_value_t = 60, value_parser = clap::value_parser!(u64).range(1..=1000))]
    pub(crate) count: u64,
    /// Calls of functions of components, at least
    #[arg(long, value_name = "N", default_value_t = 10_000_000)]
    pub(crate) calls: u64,
    /// Calls that panic, at least
    #[arg(long, value_name = "N", default_value_t = 100_000)]
    pub(crate) panics: u64,
    /// Seed of the trees and the scripts
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(crate) seed: u64,
}

#[derive(Debug, Args)]
#[group(multiple = false)]
pub(crate) struct Peers {
    /// Short preview: one process, few rounds; too few for reliable verdicts
    #[arg(long)]
    pub(crate) quick: bool,
    /// Short preview with an artificial slowdown of BICA; every claim about time must fail
    #[arg(long)]
    pub(crate) slow: bool,
}

#[cfg(test)]
mod tests;
