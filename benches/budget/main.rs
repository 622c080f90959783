//! The budget report: what every component of the forward takes in fixed games, beside what it declares.
//!
//! `cargo bench -p bica-benches --bench budget`, and `cargo bench -p bica-benches --bench budget -- --help`.
//!
//! The games are deterministic, so every run of a component does the same work whenever the game is played again. Each
//! game is played several times, and of every run the least time counts: what the work takes, without what the machine
//! did in between. A declared budget must hold for the slowest run of all, so counted. What was ever measured, with all
//! that came in between, is printed too, and decides nothing.

mod bars;
mod json;
mod options;
mod play;
mod report;
mod smaller;
mod table;

use std::process::ExitCode;

use bica_benches::budget::lanes::Lanes;
use clap::Parser;
use options::Options;
use report::Report;

fn main() -> ExitCode {
    match report(&Options::parse()) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("budget: {error}");
            ExitCode::FAILURE
        }
    }
}

/// How many times as often as asked the games are played while something does not hold.
const MORE: usize = 3;

/// Whether all that must hold does.
fn report(options: &Options) -> Result<bool, String> {
    let repeats = options.repeats as usize;
    let mut played = Lanes::new();
    let report = loop {
        play::all(options.frame, repeats, &mut played)?;
        let machine = options.smaller().map(|asked| asked.machine(options.frame)).transpose()?;
        let report = Report::new(options, &played, machine);
        // The least time can only fall: what was in between every time so far is worth another try.
        if report.findings.is_empty() || played.games() >= MORE * repeats {
            break report;
        }
    };
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
