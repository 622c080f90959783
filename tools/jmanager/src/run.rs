//! The program `jmanager`.

use std::io::{self, Write as _};
use std::process::ExitCode;

use bica_app::{Failure, Outcome, interrupt};
use clap::Parser;

use super::cli::{Cli, Command};
use super::world::ROBOTS;
use super::{SoccerOptions, program};
use bica_monitor::sessions::Options;

/// Command that runs the forward in the built-in world for a day.
const RUN: &str = "-p bica-player-program --bin player -- play --serve {address} --seed {seed} --robots {robots} \
                   --seconds 86400";

/// Runs the program; returns its exit code.
#[must_use]
pub fn run() -> ExitCode {
    let cli = Cli::parse();
    if let Some(Command::Vicode { command }) = &cli.command {
        return vicode(command);
    }
    serve(cli).map_or_else(ExitCode::from, ExitCode::from)
}

/// Runs a command of VICODE. Exit code 0: no mistakes; 1: a file has mistakes; 2: the command failed.
fn vicode(command: &bica_vicode::cli::Command) -> ExitCode {
    let mut out = io::stdout().lock();
    let result = bica_vicode::cli::run(command, &mut out);
    match result.and_then(|good| out.flush().map(|()| good).map_err(|error| format!("cannot print: {error}"))) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(1),
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::from(2)
        }
    }
}

fn serve(cli: Cli) -> Result<Outcome, Failure> {
    let Cli { mut arguments, robots, size, image, images, .. } = cli;
    if cfg!(not(feature = "mujoco")) && arguments.world.as_deref() == Some("mujoco") {
        let help = "install its library with `cargo xtask mujoco`, then build with `--features mujoco`";
        return Err(Failure::new("this program was built without MuJoCo", help));
    }
    if robots > 0 {
        arguments.option.push((ROBOTS.to_owned(), robots.to_string()));
    }
    let options = Options { run: RUN.to_owned(), ..Options::default() };
    let soccer = SoccerOptions { firmware: image, size, images, ..SoccerOptions::default() };
    interrupt::listen();
    bica_monitor::run(&arguments, options, program(soccer), &interrupt::requested)?;
    Ok(Outcome::Success)
}
