//! Trials of the body in MuJoCo: walking, pushes, odometry, kicks, falls, getting up, also beside obstacles; each a table of what was reached.

mod bench;
mod comeback;
mod dice;
mod falls;
mod get_up;
mod kicks;
mod obstacles;
mod odometry;
mod table;
mod victim;
mod walker;
mod walking;

use bica_sim::mujoco::Physics;

use super::cli::{Trial, TrialName};
use super::ending::{Ending, Failure};
use super::stop;
use super::voice::Voice;
use bench::Bench;
use table::Table;

/// `player trial`: tries what is named, tells what was reached.
pub(crate) fn run(args: &Trial) -> Result<Ending, Failure> {
    let voice = Voice::new(args.json);
    let bench = Bench::new(args, physics(args));
    let mut tables = Vec::new();
    for &name in if args.names.is_empty() { TrialName::ALL } else { &args.names } {
        let table = Table { trial: name.word(), rows: of(name)(&bench)? };
        table.tell(voice)?;
        tables.push(table);
        if stop::asked() {
            return Ok(Ending::Interrupted);
        }
    }
    voice.result(&table::Told { schema: "bica-player/trial/1", runs: bench.runs, tables: &tables })?;
    Ok(if tables.iter().all(Table::holds) { Ending::Reached } else { Ending::Missed })
}

type Try = fn(&Bench) -> Result<Vec<table::Row>, Failure>;

const fn of(name: TrialName) -> Try {
    match name {
        TrialName::Walk => walking::velocities,
        TrialName::Commands => walking::commands,
        TrialName::Pushes => walking::pushes,
        TrialName::Bodies => walking::bodies,
        TrialName::Odometry => odometry::rows,
        TrialName::Kicks => kicks::rows,
        TrialName::Falls => falls::rows,
        TrialName::GetUp => get_up::rows,
        TrialName::Obstacles => obstacles::rows,
        TrialName::Comeback => comeback::rows,
    }
}

fn physics(args: &Trial) -> Physics {
    let default = Physics { cameras: false, ..Physics::default() };
    Physics {
        friction: args.friction.unwrap_or(default.friction),
        leg_gain: args.leg_gain.unwrap_or(default.leg_gain),
        torque_limit: args.torque_limit.unwrap_or(default.torque_limit),
        dead_time: args.dead_time.unwrap_or(default.dead_time),
        noise: args.noise.unwrap_or(default.noise),
        ..default
    }
}
