//! The budget report: measured times of every component of the forward in fixed games, and the declared budgets.
//!
//! `cargo bench -p bica-benches --bench budget`, and `cargo bench -p bica-benches --bench budget -- --help`.
//!
//! The games are deterministic, so a run of a component does the same work in each repetition of a game. For every run
//! the minimum time over the repetitions counts, which removes interruptions by other programs. The slowest run,
//! counted like this, must keep the declared budget. The maximum time over all repetitions is printed too, but is not
//! checked.

mod bars;
mod json;
mod options;
mod play;
mod processor;
mod report;
mod table;

use std::process::ExitCode;

use bica_times::measurements::Measurements;
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

/// Factor on the number of repetitions while a check fails.
const MORE: usize = 3;

/// Plays the games, writes the report, and returns whether all checks pass.
fn report(options: &Options) -> Result<bool, String> {
    let repeats = options.repeats as usize;
    let mut measurements = Measurements::new();
    let report = loop {
        play::all(options.frame, repeats, &mut measurements)?;
        let basis = options.processor().map(|processor| processor.basis(options.frame)).transpose()?;
        let report = Report::new(options, &measurements, basis);
        // More repetitions can only lower the minimum times, so a failed check may be caused by interruptions.
        if report.findings.is_empty() || measurements.repetitions() >= MORE * repeats {
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
