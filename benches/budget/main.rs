//! The budget report: what every component of the forward takes in fixed games, beside what it declares.
//!
//! `cargo bench --bench budget`, and `cargo bench --bench budget -- --help`.
//!
//! The games are deterministic, so every run of a component does the same work whenever the game is played again. Each
//! game is played several times, and of every run the least time counts: what the work takes, without what the machine
//! did in between. A declared budget must hold for the slowest run of all, so counted. What was ever measured, with all
//! that came in between, is printed too, and decides nothing.

#[path = "../../tests/forward/game.rs"]
mod game;
#[path = "../support/recording.rs"]
mod recording;

mod bars;
mod json;
mod lanes;
mod options;
mod play;
mod report;
mod smaller;
mod spread;
mod table;
mod verdict;

use std::process::ExitCode;

use options::{Asked, HELP, Options};
use report::Report;

fn main() -> ExitCode {
    match options::read(std::env::args().skip(1)) {
        Ok(Asked::Help) => {
            print!("{HELP}");
            ExitCode::SUCCESS
        }
        Ok(Asked::Report(options)) => match report(&options) {
            Ok(true) => ExitCode::SUCCESS,
            Ok(false) => ExitCode::FAILURE,
            Err(error) => {
                eprintln!("budget: {error}");
                ExitCode::FAILURE
            }
        },
        Err(error) => {
            eprintln!("budget: {error}\n\n{HELP}");
            ExitCode::from(2)
        }
    }
}

/// Whether all that must hold does.
fn report(options: &Options) -> Result<bool, String> {
    let played = play::all(options.frame, options.repeats)?;
    let machine = options.smaller.map(|asked| asked.machine(options.frame)).transpose()?;
    let report = Report::new(options, &played, machine);
    if let Some(file) = &options.svg {
        std::fs::write(file, bars::draw(&report))
            .map_err(|error| format!("cannot write {}: {error}", file.display()))?;
    }
    if options.json {
        println!("{}", json::of(&report));
    } else {
        print!("{}", table::of(&report));
    }
    for finding in &report.findings {
        eprintln!("budget: {finding}");
    }
    Ok(report.findings.is_empty())
}
