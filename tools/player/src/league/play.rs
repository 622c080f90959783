//! `play --world league`.

use std::path::Path;
use std::sync::{Arc, PoisonError};

use bica::Tree;
use bica::runner::{Runner, World};
use bica_app::{Batch, Console, Failure, Outcome, RunArgs, interrupt};
use bica_evaluation::statistics::percentile;
use bica_player::league::Forward;
use bica_recording::{ReplayOptions, ReplayReport};
use serde::Serialize;

use super::entry::{Entry, failure, server};
use super::robot::{self, FOOTBALLERS, Footballer, ROBOT, Standing, WORLD};
use super::world::{LeagueGame, LeagueWorld};
use crate::cli::Play;
use crate::play::recorded_options;

/// Report of a series, for JSON.
#[derive(Serialize)]
struct Report<'a> {
    schema: &'static str,
    robot: &'static str,
    goals: usize,
    falls: usize,
    games: &'a [LeagueGame],
}

/// Plays in the league's server as the command line requests.
pub(crate) fn run(args: &Play) -> Result<Outcome, Failure> {
    let entry = entry(args)?;
    let robot = args.tuning.robot().and_then(|name| FOOTBALLERS.iter().find(|robot| robot.id() == name));
    let Some(robot) = robot else {
        let known: Vec<_> = FOOTBALLERS.iter().map(|robot| format!("--robot {}", robot.id())).collect();
        let what = "the forward plays in the league's server with the body of one of its robots";
        return Err(Failure::new(what, format!("give {}, too", known.join(" or "))));
    };
    match (&args.film, args.games) {
        (None, None) => game(robot, args, entry),
        (None, Some(_)) => series(robot, args, &entry),
        (Some(film), _) => filmed(robot, args, &entry, film),
    }
}

/// Plays one game and films it.
#[cfg(feature = "mujoco")]
fn filmed(robot: &'static Footballer, args: &Play, entry: &Entry, film: &Path) -> Result<Outcome, Failure> {
    let layers = args.tuning.of_known_robot().layers(const { &Forward::GRAPH }, WORLD)?;
    layers.apply(&mut *(robot.forward)())?;
    let console = Console::new(args.json);
    let game = super::film::play(robot, entry, &layers.settings(), args.game_seconds(), film, console)?;
    console.print_json(&game)?;
    Ok(Outcome::of(game.goal_s.is_some() || entry.server.is_some()))
}

/// Returns an error: MuJoCo, which renders the film, is missing from this program.
#[cfg(not(feature = "mujoco"))]
fn filmed(_robot: &'static Footballer, _args: &Play, _entry: &Entry, _film: &Path) -> Result<Outcome, Failure> {
    let help = "install its library with `cargo xtask mujoco`, then run \
                `cargo run --release --features mujoco -- play --world league --robot t1 --film FILE`";
    Err(Failure::new("a film of the league needs MuJoCo, and this program was built without it", help))
}

/// Replays the recording of a game; `None` if the recording is not of this robot.
pub(crate) fn replay(options: &ReplayOptions<'_>) -> Option<Result<ReplayReport, Failure>> {
    let recorded = recorded_options(options.path, WORLD)?;
    let robot = FOOTBALLERS.iter().find(|robot| recorded.contains(&option(robot))).unwrap_or(&FOOTBALLERS[0]);
    Some(robot::app(robot, Entry::default(), &Standing::default()).repeat(options))
}

/// Option of the world that names the robot, for the replay of a recording.
fn option(robot: &Footballer) -> String {
    format!("{ROBOT}={}", robot.id())
}

/// Plays one game, with all that the program of a robot offers.
fn game(robot: &'static Footballer, args: &Play, entry: Entry) -> Result<Outcome, Failure> {
    let standing = Standing::default();
    let is_own = entry.server.is_none();
    let run = RunArgs {
        realtime: args.realtime,
        seconds: Some(args.game_seconds()),
        tuning: args.tuning.of_known_robot(),
        ..args.run_args(WORLD, vec![option(robot)])
    };
    let outcome = robot::app(robot, entry, &standing).play(&run)?;
    let (game, error) = &*standing.lock().unwrap_or_else(PoisonError::into_inner);
    match error {
        Some(error) => Err(failure(error)),
        None if is_own && game.goal_s.is_none() && outcome == Outcome::Success => Ok(Outcome::Unsuccessful),
        None => Ok(outcome),
    }
}

/// Plays a game for each seed, each in its own server.
fn series(robot: &'static Footballer, args: &Play, entry: &Entry) -> Result<Outcome, Failure> {
    if entry.server.is_some() {
        return Err(Failure::new("a series starts a server for each game", "leave out --server or --games"));
    }
    let layers = args.tuning.of_known_robot().layers(const { &Forward::GRAPH }, WORLD)?;
    // Each game has its own tree: values that do not fit together are reported once.
    layers.apply(&mut *(robot.forward)())?;
    let console = Console::new(args.json);
    let games = Batch::new(args.seed, args.games.unwrap_or(1), args.threads).run(|seed| {
        let standing = Standing::default();
        let world = LeagueWorld::open(robot, &Entry { seed, ..entry.clone() }, Arc::clone(&standing));
        let mut runner = Runner::new((robot.forward)(), world.map_err(|error| failure(&error))?);
        _ = runner.robot_mut().set_params(&layers.settings());
        let limit = runner.world().now() + bica::Duration::from_micros((args.game_seconds() * 1e6) as u64);
        while !interrupt::requested() && !runner.world().is_over() && runner.world().now() < limit {
            // The error type is infallible.
            _ = runner.cycle();
        }
        drop(runner);
        let (game, error) = core::mem::take(&mut *standing.lock().unwrap_or_else(PoisonError::into_inner));
        error.map_or(Ok(()), |error| Err(failure(&error)))?;
        console.print(&game.line())?;
        Ok(game)
    })?;
    let goals = games.iter().filter(|game| game.goal_s.is_some()).count();
    let falls = games.iter().filter(|game| game.fall_s.is_some()).count();
    console.print_row("goals", &format!("{goals} of {}, by the server's score", games.len()))?;
    console.print_row("falls", &falls.to_string())?;
    let mut times: Vec<f64> = games.iter().filter_map(|game| game.goal_s).collect();
    times.sort_by(f64::total_cmp);
    if let Some(median) = percentile(&times, 0.5) {
        console.print_row("time to goal", &format!("p50 {median:.1} s"))?;
    }
    console.print_json(&Report { schema: "bica-player/league/1", robot: robot.id(), goals, falls, games: &games })?;
    let needed = args.at_least.map_or(games.len(), |needed| needed as usize);
    Ok(Outcome::of(goals >= needed))
}

/// Returns server, team and number of the player; refuses options that this world does not support.
fn entry(args: &Play) -> Result<Entry, Failure> {
    if args.pictures.is_some() || args.robots > 0 {
        let what = "the league's server has no pictures and other robots here";
        return Err(Failure::new(what, "leave out --pictures and --robots; --against plays with a second team"));
    }
    if args.film.is_some() && (args.games.is_some() || args.record.record.is_some() || args.link.is_paced()) {
        let what = "a game of the league that is filmed is neither recorded nor served, and is no series";
        return Err(Failure::new(what, "leave out --film, or --games, --record and --serve"));
    }
    let server = args.league.server.as_deref().map(server).transpose();
    let entry = Entry {
        server: server.map_err(|help| Failure::new("--server names no server", help))?,
        team: args.league.team.clone(),
        number: args.league.number,
        realtime: args.realtime,
        against: args.league.against,
        seed: args.seed,
    };
    entry.check()?;
    Ok(entry)
}
