//! Trials of the body in MuJoCo: walking, pushes, odometry, kicks, falls, getting up. Each trial is a table of results
//! with the required numbers.

mod comeback;
mod fall_subject;
mod falls;
mod get_up;
mod kicks;
mod obstacles;
mod odometry;
mod rng;
mod series;
mod table;
mod walker;
mod walking;

use bica_app::{Console, Failure, Outcome, interrupt};
use clap::ValueEnum;

use series::Series;
use table::Table;

use crate::trial_options::{Kind, TrialOptions};

/// Runs trials and prints their tables.
///
/// # Errors
/// If the physics are out of range or the output cannot be written.
pub fn run(options: &TrialOptions) -> Result<Outcome, Failure> {
    let (console, series) = (Console::new(options.json), Series::new(options));
    let mut tables = Vec::new();
    for kind in if options.names.is_empty() { Kind::value_variants() } else { &options.names } {
        let name = kind.to_possible_value().map(|value| value.get_name().to_owned()).unwrap_or_default();
        let table = Table { trial: name, rows: trial(*kind)(&series)? };
        table.print(console)?;
        tables.push(table);
        if interrupt::requested() {
            return Ok(Outcome::Interrupted);
        }
    }
    console.print_json(&table::TrialReport { schema: "bica-player/trial/1", runs: series.runs(), tables: &tables })?;
    Ok(if tables.iter().all(Table::holds) { Outcome::Success } else { Outcome::Unsuccessful })
}

type Trial = fn(&Series) -> Result<Vec<table::Row>, Failure>;

const fn trial(kind: Kind) -> Trial {
    match kind {
        Kind::Walk => walking::velocities,
        Kind::Commands => walking::commands,
        Kind::Pushes => walking::pushes,
        Kind::Bodies => walking::bodies,
        Kind::Odometry => odometry::rows,
        Kind::Kicks => kicks::rows,
        Kind::Falls => falls::rows,
        Kind::GetUp => get_up::rows,
        Kind::Obstacles => obstacles::rows,
        Kind::Comeback => comeback::rows,
    }
}
