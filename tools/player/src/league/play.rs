//! `play --world league`.

use std::path::Path;

use bica::{Setting, Tree};
use bica_app::{Batch, Console, Failure, Outcome, interrupt};
use bica_evaluation::statistics::percentile;
use bica_league::{Error, Server};
use bica_player_t1::{Forward, PARAMETERS};
use bica_tuning::Layers;
use serde::Serialize;

use super::game::{Change, LeagueGame, play};
use crate::cli::Play;

/// The robot that plays.
const ROBOT: &str = "t1";

/// JSON of a series.
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
    check(args)?;
    let settings = settings(args)?;
    let console = Console::new(args.json);
    let batch = Batch::new(args.seed, args.games.unwrap_or(1), args.threads);
    let games = batch.run(|seed| {
        let mut story = Vec::new();
        let server =
            Server::start(&Server::installed(Path::new(".")), args.realtime).map_err(|error| failure(&error))?;
        let game = play(&server, &settings, seed, args.seconds, &mut |change| story.push(line(change)), &|| {
            !interrupt::requested()
        });
        if args.games.is_none() {
            story.iter().try_for_each(|line| console.print(line))?;
        }
        let game = game.map_err(|error| failure(&error))?;
        console.print(&result(&game))?;
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
    console.print_json(&Report { schema: "bica-player/league/1", robot: ROBOT, goals, falls, games: &games })?;
    let needed = args.at_least.map_or(games.len(), |needed| needed as usize);
    Ok(match interrupt::requested() {
        true => Outcome::Interrupted,
        false if goals >= needed => Outcome::Success,
        false => Outcome::Unsuccessful,
    })
}

/// Refuses what this world does not have.
fn check(args: &Play) -> Result<(), Failure> {
    if args.tuning.robot() != Some(ROBOT) {
        let what = "the forward plays in the league's server with the body of a T1 only";
        return Err(Failure::new(what, format!("give --robot {ROBOT}, too")));
    }
    let observed = [args.pictures.is_some(), args.film.is_some(), args.record.record.is_some(), args.link.is_paced()];
    if observed.contains(&true) || args.robots > 0 {
        let what = "the league's server has no pictures, films, recordings, monitors and other robots here";
        return Err(Failure::new(what, "leave out --pictures, --film, --record, --serve and --robots"));
    }
    Ok(())
}

/// Returns the parameters: the robot's, those of the tune files `league.toml` and `t1.toml`, and those of the command line.
fn settings(args: &Play) -> Result<Vec<Setting>, Failure> {
    let mut layers = Layers::new(const { &Forward::GRAPH });
    layers.read_text("the parameters of the T1", PARAMETERS)?;
    let layers = args.tuning.over(layers, "league")?;
    layers.apply(&mut *Box::new(Forward::new()))?;
    Ok(layers.settings())
}

fn failure(error: &Error) -> Failure {
    let help = match error {
        Error::Start(..) => "`cargo xtask league` installs it; start this program in the workspace",
        Error::NotReady(_) => "see its output above; `cargo xtask league` installs it",
        _ => "see docs/league.md",
    };
    Failure::new(error.to_string(), help)
}

fn line(Change { at, state, place, ball }: &Change) -> String {
    let [place, ball] =
        [place, ball].map(|at| at.map_or_else(|| "-".to_owned(), |at| format!("{:.2} {:.2}", at.x, at.y)));
    format!("{at:7.2} s  {state:14} robot {place}  ball {ball}")
}

fn result(game: &LeagueGame) -> String {
    let LeagueGame { seed, score: [ours, theirs], goal_s, fall_s, seconds } = game;
    let end = match (goal_s, fall_s) {
        (Some(at), _) => format!("goal after {at:.1} s"),
        (None, Some(at)) => format!("fell after {at:.1} s"),
        (None, None) => format!("no goal in {seconds:.0} s"),
    };
    format!("seed {seed}: {ours}:{theirs}, {end}")
}
