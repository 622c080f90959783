//! The fixed games.

use std::time::{Duration, Instant as Clock};

use bica::runner::Robot;
use bica::{Stopwatch, Tree};
use bica_player::Forward;
use bica_sim::World;
use bica_sim::setup::{Frame, Setup};

use crate::game::Game;
use crate::lanes::{ACT, CHAIN, Cycle, LANES, Lanes, SEEING, SENSE};

/// A game that is played to its goal.
struct Fixture {
    seed: u64,
    robots: usize,
    /// When the inertial unit is made to tell of a fall, of which these games have none else.
    fall: Option<Duration>,
}

/// Together they make every component run.
const GAMES: [Fixture; 4] = [
    Fixture { seed: 0, robots: 2, fall: None },
    Fixture { seed: 28, robots: 2, fall: None },
    Fixture { seed: 66, robots: 2, fall: None },
    Fixture { seed: 3, robots: 0, fall: Some(Duration::from_secs(6)) },
];
/// How long it tells of the fall.
const FALL: Duration = Duration::from_secs(2);
/// What it tells then: the torso lies on its front, rad.
const PITCH: f32 = 1.5;
/// The longest game, in the world.
const LIMIT: Duration = Duration::from_mins(1);

/// Plays all the games as often as asked.
///
/// # Errors
/// If a game was not the same when it was played again.
pub(crate) fn all(frame: Frame, repeats: usize, lanes: &mut Lanes) -> Result<(), String> {
    for _ in 0..repeats {
        lanes.rewind();
        for game in &GAMES {
            play(game, frame, lanes)?;
        }
    }
    Ok(())
}

fn play(fixture: &Fixture, frame: Frame, lanes: &mut Lanes) -> Result<(), String> {
    let mut game = Game::new(&Setup { seed: fixture.seed, robots: fixture.robots, frame, ..Setup::default() });
    while game.world.referee().goals() == 0 && game.world.now() < LIMIT {
        let falls = fixture.fall.is_some_and(|at| (at..at + FALL).contains(&game.world.now()));
        let cycle = cycle(&mut game, falls)?;
        lanes.note(&cycle).map_err(|lane| {
            let name = Forward::GRAPH.nodes.get(lane).map_or("sensing", |node| node.name);
            format!("game {} was not the same again: {name} ran in one and not in the other", fixture.seed)
        })?;
    }
    Ok(())
}

fn cycle(game: &mut Game, falls: bool) -> Result<Cycle, String> {
    let now = game.now();
    let mut sensors = game.world.sensors();
    if falls {
        sensors.inertial.pitch = PITCH;
    }
    let sees = sensors.image.is_some();
    let began = Clock::now();
    let mut watch: Stopwatch<_, { Forward::COUNT }> = Stopwatch::new(|| began.elapsed().as_nanos() as u64);
    game.robot.sense(&sensors).map_err(|error| error.to_string())?;
    let sensed = Clock::now();
    game.robot.tick_with(now, &mut watch);
    let thought = Clock::now();
    let command = game.robot.act();
    let acted = Clock::now();
    game.world.act(&command);

    let mut cycle = [None; LANES];
    for (time, spent) in cycle.iter_mut().zip(watch.spent()) {
        *time = (spent.runs > 0).then_some(spent.total as u32);
    }
    let ns = |time: Duration| Some(time.as_nanos() as u32);
    cycle[SENSE] = ns(sensed - began);
    cycle[ACT] = ns(acted - thought);
    cycle[CHAIN] = ns(acted - began);
    cycle[SEEING] = cycle[CHAIN].filter(|_| sees);
    Ok(cycle)
}
