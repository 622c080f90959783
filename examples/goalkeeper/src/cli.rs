//! The command line.

use std::ops::RangeInclusive;
use std::process::ExitCode;

use bica_console::{Batch, Console, Failure, Outcome, interrupt};
use bica_sim::setup::Frame;
use bica_sim::shot::{SPEEDS, Shot};
use bica_tuning::Layers;
use clap::Parser;
use bica::Tree;
use bica::graph::Graph;
use crate::Keeper;

use crate::shots::{self, Robot, ShotResult};

static GRAPH: Graph = Keeper::GRAPH;

/// Arguments of the program.
#[derive(Debug, Parser)]
#[command(name = "goalkeeper", version)]
pub struct Cli {
    /// Number of shots, one for each seed
    #[arg(long, default_value_t = 100)]
    shots: u32,
    /// First seed
    #[arg(long, default_value_t = 0)]
    seed: u64,
    /// Slowest and fastest kick, m/s
    #[arg(long, num_args = 2, value_names = ["MIN", "MAX"])]
    speeds: Option<Vec<f32>>,
    /// Play only the idle robot
    #[arg(long)]
    idle: bool,
    /// Parameter of the goalkeeper, as GuardPost.distance=0.3
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<String>,
    /// Print a line for each shot
    #[arg(long)]
    verbose: bool,
}

/// Runs the program.
#[must_use]
pub fn run() -> ExitCode {
    let cli = Cli::parse();
    interrupt::listen();
    play(&cli).map_or_else(ExitCode::from, ExitCode::from)
}

fn play(cli: &Cli) -> Result<Outcome, Failure> {
    let console = Console::new(false);
    let speeds = cli.speeds.as_ref().map_or(SPEEDS, |s| s[0]..=s[1]);
    let mut layers = Layers::new(&GRAPH);
    for assignment in &cli.set { layers.assign(assignment, "--set")?; }
    let settings = layers.settings();
    for robot in [Robot::Idle, Robot::Goalkeeper(&settings)] {
        let plays = matches!(robot, Robot::Goalkeeper(_));
        if cli.idle && plays { break; }
        let results = series(robot, cli.seed, cli.shots, &speeds)?;
        let let_in = results.iter().filter(|r| r.let_in).count();
        let kicked = results.iter().filter(|r| r.kicked).count();
        let falls: usize = results.iter().map(|r| r.falls).sum();
        console.print(&format!("{plays}: {let_in} of {} let in, {kicked} kicked, {falls} falls", results.len()))?;
        if cli.verbose && plays {
            for r in &results { println!("{r:?} {:?}", Shot::draw(r.seed, 0, &speeds)); }
        }
    }
    Ok(Outcome::Success)
}

fn series(robot: Robot<'_>, seed: u64, count: u32, speeds: &RangeInclusive<f32>) -> Result<Vec<ShotResult>, Failure> {
    Batch::new(seed, count, None).run(|seed| shots::play(robot, seed, &Shot::draw(seed, 0, speeds), Frame::Small))
}
