//! Trials of the body in MuJoCo: walking, pushes, odometry, kicks, falls, getting up, also beside obstacles; each a table of what was reached.

mod bench;
mod comeback;
mod fall_subject;
mod falls;
mod get_up;
mod kicks;
mod kind;
mod obstacles;
mod odometry;
mod rng;
mod table;
mod walker;
mod walking;

use bica_sim::mujoco::Physics;

use bench::Bench;
use bica_console::{Console, Failure, Outcome, interrupt};
pub use kind::Kind;
use table::Table;

/// What to try, how often, and in which physics.
#[derive(Clone, Debug)]
pub struct Trial {
    /// What to try; everything if there is none.
    pub kinds: Vec<Kind>,
    /// How many seeds.
    pub runs: u32,
    /// The first seed.
    pub seed: u64,
    /// How many at once; one for each core if it is not said.
    pub threads: Option<u32>,
    /// The world's physics.
    pub physics: Physics,
}

/// `player trial`: tries what is named, tells what was reached.
pub fn run(args: &Trial, console: Console) -> Result<Outcome, Failure> {
    let bench = Bench::new(args);
    let mut tables = Vec::new();
    for &kind in if args.kinds.is_empty() { Kind::ALL } else { &args.kinds } {
        let table = Table { trial: kind.name(), rows: of(kind)(&bench)? };
        table.tell(console)?;
        tables.push(table);
        if interrupt::requested() {
            return Ok(Outcome::Interrupted);
        }
    }
    console.print_json(&table::Told { schema: "bica-player/trial/1", runs: bench.runs, tables: &tables })?;
    Ok(if tables.iter().all(Table::holds) { Outcome::Success } else { Outcome::Unsuccessful })
}

type Try = fn(&Bench) -> Result<Vec<table::Row>, Failure>;

const fn of(kind: Kind) -> Try {
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
