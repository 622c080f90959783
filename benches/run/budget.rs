//! The forward in fixed games, with images of each size.

use std::process::ExitCode;
use std::time::Duration;

use bica::Instant;
use bica::runner::World;
use bica_app::{App, WorldOptions};
use bica_field::GoalColour;
use bica_motion::model::simulation::NAO;
use bica_motion::robot::{Command, Sensors};
use bica_player::Forward;
use bica_sim::World as SimulatedWorld;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Frame, Setup};

/// Game that is played until a goal.
struct Fixture {
    seed: u64,
    robots: usize,
    /// Time at which the inertial unit reports a fall; the robot does not fall by itself in these games.
    fall: Option<Duration>,
}

/// Games in which, together, every component runs. The seeds of the measurement are the indices.
const GAMES: [Fixture; 4] = [
    Fixture { seed: 0, robots: 2, fall: None },
    Fixture { seed: 28, robots: 2, fall: None },
    Fixture { seed: 66, robots: 2, fall: None },
    Fixture { seed: 3, robots: 0, fall: Some(Duration::from_secs(6)) },
];
/// The goal that a new forward attacks.
const ATTACKED: GoalColour = GoalColour::Yellow;
/// Duration of the reported fall.
const FALL: Duration = Duration::from_secs(2);
/// Reported torso pitch of a robot that lies on its front, rad.
const PITCH: f32 = 1.5;

/// Measures the forward with these options of `bica_app`'s benchmarks.
pub(crate) fn run(options: &[&str]) -> ExitCode {
    let games = GAMES.len().to_string();
    let words = ["forward", "--bench", "--seeds", &games].into_iter().chain(options.iter().copied());
    App::<Forward>::new("forward")
        .world("160x120", |options| Game::new(options, Frame::Small))
        .world("320x240", |options| Game::new(options, Frame::Medium))
        .world("640x480", |options| Game::new(options, Frame::Large))
        .describe(|command| command.args_override_self(true))
        .bench_from(words.map(Into::into))
}

/// The kinematic world with an inertial unit that reports a fall at a given time.
struct Game {
    world: KinematicWorld,
    fall: Option<Duration>,
}

impl Game {
    fn new(options: &WorldOptions, frame: Frame) -> Self {
        let Fixture { seed, robots, fall } = GAMES[options.seed as usize % GAMES.len()];
        let setup = Setup { seed, robots, frame, attacks: Some(ATTACKED), ..Setup::default() };
        Self { world: KinematicWorld::new(NAO, &setup).expect("a valid setup"), fall }
    }
}

impl World<Forward> for Game {
    fn now(&self) -> Instant {
        World::<Forward>::now(&self.world)
    }

    fn sensors(&mut self) -> Sensors<'_> {
        let falls = self.fall.is_some_and(|at| (at..at + FALL).contains(&SimulatedWorld::now(&self.world)));
        let mut sensors = World::<Forward>::sensors(&mut self.world);
        if falls {
            sensors.inertial.pitch = PITCH;
        }
        sensors
    }

    fn act(&mut self, command: &Command) {
        World::<Forward>::act(&mut self.world, command);
    }

    fn is_over(&self) -> bool {
        self.world.referee().goals() > 0
    }
}
