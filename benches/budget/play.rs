//! The fixed games.

use std::time::{Duration, Instant as Clock};

use bica::runner::{Cycle as Completed, Observer, Runner, World};
use bica::{Instant, Probe, Stopwatch, Tree};
use bica_benches::game::new_game;
use bica_motion::robot::{Command, Sensors};
use bica_player::Forward;
use bica_sim::World as SimulatedWorld;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Frame, Setup};
use bica_times::measurements::{ACT, CHAIN, CHANNELS, Cycle, Measurements, SEEING, SENSE};

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

/// Plays all games `repeats` times and records their times.
///
/// # Errors
/// If a repetition of a game differs from the first one.
pub(crate) fn all(frame: Frame, repeats: usize, measurements: &mut Measurements) -> Result<(), String> {
    for _ in 0..repeats {
        measurements.begin_repetition();
        for game in &GAMES {
            play(game, frame, measurements)?;
        }
    }
    Ok(())
}

fn play(fixture: &Fixture, frame: Frame, measurements: &mut Measurements) -> Result<(), String> {
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
        let mut cycle = phases.cycle;
        for (time, spent) in cycle.iter_mut().zip(watch.spent()) {
            *time = (spent.runs > 0).then_some(spent.total as u32);
        }
        measurements.record(&cycle).map_err(|channel| {
            let name = Forward::GRAPH.nodes.get(channel).map_or("sensing", |node| node.name);
            format!("game {} is not deterministic: {name} ran in one repetition and not in another", fixture.seed)
        })?;
    }
    Ok(())
}

/// The kinematic world with an inertial unit that reports a fall at a given time.
struct WithFall {
    world: KinematicWorld,
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
    /// Times of the channels that are not components.
    cycle: Cycle,
    began: Clock,
    tick_end: Clock,
    has_image: bool,
}

impl Default for Phases {
    fn default() -> Self {
        Self { cycle: [None; CHANNELS], began: Clock::now(), tick_end: Clock::now(), has_image: false }
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
        self.cycle[SENSE] = Some(nanoseconds(self.began.elapsed()));
    }

    fn acted(&mut self, _cycle: &Completed<'_, Forward>) {
        let now = Clock::now();
        self.cycle[ACT] = Some(nanoseconds(now - self.tick_end));
        self.cycle[CHAIN] = Some(nanoseconds(now - self.began));
        self.cycle[SEEING] = self.cycle[CHAIN].filter(|_| self.has_image);
    }
}
