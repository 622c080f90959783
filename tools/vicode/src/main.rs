//! Command line of VICODE.

use std::io::{self, Write};
use std::process::ExitCode;

use clap::Parser;

/// Reads and edits the state machines of BICA in their Rust source
#[derive(Parser)]
#[command(version)]
struct Arguments {
    #[command(subcommand)]
    command: bica_vicode::cli::Command,
}

/// Exit code 0: no mistakes; 1: a file has mistakes; 2: the command failed.
fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let mut out = io::stdout().lock();
    match bica_vicode::cli::run(&arguments.command, &mut out) {
        Ok(good) => {
            if out.flush().is_ok() && good {
                ExitCode::SUCCESS
            } else {
                ExitCode::from(1)
            }
        }
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::from(2)
        }
    }
}
