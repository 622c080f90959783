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
mod rng;
mod series;
mod table;
mod walker;
mod walking;

use bica_app::{Console, Failure, Outcome, interrupt};
use clap::ValueEnum;

use bica_motion::model::{K1, Nao, T1};
use course::Course;
pub use kicks::{KickResult, kick_ball};
use series::Series;
use table::Table;

use crate::trial_options::{Kind, Robot, TrialOptions};

/// Runs trials and prints their tables.
///
/// # Errors
/// If the physics are out of range, the robot has no such trial, or the output cannot be written.
pub fn run(options: &TrialOptions) -> Result<Outcome, Failure> {
    match options.robot {
        Robot::Nao => run_with(options, &Series::new::<Nao>(options), Kind::value_variants(), nao),
        Robot::T1 => run_with(options, &Series::new::<T1>(options), &BOOSTER, booster::<T1>),
        Robot::K1 => run_with(options, &Series::new::<K1>(options), &BOOSTER, booster::<K1>),
    }
}

fn run_with(
    options: &TrialOptions,
    series: &Series,
    all: &[Kind],
    trial: fn(Kind) -> Option<Trial>,
) -> Result<Outcome, Failure> {
    let console = Console::new(options.json);
    let mut tables = Vec::new();
    for kind in if options.names.is_empty() { all } else { &options.names } {
        let name = kind.to_possible_value().map(|value| value.get_name().to_owned()).unwrap_or_default();
        let trial = trial(*kind).ok_or_else(|| {
            let help = "this robot has the trials `walk`, `pushes`, `kicks` and `get-up`; `--robot nao` has all";
            Failure::new(format!("this robot has no trial `{name}`"), help)
        })?;
        let table = Table { trial: name, rows: trial(series)? };
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

/// Trials of a robot without the forward.
const BOOSTER: [Kind; 4] = [Kind::Walk, Kind::Pushes, Kind::Kicks, Kind::GetUp];

/// A trial of a robot without the forward.
fn booster<M: Course>(kind: Kind) -> Option<Trial> {
    match kind {
        Kind::Walk => Some(walking::velocities::<M>),
        Kind::Pushes => Some(walking::pushes::<M>),
        Kind::Kicks => Some(kicks::rows::<M>),
        Kind::GetUp => Some(rising::rows::<M>),
        _ => None,
    }
}

#[expect(clippy::unnecessary_wraps, reason = "it has the type of the trials of the other robots")]
fn nao(kind: Kind) -> Option<Trial> {
    Some(match kind {
        Kind::Walk => walking::velocities::<Nao>,
        Kind::Commands => walking::commands,
        Kind::Pushes => walking::pushes::<Nao>,
        Kind::Bodies => walking::bodies,
        Kind::Odometry => odometry::rows,
        Kind::Kicks => kicks::rows::<Nao>,
        Kind::Falls => falls::rows,
        Kind::GetUp => get_up::rows,
        Kind::Obstacles => obstacles::rows,
        Kind::Comeback => comeback::rows,
    })
}
