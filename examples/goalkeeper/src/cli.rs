//! The command line.

use bica::Tree;
use bica::graph::Graph;
use bica_app::{App, Console, Failure, Outcome, TuningArgs};
use bica_sim::shot::SPEEDS;
use clap::Args;
use serde::Serialize;

use crate::Keeper;
use crate::series::Series;
use crate::shots::{self, Plan, Robot, ShotResult};

static GRAPH: Graph = Keeper::GRAPH;

const AFTER: &str = "\
Examples:
  goalkeeper                                  100 shots at an idle robot and at the goalkeeper
  goalkeeper --shots 20 --speeds 2.4 3.0      20 faster ones
  goalkeeper --set GuardPost.distance=0.2     the goalkeeper stands nearer to the goal line
  goalkeeper run --serve 127.0.0.1:7400       shots in real time, one after the other, that monitors can watch
  goalkeeper run --record shots.mcap          the same as fast as possible, recorded
  goalkeeper link 127.0.0.1:7400 watch        its states, from another terminal
  goalkeeper params GuardPost                 the parameters of a component

Exit codes: 0 the goalkeeper lets in at most half of what the idle robot lets in, 1 more, 2 wrong arguments,
130 stopped by Ctrl-C, 141 the reader of the output is gone.";

const ABOUT: &str = "\
A goalkeeper against balls that are kicked at its goal from 2 to 3 m in the built-in world. It sees them only in its camera
images.";

#[derive(Debug, Args)]
struct SeriesArgs {
    /// Number of shots, one for each seed
    #[arg(long, value_name = "N", default_value_t = 100, value_parser = clap::value_parser!(u32).range(1..))]
    shots: u32,
    /// First seed
    #[arg(long, value_name = "SEED", default_value_t = 0)]
    seed: u64,
    /// Slowest and fastest kick, m/s; a ball slower than 1.6 m/s may stop before the goal
    #[arg(long, num_args = 2, value_names = ["MIN", "MAX"], value_parser = speed)]
    speeds: Option<Vec<f32>>,
    /// Play only against the idle robot
    #[arg(long)]
    idle: bool,
    #[command(flatten)]
    tuning: TuningArgs,
    /// Print JSON on stdout; all other output goes to stderr
    #[arg(long)]
    json: bool,
}

/// Sums of a series.
#[derive(Clone, Copy, Debug, Serialize)]
struct Sums {
    shots: usize,
    let_in: usize,
    away: usize,
    falls: usize,
}

#[derive(Serialize)]
struct Report<'a> {
    schema: &'static str,
    idle: Sums,
    goalkeeper: Option<Sums>,
    shots: &'a [ShotResult],
}

/// Name of the tune file without `--tune`.
const KIND: &str = "goalkeeper";

/// Returns the program.
#[must_use]
pub fn app() -> App<Keeper> {
    App::new("goalkeeper")
        .describe(|command| command.version(env!("CARGO_PKG_VERSION")).about(ABOUT).after_help(AFTER))
        .kind(KIND)
        .robot(shots::at_start)
        .try_world("shots", |options| {
            let plan = Plan { seed: options.seed, shots: options.value("shots", 100)?, ..Plan::default() };
            Series::new(plan)
        })
        .default_command(|args| play(&args))
}

fn play(cli: &SeriesArgs) -> Result<Outcome, Failure> {
    let settings = cli.tuning.layers(&GRAPH, KIND)?.settings();
    let speeds = match cli.speeds.as_deref() {
        Some(&[min, max]) if min > max => {
            return Err(Failure::new(format!("--speeds {min} {max} is no range"), "name the slowest speed first"));
        }
        Some(&[min, max]) => min..=max,
        _ => SPEEDS,
    };
    let plan = Plan { seed: cli.seed, shots: cli.shots, speeds };
    let console = Console::new(cli.json);
    console.print(&format!("{:12}{:>7}{:>8}{:>7}{:>7}{:>7}", "", "shots", "let in", "saved", "away", "falls"))?;
    let idle = sums(&plan.play(Robot::Idle)?);
    print(console, "idle", idle)?;
    let results = if cli.idle { Vec::new() } else { plan.play(Robot::Goalkeeper(&settings))? };
    let goalkeeper = (!cli.idle).then(|| sums(&results));
    if let Some(goalkeeper) = goalkeeper {
        print(console, "goalkeeper", goalkeeper)?;
    }
    console.print_json(&Report { schema: "goalkeeper/shots/1", idle, goalkeeper, shots: &results })?;
    Ok(Outcome::of(goalkeeper.is_none_or(|goalkeeper| 2 * goalkeeper.let_in <= idle.let_in)))
}

fn sums(results: &[ShotResult]) -> Sums {
    let count = |is: fn(&ShotResult) -> bool| results.iter().filter(|result| is(result)).count();
    Sums {
        shots: results.len(),
        let_in: count(|result| result.let_in),
        away: count(|result| result.away),
        falls: results.iter().map(|result| result.falls).sum(),
    }
}

fn print(console: Console, name: &str, sums: Sums) -> Result<(), Failure> {
    let Sums { shots, let_in, away, falls } = sums;
    console.print(&format!("{name:12}{shots:>7}{let_in:>8}{:>7}{away:>7}{falls:>7}", shots - let_in))
}

fn speed(text: &str) -> Result<f32, String> {
    let speed = text.parse::<f32>().map_err(|error| error.to_string())?;
    if (0.1..=5.0).contains(&speed) { Ok(speed) } else { Err("choose 0.1 to 5 m/s".to_owned()) }
}
