//! The forward, to be thrown over.

use bica::runner::Robot;
use bica::{Instant, Tree};
use bica_motion::fall::FallState;
use bica_motion::joints::Joint;
use bica_motion::pose::Pose2;
use bica_motion::profile::Profile;
use bica_player::Forward;
use bica_player::behaviour::SafetyGuard;
use bica_player::input::RobotProfile;
use bica_player::perception::{FallDetector, GoalDetector};
use bica_sim::World;
use bica_sim::mujoco::{MujocoWorld, Physics};
use bica_sim::referee::Event;
use bica_sim::setup::{Setup, Start};
use glam::Vec2;

use super::bench::Bench;
use super::walker::cycles;
use bica_console::Failure;

/// Legs that are held no harder than this have let go.
const SOFT: f32 = 0.35;

/// A whole forward, and what befell it first.
pub struct FallSubject {
    world: MujocoWorld,
    robot: Box<Forward>,
    /// When it felt that it falls, s.
    pub felt: Option<f32>,
    /// When more than its feet touched the ground, s, and whether its legs were soft then.
    pub hit: Option<(f32, bool)>,
    /// How often it tried to get up.
    pub tries: u8,
    tries_now: bool,
}

/// How long someone who fell has been on its feet again.
#[derive(Clone, Copy, Debug)]
pub struct Stood {
    /// From the first fall until it got up last, or until now, s.
    pub after: f32,
    /// Since it got up last, s; 0 if it lies.
    pub since: f32,
}

impl FallSubject {
    /// Stands there, alone and without eyes.
    pub fn new(bench: &Bench, seed: u64) -> Result<Self, Failure> {
        let start = Some(Start { robot: Pose2::ORIGIN, ball: Vec2::new(-2.8, 1.8) });
        Self::in_game(&Setup { seed, goalkeeper: false, start, ..Setup::default() }, &bench.physics, false)
    }

    /// In a game that begins.
    pub fn in_game(setup: &Setup, physics: &Physics, cameras: bool) -> Result<Self, Failure> {
        let world = MujocoWorld::new(setup, &Physics { cameras, ..*physics })
            .map_err(|error| Failure::new(error.to_string(), "try another value"))?;
        let mut robot = Box::new(Forward::new());
        robot.get_mut::<RobotProfile>().set(&Profile::NAO);
        robot.get_mut::<GoalDetector>().attack(world.referee().attacks());
        Ok(Self { world, robot, felt: None, hit: None, tries: 0, tries_now: false })
    }

    /// Does what it likes for some seconds.
    pub fn live(&mut self, seconds: f32) -> Result<(), Failure> {
        for _ in 0..cycles(seconds) {
            let now = self.world.now();
            self.robot
                .sense(&self.world.sensors())
                .map_err(|error| Failure::new(error.to_string(), "choose a smaller image"))?;
            self.robot.tick(Instant::from_micros(now.as_micros() as u64));
            let command = self.robot.act();
            self.world.act(&command);
            let falls = self.robot.get::<FallDetector>().state() != FallState::Upright;
            self.felt = self.felt.or_else(|| falls.then_some(now.as_secs_f32()));
            let soft = command.stiffness[Joint::LKneePitch] <= SOFT;
            self.hit = self.hit.or_else(|| self.world.body_touches_floor().then_some((now.as_secs_f32(), soft)));
            self.count();
        }
        Ok(())
    }

    fn count(&mut self) {
        let guard = Forward::id::<SafetyGuard>();
        let states = Forward::GRAPH.nodes[guard.index()].states;
        let tries =
            self.robot.is_active(guard) && self.robot.state(guard).is_some_and(|state| states[state].name == "get_up");
        self.tries += u8::from(tries && !self.tries_now);
        self.tries_now = tries;
    }

    /// Throws it over: changes the velocity of its torso, m/s, field frame.
    pub fn push(&mut self, velocity: Vec2) {
        self.world.push(velocity);
    }

    /// How long it lay, s, if it fell and got up; by the referee.
    pub fn lay(&self) -> Option<f32> {
        let when = |wanted: fn(&Event) -> bool| {
            let happened = self.world.referee().events().iter().find(|happened| wanted(&happened.event));
            happened.map(|happened| happened.at.as_secs_f32())
        };
        let fell = when(|event| matches!(event, Event::Fall(_)));
        let up = when(|event| *event == Event::GotUp);
        fell.zip(up).map(|(fell, up)| up - fell)
    }

    /// Whether it is on its feet since its first fall, and how long; none before that; by the referee.
    pub fn stood(&self) -> Option<Stood> {
        let now = self.world.now().as_secs_f32();
        let mut events = self.world.referee().events().iter();
        let fell = events.find(|happened| matches!(happened.event, Event::Fall(_)))?.at.as_secs_f32();
        let last = events.rfind(|happened| matches!(happened.event, Event::Fall(_) | Event::GotUp));
        let up = last.filter(|last| last.event == Event::GotUp).map(|last| last.at.as_secs_f32());
        Some(Stood { after: up.unwrap_or(now) - fell, since: up.map_or(0.0, |up| now - up) })
    }

    /// From its first fall to the next goal, s, if both happened.
    pub fn scored(&self) -> Option<f32> {
        let mut events = self.world.referee().events().iter();
        let fell = events.find(|happened| matches!(happened.event, Event::Fall(_)))?;
        let goal = events.find(|happened| happened.event == Event::Goal)?;
        Some(goal.at.saturating_sub(fell.at).as_secs_f32())
    }

    /// Whether it goes on with what it did before.
    pub fn plays(&self) -> bool {
        !self.robot.is_active(Forward::id::<SafetyGuard>())
    }
}
