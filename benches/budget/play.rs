//! The fixed games.

use std::time::{Duration, Instant as Clock};

use bica::runner::{Cycle as Completed, Observer, Runner, World};
use bica::{Instant, Probe, Stopwatch, Tree};
use bica_benches::game::new_game;
use bica_motion::robot::{Command, Sensors};
use bica_player::{Forward, Model};
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

/// Games in which, together, every component runs.
const GAMES: [Fixture; 4] = [
    Fixture { seed: 0, robots: 2, fall: None },
    Fixture { seed: 28, robots: 2, fall: None },
    Fixture { seed: 66, robots: 2, fall: None },
    Fixture { seed: 3, robots: 0, fall: Some(Duration::from_secs(6)) },
];
/// Duration of the reported fall.
const FALL: Duration = Duration::from_secs(2);
/// Reported torso pitch of a robot that lies on its front, rad.
const PITCH: f32 = 1.5;
/// Maximum duration of a game in simulated time.
const LIMIT: Duration = Duration::from_mins(1);

/// Phases of a cycle: writing the sensor values, reading the command, the whole chain from sensing to acting, and the chain in
/// cycles with a new image.
pub(crate) const PHASES: [&str; 4] = ["sensing", "acting", "the whole chain", "with an image"];

/// Plays all games, and passes the times of each cycle: of the components, then of the phases, ns.
///
/// # Errors
/// If a cycle cannot be run.
pub(crate) fn all(frame: Frame, mut each: impl FnMut(&[Option<u32>])) -> Result<(), String> {
    GAMES.iter().try_for_each(|game| play(game, frame, &mut each))
}

fn play(fixture: &Fixture, frame: Frame, each: &mut impl FnMut(&[Option<u32>])) -> Result<(), String> {
    let game = new_game::<Forward>(&Setup { seed: fixture.seed, robots: fixture.robots, frame, ..Setup::default() });
    let (robot, world, ..) = game.into_parts();
    let began = Clock::now();
    let watch: Stopwatch<_, { Forward::COUNT }> = Stopwatch::new(|| began.elapsed().as_nanos() as u64);
    let world = WithFall { world, fall: fixture.fall };
    let mut game = Runner::new(robot, world).with_observer((Phases::default(), watch));
    while game.world().world.referee().goals() == 0 && SimulatedWorld::now(&game.world().world) < LIMIT {
        game.observer_mut().1.reset();
        game.cycle().map_err(|error| error.to_string())?;
        let (phases, watch) = game.observer();
        let components = watch.spent().iter().map(|spent| (spent.runs > 0).then_some(spent.total as u32));
        each(&components.chain(phases.times).collect::<Vec<_>>());
    }
    Ok(())
}

/// The kinematic world with an inertial unit that reports a fall at a given time.
struct WithFall {
    world: KinematicWorld<Model>,
    fall: Option<Duration>,
}

impl World<Forward> for WithFall {
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
}

/// Measures the phases of a cycle.
struct Phases {
    /// Times of [`PHASES`], ns.
    times: [Option<u32>; PHASES.len()],
    began: Clock,
    tick_end: Clock,
    has_image: bool,
}

impl Default for Phases {
    fn default() -> Self {
        Self { times: [None; PHASES.len()], began: Clock::now(), tick_end: Clock::now(), has_image: false }
    }
}

const fn nanoseconds(time: Duration) -> u32 {
    time.as_nanos() as u32
}

impl Probe for Phases {
    fn cycle_end(&mut self) {
        self.tick_end = Clock::now();
    }
}

impl Observer<Forward> for Phases {
    fn sensing(&mut self, _now: Instant, sensors: &Sensors<'_>) {
        self.has_image = sensors.image.is_some();
        self.began = Clock::now();
    }

    fn sensed(&mut self) {
        self.times[0] = Some(nanoseconds(self.began.elapsed()));
    }

    fn acted(&mut self, _cycle: &Completed<'_, Forward>) {
        let now = Clock::now();
        self.times[1] = Some(nanoseconds(now - self.tick_end));
        self.times[2] = Some(nanoseconds(now - self.began));
        self.times[3] = self.times[2].filter(|_| self.has_image);
    }
}
