//! Forward that is pushed over.

use bica::Tree;
use bica::runner::Runner;
use bica_app::Failure;
use bica_motion::fall::FallState;
use bica_motion::joints::Joint;
use bica_motion::model::simulation::NAO;
use bica_motion::pose::Pose2;
use bica_player::Forward;
use bica_player::behaviour::SafetyGuard;
use bica_player::input::RobotProfile;
use bica_player::perception::{FallDetector, GoalDetector};
use bica_sim::World;
use bica_sim::mujoco::{MujocoWorld, Physics};
use bica_sim::referee::Event;
use bica_sim::setup::{Setup, Start};
use glam::Vec2;

use super::series::Series;
use super::walker::cycles;

/// Largest stiffness of relaxed legs.
const RELAXED: f32 = 0.35;

/// A forward in a world, and its first fall.
pub(super) struct FallSubject {
    runner: Runner<Box<Forward>, MujocoWorld>,
    /// Time at which the robot detected a fall, s.
    pub(super) fall_detected: Option<f32>,
    /// First ground contact of a part other than the feet.
    pub(super) impact: Option<Impact>,
    /// Number of attempts to get up.
    pub(super) attempts: u8,
    gets_up: bool,
}

/// Impact of a fall.
#[derive(Clone, Copy, Debug)]
pub(super) struct Impact {
    /// Time, s.
    pub(super) at: f32,
    /// Whether the legs were relaxed.
    pub(super) relaxed: bool,
}

/// Recovery from a fall.
#[derive(Clone, Copy, Debug)]
pub(super) struct Recovery {
    /// Time from the first fall until the robot last got up, or until now, s.
    pub(super) after: f32,
    /// Time since the robot last got up, s; 0 if it lies.
    pub(super) since: f32,
}

impl FallSubject {
    /// Creates a world with a standing robot, alone and without cameras.
    pub(super) fn new(series: &Series, seed: u64) -> Result<Self, Failure> {
        let start = Some(Start { robot: Pose2::ORIGIN, ball: Vec2::new(-2.8, 1.8) });
        Self::in_game(&Setup { seed, goalkeeper: false, start, ..Setup::default() }, &series.physics, false)
    }

    /// Creates a world with a robot at the start of a game.
    pub(super) fn in_game(setup: &Setup, physics: &Physics, cameras: bool) -> Result<Self, Failure> {
        let world = MujocoWorld::new(NAO, setup, &Physics { cameras, ..*physics })
            .map_err(|error| Failure::new(error.to_string(), "try another value"))?;
        let mut robot = Box::new(Forward::new());
        robot.get_mut::<RobotProfile>().set(NAO.dynamic_profile);
        robot.get_mut::<GoalDetector>().attack(world.referee().attacks());
        Ok(Self { runner: Runner::new(robot, world), fall_detected: None, impact: None, attempts: 0, gets_up: false })
    }

    /// Runs the forward for some seconds.
    pub(super) fn run(&mut self, seconds: f32) -> Result<(), Failure> {
        for _ in 0..cycles(seconds) {
            let now = self.runner.world().now().as_secs_f32();
            let command =
                self.runner.cycle().map_err(|error| Failure::new(error.to_string(), "choose a smaller image"))?;
            let falls = self.runner.robot().get::<FallDetector>().state() != FallState::Upright;
            self.fall_detected = self.fall_detected.or_else(|| falls.then_some(now));
            let relaxed = command.stiffness[Joint::LKneePitch] <= RELAXED;
            let touches = self.runner.world().body_touches_floor();
            self.impact = self.impact.or_else(|| touches.then_some(Impact { at: now, relaxed }));
            self.count_attempts();
        }
        Ok(())
    }

    fn count_attempts(&mut self) {
        let robot = self.runner.robot();
        let guard = robot.of::<SafetyGuard>();
        let gets_up = guard.is_active() && guard.state_name() == Some("get_up");
        self.attempts += u8::from(gets_up && !self.gets_up);
        self.gets_up = gets_up;
    }

    /// Pushes the robot: adds to the velocity of its torso, m/s, field frame.
    pub(super) fn push(&mut self, velocity: Vec2) {
        self.runner.world_mut().add_velocity(velocity);
    }

    /// Returns the time from the fall until the robot got up, by the referee, s.
    pub(super) fn time_down(&self) -> Option<f32> {
        let when = |matches: fn(&Event) -> bool| {
            let happened = self.runner.world().referee().events().iter().find(|happened| matches(&happened.event));
            happened.map(|happened| happened.at.as_secs_f32())
        };
        let fell = when(|event| matches!(event, Event::Fall(_)));
        let up = when(|event| *event == Event::GotUp);
        fell.zip(up).map(|(fell, up)| up - fell)
    }

    /// Returns the recovery from the first fall, by the referee; `None` before a fall.
    pub(super) fn recovery(&self) -> Option<Recovery> {
        let now = self.runner.world().now().as_secs_f32();
        let mut events = self.runner.world().referee().events().iter();
        let fell = events.find(|happened| matches!(happened.event, Event::Fall(_)))?.at.as_secs_f32();
        let last = events.rfind(|happened| matches!(happened.event, Event::Fall(_) | Event::GotUp));
        let up = last.filter(|last| last.event == Event::GotUp).map(|last| last.at.as_secs_f32());
        Some(Recovery { after: up.unwrap_or(now) - fell, since: up.map_or(0.0, |up| now - up) })
    }

    /// Returns the time from the first fall to the next goal, s.
    pub(super) fn time_to_goal(&self) -> Option<f32> {
        let mut events = self.runner.world().referee().events().iter();
        let fell = events.find(|happened| matches!(happened.event, Event::Fall(_)))?;
        let goal = events.find(|happened| happened.event == Event::Goal)?;
        Some(goal.at.saturating_sub(fell.at).as_secs_f32())
    }

    /// Returns whether the robot has continued the game.
    pub(super) fn is_playing(&self) -> bool {
        !self.runner.robot().of::<SafetyGuard>().is_active()
    }
}
