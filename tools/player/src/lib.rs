//! The program `player`: a game of the forward, its tree as a drawing, its vision on recorded images.
//!
//! A library beside the program, so that a test can parse every command that the documentation shows.

mod calibrate;
pub mod cli;
mod colour_profile;
mod graph;
mod link;
mod params;
mod play;
mod record;
mod replay;
mod see;
mod trial;
mod tuning;
mod watch;

use std::process::ExitCode;
use std::thread;

use bica_console::{Failure, STACK_BYTES, interrupt};
use clap::Parser;

use cli::{Cli, Command};

/// Runs the subcommand of the command line; returns the exit code.
#[must_use]
pub fn run() -> ExitCode {
    let cli = Cli::parse();
    interrupt::listen();
    let work = move || match cli.command {
        None => play::run(&cli.play),
        Some(Command::Play(args)) => play::run(&args),
        Some(Command::Graph(args)) => graph::run(&args),
        Some(Command::Link(args)) => link::run(&args),
        Some(Command::Watch(args)) => watch::run(&args),
        Some(Command::Record(args)) => record::run(&args),
        Some(Command::Replay(args)) => replay::run(&args),
        Some(Command::Params(args)) => params::run(&args),
        Some(Command::See(args)) => see::run(&args),
        Some(Command::Calibrate(args)) => calibrate::run(&args),
        Some(Command::Trial(args)) => trial::run(&args),
    };
    match thread::Builder::new().stack_size(STACK_BYTES).spawn(work).map(thread::JoinHandle::join) {
        Ok(Ok(outcome)) => outcome.map_or_else(ExitCode::from, ExitCode::from),
        // The panic has printed its message.
        Ok(Err(_)) => ExitCode::from(101),
        Err(error) => Failure::new(format!("cannot start a thread: {error}"), "is there memory left?").into(),
    }
}
