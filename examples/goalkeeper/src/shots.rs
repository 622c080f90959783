//! Shots at the goal of a goalkeeper or an idle robot.

use std::ops::RangeInclusive;
use std::time::Duration;

use bica::runner::Runner;
use bica::{Setting, Tree};
use bica_app::{Batch, Failure};
use bica_field::GoalColour;
use bica_motion::model::simulation::NAO;
use bica_motion::pose::Pose2;
use bica_motion::robot::Command;
use bica_player::perception::GoalDetector;
use bica_player::referee::FieldPose;
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::referee::Event;
use bica_sim::setup::{Frame, Setup, SetupError, Start};
use bica_sim::shot::{SPEEDS, Shot};
use glam::Vec2;

use crate::Keeper;

/// Size of the camera images, 160×120: enough for a ball 3 m away, and quick.
const FRAME: Frame = Frame::Small;
/// Time after a kick in which the ball may get into the goal, and in which the goalkeeper may kick it away.
pub const AFTER: Duration = Duration::from_secs(25);
/// Time from a goal to the end of the attempt.
const AFTER_GOAL: Duration = Duration::from_secs(2);
/// Middle of the own goal line, m, field frame.
const GOAL: Vec2 = Vec2::new(-3.0, 0.0);
/// Distance from there at which a ball is away, m.
const AWAY: f32 = 1.5;

/// Shots of a series, one for each seed.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// First seed.
    pub seed: u64,
    /// Number of shots.
    pub shots: u32,
    /// Speeds of the kicks, m/s.
    pub speeds: RangeInclusive<f32>,
}

impl Default for Plan {
    /// The 100 shots that count.
    fn default() -> Self {
        Self { seed: 0, shots: 100, speeds: SPEEDS }
    }
}

impl Plan {
    /// Returns the shot of a seed; `number` counts several with one seed.
    #[must_use]
    pub fn shot(&self, seed: u64, number: u32) -> Shot {
        Shot::draw(seed, number, &self.speeds)
    }

    /// Plays all shots on several threads.
    ///
    /// # Errors
    /// As [`play`].
    pub fn play(&self, robot: Robot<'_>) -> Result<Vec<ShotResult>, Failure> {
        Batch::new(self.seed, self.shots, None).run(|seed| play(robot, seed, self.shot(seed, 0)))
    }
}

/// Robot in the goal.
#[derive(Clone, Copy, Debug)]
pub enum Robot<'a> {
    /// The goalkeeper, with parameters that are not the defaults.
    Goalkeeper(&'a [Setting]),
    /// A robot that stands still.
    Idle,
}

/// Result of a shot. Without a robot in the way every shot is a goal, so a ball that is not in the goal was saved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
pub struct ShotResult {
    /// Seed of the world and of the shot.
    pub seed: u64,
    /// Whether the whole ball crossed the goal line.
    pub let_in: bool,
    /// Whether the ball was saved and is 1.5 m or more from the goal in the end.
    pub away: bool,
    /// Number of the robot's falls, dives included.
    pub falls: usize,
}

/// Pose of the robot at the start, field frame: in the middle of its goal, facing the field.
const START: Pose2 = Pose2::new(-2.95, 0.0, 0.0);

/// Makes a world with the robot in the middle of its goal and a ball that rests in front of it. The colour of the other goal is
/// drawn from the seed if it is `None`.
///
/// # Errors
/// If the world refuses the setup.
pub fn world(seed: u64, ball: Vec2, attacks: Option<GoalColour>) -> Result<KinematicWorld, Failure> {
    let start = Some(Start { robot: START, ball });
    let setup = Setup { seed, frame: FRAME, goalkeeper: false, start, attacks, ..Setup::default() };
    KinematicWorld::new(NAO, &setup).map_err(|error| refused(&error))
}

/// Makes a goalkeeper that knows where it starts.
#[must_use]
pub fn at_start() -> Box<Keeper> {
    let mut keeper = Box::new(Keeper::new());
    keeper.get_mut::<FieldPose>().place(START);
    keeper
}

/// Makes the goalkeeper of a world, with parameters that are not the defaults.
///
/// # Errors
/// If a parameter is refused.
pub fn goalkeeper(world: &KinematicWorld, settings: &[Setting]) -> Result<Box<Keeper>, Failure> {
    let mut keeper = at_start();
    keeper.get_mut::<GoalDetector>().attack(world.referee().attacks());
    keeper.set_params(settings).map_err(|refusal| Failure::new(refusal.to_string(), "choose other values of --set"))?;
    Ok(keeper)
}

/// Plays one shot from the camera images of a world.
///
/// # Errors
/// If the world refuses the shot, or the goalkeeper a parameter or an image.
pub fn play(robot: Robot<'_>, seed: u64, shot: Shot) -> Result<ShotResult, Failure> {
    let mut world = world(seed, shot.from, None)?;
    let mut attempt = Attempt::new(shot, world.now());
    match robot {
        Robot::Idle => {
            let command = stand();
            while attempt.advance(&mut world)? {
                world.act(&command);
            }
        }
        Robot::Goalkeeper(settings) => {
            let mut runner = Runner::new(goalkeeper(&world, settings)?, world);
            while attempt.advance(runner.world_mut())? {
                runner.cycle().map_err(|error| Failure::new(error.to_string(), "choose a smaller image"))?;
            }
            world = runner.into_parts().1;
        }
    }
    Ok(attempt.result(seed, &world))
}

/// Command of a robot that stands still.
fn stand() -> Command {
    Command::new(NAO.stand, 1.0)
}

fn refused(error: &SetupError) -> Failure {
    Failure::new(error.to_string(), "choose another seed")
}

/// A shot in progress.
#[derive(Clone, Copy, Debug)]
pub struct Attempt {
    shot: Shot,
    /// Time of the kick since the start of the world.
    kick: Duration,
    is_kicked: bool,
}

impl Attempt {
    /// Begins a shot; the ball rests where it begins.
    #[must_use]
    pub fn new(shot: Shot, now: Duration) -> Self {
        Self { shot, kick: now + shot.rest, is_kicked: false }
    }

    /// Kicks the ball when it is due. Returns whether the shot continues. To be called before each cycle.
    ///
    /// # Errors
    /// If the world refuses the velocity.
    pub fn advance(&mut self, world: &mut KinematicWorld) -> Result<bool, Failure> {
        if !self.is_kicked && world.now() >= self.kick {
            self.is_kicked = true;
            world.set_ball(self.shot.from, self.shot.velocity()).map_err(|error| refused(&error))?;
        }
        let end = self.goal(world).map_or(self.kick + AFTER, |goal| goal + AFTER_GOAL);
        Ok(world.now() < end)
    }

    /// Time of the goal, if the ball was let in.
    fn goal(&self, world: &KinematicWorld) -> Option<Duration> {
        let events = world.referee().events().iter();
        events.filter(|timed| timed.at >= self.kick && timed.event == Event::OwnGoal).map(|timed| timed.at).next()
    }

    /// Result of the shot so far.
    #[must_use]
    pub fn result(&self, seed: u64, world: &KinematicWorld) -> ShotResult {
        let let_in = self.goal(world).is_some();
        let away = !let_in && world.referee().ball().distance(GOAL) > AWAY;
        ShotResult { seed, let_in, away, falls: world.referee().falls() }
    }
}
