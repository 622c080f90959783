//! Shots at the goal: what the goalkeeper or an idle robot lets in.

use std::time::Duration;

use bica::{Setting, Tree};
use bica::runner::{Observer, Requests, Runner};
use bica_console::Failure;
use bica_motion::joints::Joints;
use bica_motion::model::{Nao, RobotModel};
use bica_motion::robot::{CameraId, Command, Lights};
use bica_player::perception::GoalDetector;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::referee::Event;
use bica_sim::setup::{Frame, Setup, Start};
use bica_sim::shot::Shot;
use bica_sim::{CYCLE, World};
use glam::Vec2;

use crate::Keeper;
use crate::skills::START;

/// Time after a kick in which a ball may still get into the goal, and the goalkeeper may kick it away.
pub const AFTER: Duration = Duration::from_secs(25);

/// Who stands in the goal.
#[derive(Clone, Copy, Debug)]
pub enum Robot<'a> {
    /// The goalkeeper, with parameters that are not the defaults.
    Goalkeeper(&'a [Setting]),
    /// A robot that stands still.
    Idle,
}

/// What became of a shot. Without a robot in the way every shot is a goal, so a ball that is not let in was saved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
pub struct ShotResult {
    /// Seed of the world and of the shot.
    pub seed: u64,
    /// Whether the whole ball crossed the goal line.
    pub let_in: bool,
    /// Whether the robot kicked the ball after the shot.
    pub kicked: bool,
    /// Number of the robot's falls, dives included.
    pub falls: usize,
}

/// Makes a world with the robot in the middle of its goal and a ball that rests in front of it.
///
/// # Errors
/// If the world refuses the setup.
pub fn world(seed: u64, ball: Vec2, frame: Frame) -> Result<KinematicWorld, Failure> {
    let start = Some(Start { robot: START, ball });
    let setup = Setup { seed, frame, goalkeeper: false, start, ..Setup::default() };
    KinematicWorld::new(&setup).map_err(|error| Failure::new(error.to_string(), "choose another shot"))
}

/// Makes the goalkeeper of a world, with parameters that are not the defaults.
///
/// # Errors
/// If a parameter is refused.
pub fn goalkeeper(world: &KinematicWorld, settings: &[Setting]) -> Result<Box<Keeper>, Failure> {
    let mut keeper = Box::new(Keeper::new());
    keeper.get_mut::<GoalDetector>().attack(world.referee().attacks());
    keeper.set_params(settings).map_err(|refusal| Failure::new(refusal.to_string(), "choose another --set"))?;
    Ok(keeper)
}

/// Plays one shot from the camera images of a world.
///
/// # Errors
/// If the world refuses the shot or the goalkeeper an image.
pub fn play(robot: Robot<'_>, seed: u64, shot: &Shot, frame: Frame) -> Result<ShotResult, Failure> {
    let mut world = world(seed, shot.from, frame)?;
    let mut series = Series::new(*shot);
    match robot {
        Robot::Idle => {
            let command = stand();
            while series.referee(&mut world)? {
                world.act(&command);
            }
        }
        Robot::Goalkeeper(settings) => {
            let mut runner = Runner::new(goalkeeper(&world, settings)?, world);
            while series.referee(runner.world_mut())? {
                cycle(&mut runner)?;
            }
            world = runner.into_parts().1;
        }
    }
    Ok(series.result(seed, &world))
}

/// Runs one cycle.
///
/// # Errors
/// If the goalkeeper refuses an image.
pub fn cycle<Q: Requests, O: Observer<Keeper>>(
    runner: &mut Runner<Box<Keeper>, KinematicWorld, Q, O>,
) -> Result<(), Failure> {
    let refused = |error: bica_player::input::FrameTooLarge| Failure::new(error.to_string(), "choose a smaller --size");
    runner.cycle().map(drop).map_err(refused)
}

/// Command of a robot that stands still.
fn stand() -> Command {
    Command { targets: Nao::STAND, stiffness: Joints::all(1.0), lights: Lights::default(), camera: CameraId::Top }
}

/// A shot in progress.
#[derive(Clone, Copy, Debug)]
pub struct Series {
    shot: Shot,
    kick: Duration,
    is_kicked: bool,
}

impl Series {
    /// Begins a shot at the start of a world.
    #[must_use]
    pub const fn new(shot: Shot) -> Self {
        Self { shot, kick: shot.rest, is_kicked: false }
    }

    /// Kicks the ball when its time has come. Returns whether the shot goes on; to be called before each cycle.
    ///
    /// # Errors
    /// If the world refuses the velocity.
    pub fn referee(&mut self, world: &mut KinematicWorld) -> Result<bool, Failure> {
        if !self.is_kicked && world.now() >= self.kick {
            self.is_kicked = true;
            let ball = world.referee().ball();
            let velocity = self.shot.speed * (self.shot.aim - ball).normalize_or_zero();
            let refused = |error: bica_sim::setup::SetupError| Failure::new(error.to_string(), "choose another shot");
            world.set_ball(ball, velocity).map_err(refused)?;
        }
        let is_over = self.is_in(world) && world.now() > self.kick + CYCLE * 200;
        Ok(!is_over && world.now() < self.kick + AFTER)
    }

    fn is_in(&self, world: &KinematicWorld) -> bool {
        world.referee().events().iter().any(|timed| timed.at >= self.kick && timed.event == Event::OwnGoal)
    }

    /// What became of the shot.
    #[must_use]
    pub fn result(&self, seed: u64, world: &KinematicWorld) -> ShotResult {
        let mut events = world.referee().events().iter().filter(|timed| timed.at >= self.kick);
        let kicked = events.any(|timed| matches!(timed.event, Event::Kick { .. }));
        ShotResult { seed, let_in: self.is_in(world), kicked, falls: world.referee().falls() }
    }
}
