//! The program: what it is asked, what it does, how it ends.

mod calibrate;
mod cli;
mod ending;
mod film;
mod game;
mod graph;
mod labels;
mod look;
mod picture;
mod profile;
mod progress;
mod see;
mod stop;
mod svg;
#[cfg(feature = "mujoco")]
mod trial;
mod voice;
mod watch;

use std::process::ExitCode;
use std::thread;

use clap::Parser;

use cli::{Cli, Command};
use ending::Failure;

/// Room for a forward on the stack, bytes: it holds a whole image, and is made there before it moves to the heap.
const STACK: usize = 32 << 20;

/// Does what the command line asks.
pub(crate) fn run() -> ExitCode {
    let cli = Cli::parse();
    stop::listen();
    let work = move || match cli.command {
        None => game::run(&cli.play),
        Some(Command::Play(args)) => game::run(&args),
        Some(Command::Graph(args)) => graph::run(&args),
        Some(Command::Watch(args)) => watch::run(&args),
        Some(Command::See(args)) => see::run(&args),
        Some(Command::Calibrate(args)) => calibrate::run(&args),
        #[cfg(feature = "mujoco")]
        Some(Command::Trial(args)) => trial::run(&args),
    };
    match thread::Builder::new().stack_size(STACK).spawn(work).map(thread::JoinHandle::join) {
        Ok(Ok(outcome)) => outcome.map_or_else(ExitCode::from, ExitCode::from),
        // The panic has spoken for itself.
        Ok(Err(_)) => ExitCode::from(101),
        Err(error) => Failure::new(format!("cannot start a thread: {error}"), "is there memory left?").into(),
    }
}
