//! One game: sense, think, act, a hundred times a second of the world.

use std::thread;
use std::time::{Duration, Instant as Clock};

use bica::runner::Robot;
use bica::{Instant, Tree};
use bica_motion::pose::Pose2;
use bica_player::Forward;
use bica_player::input::{HealthMonitor, RobotProfile};
use bica_player::perception::GoalDetector;
use bica_sim::SpectatorView;
use bica_sim::setup::Frame;
use glam::Vec2;

use super::fingerprint::Fingerprint;
use super::firmware::{Image, Mind};
use super::latency::Latencies;
use super::meter::Meter;
use super::scene::{GRAPH, Scene};
use super::summary::{Record, Tally};
use crate::observer::Observer;
use crate::world_factory::{self, WorldKind};
use bica_console::Failure;
use bica_console::interrupt;

/// Points of the ball's way are at least this far apart, m.
const TRAIL: f32 = 0.03;

/// What is agreed on before a game.
#[derive(Clone, Copy, Debug)]
pub struct Rules {
    pub world: WorldKind,
    pub seed: u64,
    pub size: Frame,
    pub robots: usize,
    /// The longest time of a game in the world.
    pub limit: Duration,
    pub realtime: bool,
    /// What thinks in place of this program.
    pub firmware: Option<Image>,
}

/// Plays to the first goal, to the end of the time, or until Ctrl-C.
pub fn play(rules: &Rules, observer: &mut impl Observer) -> Result<Record, Failure> {
    let mut game = Game::new(rules)?;
    let began = Clock::now();
    while !game.is_over(rules) && !interrupt::requested() {
        game.cycle()?;
        game.report(observer)?;
        if rules.realtime {
            thread::sleep(game.world.now().saturating_sub(began.elapsed()));
        }
    }
    Ok(game.into_record(rules, began.elapsed()))
}

struct Game {
    seed: u64,
    world: Box<dyn SpectatorView>,
    /// The forward; if a microcontroller thinks, its twin, which has to think the same.
    robot: Box<Forward>,
    mind: Option<Mind>,
    tally: Tally,
    /// When the last cycle was.
    thought: Duration,
    start: Pose2,
    trail: Vec<Vec2>,
    reported: usize,
}

impl Game {
    fn new(rules: &Rules) -> Result<Self, Failure> {
        let world = world_factory::open(rules)?;
        let mut robot = Box::new(Forward::new());
        robot.get_mut::<RobotProfile>().set(rules.world.profile());
        robot.get_mut::<GoalDetector>().attack(world.referee().attacks());
        let mind = rules.firmware.map(|image| image.start(world.referee().attacks())).transpose()?;
        let tally = Tally {
            cycles: 0,
            tree_changes: 0,
            fingerprint: Fingerprint::new(),
            latencies: Latencies::default(),
            meter: Meter::new(&GRAPH),
        };
        let (start, ball) = (world.referee().robot(), world.referee().ball());
        Ok(Self {
            seed: rules.seed,
            world,
            robot,
            mind,
            tally,
            thought: Duration::ZERO,
            start,
            trail: vec![ball],
            reported: 0,
        })
    }

    fn is_over(&self, rules: &Rules) -> bool {
        self.world.referee().goals() > 0 || self.world.now() >= rules.limit
    }

    fn cycle(&mut self) -> Result<(), Failure> {
        self.thought = self.world.now();
        let now = Instant::from_micros(self.thought.as_micros() as u64);
        let sensors = self.world.sensors();
        let began = Clock::now();
        self.robot.sense(&sensors).map_err(|error| Failure::new(error.to_string(), "choose a smaller --size"))?;
        self.robot.tick_with(now, &mut self.tally.meter);
        let command = self.robot.act();
        self.tally.latencies.note(began.elapsed());
        if let Some(mind) = &mut self.mind {
            mind.think(now, &sensors, &command, &self.robot)?;
        }
        self.world.act(&command);
        let ball = self.world.referee().ball();
        self.tally.fingerprint.note(&command, ball);
        self.tally.cycles += 1;
        self.tally.tree_changes += u64::from(self.tally.meter.changed());
        if self.trail.last().is_none_or(|last| last.distance(ball) > TRAIL) {
            self.trail.push(ball);
        }
        Ok(())
    }

    fn scene(&self) -> Scene<'_> {
        Scene {
            seed: self.seed,
            t: self.thought.as_secs_f64(),
            robot: &self.robot,
            referee: self.world.referee(),
            meter: &self.tally.meter,
            start: self.start,
            trail: &self.trail,
        }
    }

    fn report(&mut self, observer: &mut impl Observer) -> Result<(), Failure> {
        if let Some(view) = observer.looks_from(self.world.now(), self.world.referee()) {
            let picture = self.world.render_from(&view.from, view.width, view.height).map_err(|error| {
                Failure::new(error.to_string(), "`cargo xtask mujoco` installs what MuJoCo needs to draw")
            })?;
            observer.watched(&self.scene(), &picture)?;
        }
        if self.tally.meter.changed() {
            observer.changed(&self.scene())?;
        }
        let referee = self.world.referee();
        for happened in &referee.events()[self.reported..] {
            observer.happened(happened)?;
        }
        self.reported = referee.events().len();
        Ok(())
    }

    fn into_record(self, rules: &Rules, real: Duration) -> Record {
        let fault = self.robot.get::<HealthMonitor>().fault().map(|fault| fault.to_string());
        let firmware = self.mind.map(Mind::sum_up);
        Record { fault, firmware, ..Record::new(rules, self.world.referee(), self.world.now(), self.tally, real) }
    }
}
