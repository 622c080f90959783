//! The program `player`: a game of the forward, its tree as a drawing, its vision on recorded images.

mod calibrate;
mod cli;
mod graph;
mod play;
mod see;
#[cfg(feature = "mujoco")]
mod trial;
mod watch;

use std::process::ExitCode;
use std::thread;

use bica_console::{Failure, STACK_BYTES, interrupt};
use clap::Parser;

use cli::{Cli, Command};

/// Does what the command line asks.
fn main() -> ExitCode {
    let cli = Cli::parse();
    interrupt::listen();
    let work = move || match cli.command {
        None => play::run(&cli.play),
        Some(Command::Play(args)) => play::run(&args),
        Some(Command::Graph(args)) => graph::run(&args),
        Some(Command::Watch(args)) => watch::run(&args),
        Some(Command::See(args)) => see::run(&args),
        Some(Command::Calibrate(args)) => calibrate::run(&args),
        #[cfg(feature = "mujoco")]
        Some(Command::Trial(args)) => trial::run(&args),
    };
    match thread::Builder::new().stack_size(STACK_BYTES).spawn(work).map(thread::JoinHandle::join) {
        Ok(Ok(outcome)) => outcome.map_or_else(ExitCode::from, ExitCode::from),
        // The panic has printed its message.
        Ok(Err(_)) => ExitCode::from(101),
        Err(error) => Failure::new(format!("cannot start a thread: {error}"), "is there memory left?").into(),
    }
}
