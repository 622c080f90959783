//! `cargo bench` of a robot: the time of each component in the program's worlds, compared with its declared budget.
//!
//! Runs are deterministic, so a run of a component does the same work in each repetition. For each run the minimum over the
//! repetitions counts, which removes interruptions by other programs.

mod figures;
mod measure;
mod picture;
mod table;

use std::fmt;
use std::fs;
use std::path::PathBuf;

use bica::runner::Robot;
use clap::Args;

use crate::console::{Console, Failure, Outcome, Style};
use crate::values::seconds;
use crate::world::{Pace, RegisteredWorld, Robots, WorldOptions};
use figures::Figures;
use measure::Times;

/// Maximum number of repetitions while a budget is exceeded in a minority of the runs, unless more are requested. A
/// further repetition can only lower the minima.
const MOST_REPEATS: u32 = 15;

/// Arguments of `cargo bench`.
#[derive(Clone, Debug, Args)]
pub(crate) struct BenchArgs {
    /// Only this world [default: all simulated worlds]
    #[arg(long, value_name = "WORLD")]
    world: Option<String>,
    /// Option of the worlds; may be repeated
    #[arg(long, value_name = "NAME=VALUE")]
    option: Vec<String>,
    /// The first seed
    #[arg(long, value_name = "N", default_value_t = 0)]
    seed: u64,
    /// Number of seeds
    #[arg(long, value_name = "N", default_value_t = 3, value_parser = clap::value_parser!(u64).range(1..=1000))]
    seeds: u64,
    /// Longest duration of a run, in seconds of the world
    #[arg(long, value_name = "S", default_value_t = 60.0, value_parser = seconds, allow_negative_numbers = true)]
    seconds: f64,
    /// Repetitions of each run; up to 15 while few runs exceed a budget
    #[arg(long, value_name = "N", default_value_t = 2, value_parser = clap::value_parser!(u32).range(1..=1000))]
    repeats: u32,
    /// Print a line of JSON for each world on stdout; all other output goes to stderr
    #[arg(long)]
    json: bool,
    /// `cargo bench` gives it; without it, as in `cargo test --benches`, one run is tried and nothing is judged
    #[arg(long, hide = true)]
    bench: bool,
}

/// Measures the robot in its simulated worlds; prints and draws the times, and lists the exceeded budgets.
pub(crate) fn bench<R: Robot<Error: fmt::Display>>(
    name: &str,
    worlds: &[RegisteredWorld<R>],
    robots: Robots<R>,
    args: &BenchArgs,
) -> Result<Outcome, Failure> {
    let is_wanted = |world: &&RegisteredWorld<R>| match &args.world {
        Some(name) => world.name == name,
        None => world.pace == Pace::Program,
    };
    let worlds: Vec<_> = worlds.iter().filter(is_wanted).collect();
    if worlds.is_empty() {
        let found = args.world.as_ref().map_or("no simulated world".to_owned(), |name| format!("no world `{name}`"));
        return Err(Failure::new(
            format!("the program has {found}"),
            "add it with `App::world`, or choose another one",
        ));
    }
    let (console, mut exceeded) = (Console::new(args.json), Vec::new());
    // Components with a budget that have not run in any world so far.
    let mut unmeasured: Vec<_> = const { &R::GRAPH }.nodes.iter().map(|node| node.name).collect();
    for world in worlds {
        let figures = figures(world, robots, args)?;
        console.print(&table::table(&figures))?;
        let picture = folder().join(format!("{name}-{}.svg", world.name));
        fs::create_dir_all(folder())
            .and_then(|()| fs::write(&picture, picture::draw(&figures)))
            .map_err(|error| Failure::of_path("write", &picture, &error, "is its folder writable?"))?;
        console.print_row("picture", &picture.display().to_string())?;
        console.print_json_line(&figures)?;
        unmeasured.retain(|name| figures.unmeasured().any(|other| other == *name));
        exceeded.extend(figures.exceeded.into_iter().map(|what| format!("{}: {what}", world.name)));
    }
    let never = |name| format!("{name} declares a budget and never ran: add a world, a seed or time in which it runs");
    exceeded.extend(unmeasured.into_iter().filter(|_| args.bench).map(never));
    for what in &exceeded {
        console.print_row("exceeded", &console.styled(Style::Bad, what))?;
    }
    Ok(if exceeded.is_empty() { Outcome::Success } else { Outcome::Unsuccessful })
}

/// Measures a world until another repetition changes no finding or the maximum number of repetitions is reached.
fn figures<R: Robot<Error: fmt::Display>>(
    world: &RegisteredWorld<R>,
    robots: Robots<R>,
    args: &BenchArgs,
) -> Result<Figures, Failure> {
    let (seeds, most) = if args.bench { (args.seeds, args.repeats.max(MOST_REPEATS)) } else { (1, 1) };
    let seeds: Vec<u64> = (0..seeds).map(|place| args.seed.wrapping_add(place)).collect();
    let mut times: Vec<Times> = Vec::new();
    for repetition in 1.. {
        for (place, seed) in seeds.iter().enumerate() {
            let options = WorldOptions::new(*seed, &args.option)?;
            let ran = measure::run(world.open(&options)?, robots, args.seconds)?;
            match times.get_mut(place) {
                None => times.push(ran),
                Some(times) => times.merge(&ran).map_err(|what| {
                    let help = "take everything random from `WorldOptions::seed`, and no time from a clock";
                    Failure::new(format!("world `{}`, seed {seed}: {what}", world.name), help)
                })?,
            }
        }
        let mut figures = Figures::new(const { &R::GRAPH }, world.name, &seeds, &times);
        if !args.bench {
            figures.exceeded.clear();
        }
        if repetition >= most || repetition >= args.repeats && figures.is_settled() {
            return Ok(figures);
        }
    }
    unreachable!("the last repetition returns")
}

/// Folder of the pictures: `bench` in cargo's target folder.
fn folder() -> PathBuf {
    let program = std::env::current_exe().unwrap_or_default();
    program.ancestors().nth(3).map_or_else(|| "bench".into(), |target| target.join("bench"))
}
