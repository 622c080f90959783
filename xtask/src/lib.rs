//! The development tasks of the workspace, and their command line.
//!
//! The tasks are a library, so that a test can parse every `cargo xtask` command in the documentation.

mod browser;
mod build;
mod ci;
pub mod cli;
mod deny;
mod deploy;
mod figures;
mod firmware;
mod fuzz;
mod install;
mod league;
mod miri;
mod mujoco;
mod no_std;
mod peers;
mod process;
mod publish;
mod python;
mod robot;
mod room;
mod ros;
mod slow_tests;
mod spelling;
mod trees;
mod viewers;

use std::process::ExitCode;

use clap::{CommandFactory, Parser};

use cli::{Cli, Task};

/// Runs the task of the command line; without a task prints the list of tasks.
#[must_use]
pub fn run() -> ExitCode {
    let Some(task) = Cli::parse().task else {
        print!("{}", Cli::command().render_help());
        return ExitCode::SUCCESS;
    };
    match perform(&task) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("xtask: {error}");
            ExitCode::FAILURE
        }
    }
}

fn perform(task: &Task) -> Result<(), String> {
    match task {
        Task::Firmware(options) => firmware::check(options),
        Task::Deploy(options) => deploy::deploy(options),
        Task::Mujoco => mujoco::install(),
        Task::League => league::install(),
        Task::Fuzz(options) => fuzz::check(options.seconds),
        Task::Trees(options) => trees::compare(options),
        Task::Python => python::check(&[]),
        Task::Robot => robot::check(),
        Task::Ros => ros::check(true),
        Task::Peers(options) => peers::measure(options),
        Task::Figures(options) => figures::figures(options.check),
        Task::Browser(options) if options.figures => browser::measure(),
        Task::Browser(_) => {
            browser::test()?;
            firmware::prepare()?;
            browser::watch_firmware()
        }
        Task::Long(options) => {
            let package = options.package.as_deref();
            if package.is_none_or(|package| package == "bica-player-program") {
                firmware::prepare()?;
            }
            slow_tests::run_long(package, ci::with_mujoco(!options.without_mujoco)?)
        }
        Task::Ci(options) => ci::check(options),
    }
}
