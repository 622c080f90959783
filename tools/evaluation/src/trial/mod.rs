//! Trials of the body in MuJoCo: walking, pushes, odometry, kicks, falls, getting up. Each trial is a table of results
//! with the required numbers.

mod comeback;
mod course;
mod fall_subject;
mod falls;
mod get_up;
mod kicks;
mod obstacles;
mod odometry;
mod rising;
mod series;
mod table;
mod walker;
mod walking;

use bica_app::{Console, Failure, Outcome, interrupt};
use clap::ValueEnum;

use bica_motion::model::simulation::NAO;
pub use kicks::{KickResult, kick_ball};
use series::Series;
use table::Table;

use crate::trial_options::{Kind, TrialOptions};

/// Runs trials and prints their tables.
///
/// # Errors
/// If the physics parameters are out of range, the robot has no such trial, or the output cannot be written.
pub fn run(options: &TrialOptions) -> Result<Outcome, Failure> {
    let series = Series::new(options.robot, options);
    let has_forward = options.robot == NAO;
    let all = if has_forward { Kind::value_variants() } else { &WITHOUT_FORWARD };
    let console = Console::new(options.json);
    let mut tables = Vec::new();
    for kind in if options.names.is_empty() { all } else { &options.names } {
        let name = kind.to_possible_value().map(|value| value.get_name().to_owned()).unwrap_or_default();
        if !has_forward && !WITHOUT_FORWARD.contains(kind) {
            let help = "this robot has the trials `walk`, `pushes`, `kicks` and `get-up`; `--robot nao` has all";
            return Err(Failure::new(format!("this robot has no trial `{name}`"), help));
        }
        let table = Table { trial: name, rows: rows(*kind, &series)? };
        table.print(console)?;
        tables.push(table);
        if interrupt::requested() {
            return Ok(Outcome::Interrupted);
        }
    }
    console.print_json(&table::TrialReport { schema: "bica-player/trial/1", runs: series.runs(), tables: &tables })?;
    Ok(if tables.iter().all(Table::holds) { Outcome::Success } else { Outcome::Unsuccessful })
}

/// Trials of a robot without the forward.
const WITHOUT_FORWARD: [Kind; 4] = [Kind::Walk, Kind::Pushes, Kind::Kicks, Kind::GetUp];

fn rows(kind: Kind, series: &Series) -> Result<Vec<table::Row>, Failure> {
    match kind {
        Kind::Walk => walking::velocities(series),
        Kind::Commands => walking::commands(series),
        Kind::Pushes => walking::pushes(series),
        Kind::Bodies => walking::bodies(series),
        Kind::Odometry => odometry::rows(series),
        Kind::Kicks => kicks::rows(series),
        Kind::Falls => falls::rows(series),
        Kind::GetUp if series.model == NAO => get_up::rows(series),
        Kind::GetUp => rising::rows(series),
        Kind::Obstacles => obstacles::rows(series),
        Kind::Comeback => comeback::rows(series),
    }
}
