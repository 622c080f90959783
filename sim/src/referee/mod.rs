//! Ground truth of a world, and the events on the field.

mod event;
pub(crate) mod rules;

use core::time::Duration;

use bica_field::GoalColour;
use bica_motion::fall::Direction;
use bica_motion::pose::Pose2;
use glam::Vec2;

pub use self::event::{Event, TimedEvent};

/// Whether the robot is on its feet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Posture {
    /// On its feet.
    Upright,
    /// Falling or lying.
    Down(Direction),
}

/// Who knows what is true in a world. For judging and reporting only: nothing of it may reach a player, except
/// [`attacks`](Self::attacks), which every team is told before a game.
#[derive(Clone, Debug, PartialEq)]
pub struct Referee {
    attacks: GoalColour,
    robot: Pose2,
    posture: Posture,
    ball: Vec2,
    ball_velocity: Vec2,
    others: Vec<Pose2>,
    events: Vec<TimedEvent>,
}

impl Referee {
    /// One who saw nothing happen yet. `others` are the robots that stand on the field.
    #[must_use]
    pub const fn new(attacks: GoalColour, robot: Pose2, ball: Vec2, others: Vec<Pose2>) -> Self {
        let posture = Posture::Upright;
        Self { attacks, robot, posture, ball, ball_velocity: Vec2::ZERO, others, events: Vec::new() }
    }

    /// Sees where the robot is. For worlds.
    pub const fn set_robot(&mut self, robot: Pose2, posture: Posture) {
        (self.robot, self.posture) = (robot, posture);
    }

    /// Sees where the ball is, m, and how it moves, m/s. For worlds.
    pub const fn set_ball(&mut self, ball: Vec2, velocity: Vec2) {
        (self.ball, self.ball_velocity) = (ball, velocity);
    }

    /// Notes that something happened, after all that was noted before. For worlds.
    pub fn record(&mut self, at: Duration, event: Event) {
        self.events.push(TimedEvent { at, event });
    }

    /// The colour of the goal that the robot attacks: the one at positive x.
    #[must_use]
    pub const fn attacks(&self) -> GoalColour {
        self.attacks
    }

    /// The robot's true pose in the field frame: the ground under the middle between its hips.
    /// While it lies, the heading is the one it had before.
    #[must_use]
    pub const fn robot(&self) -> Pose2 {
        self.robot
    }

    /// Whether the robot is on its feet.
    #[must_use]
    pub const fn posture(&self) -> Posture {
        self.posture
    }

    /// The ball's true position, m, field frame.
    #[must_use]
    pub const fn ball(&self) -> Vec2 {
        self.ball
    }

    /// The ball's true velocity, m/s, field frame.
    #[must_use]
    pub const fn ball_velocity(&self) -> Vec2 {
        self.ball_velocity
    }

    /// Where the other robots stand, field frame; the goalkeeper first if there is one.
    #[must_use]
    pub fn others(&self) -> &[Pose2] {
        &self.others
    }

    /// All that happened so far, oldest first.
    #[must_use]
    pub fn events(&self) -> &[TimedEvent] {
        &self.events
    }

    /// How many goals the robot's team has made.
    #[must_use]
    pub fn goals(&self) -> usize {
        self.count(|event| *event == Event::Goal)
    }

    /// How many goals were made into the robot's own goal.
    #[must_use]
    pub fn own_goals(&self) -> usize {
        self.count(|event| *event == Event::OwnGoal)
    }

    /// How often the robot fell.
    #[must_use]
    pub fn falls(&self) -> usize {
        self.count(|event| matches!(event, Event::Fall(_)))
    }

    /// How often the ball was out.
    #[must_use]
    pub fn outs(&self) -> usize {
        self.count(|event| *event == Event::BallOut)
    }

    /// How many events are such as `wanted` says.
    pub fn count(&self, wanted: impl Fn(&Event) -> bool) -> usize {
        self.events.iter().filter(|happened| wanted(&happened.event)).count()
    }
}
