//! Ground truth of a world, and the events on the field.

mod event;
pub(crate) mod rules;
mod verdict;

use core::time::Duration;

pub use bica_body::Posture;
use bica_field::GoalColour;
use bica_motion::pose::Pose2;
use glam::Vec2;

pub use self::event::{Event, TimedEvent};

/// Ground truth of a world and the list of events, for evaluation only.
///
/// The robot's program must not read it, except for [`attacks`](Self::attacks), which teams know before a game.
#[derive(Clone, Debug, PartialEq)]
pub struct Referee {
    attacks: GoalColour,
    start: Pose2,
    robot: Pose2,
    posture: Posture,
    ball: Vec2,
    ball_velocity: Vec2,
    others: Vec<Pose2>,
    events: Vec<TimedEvent>,
}

impl Referee {
    /// Returns a referee without events. `others` are the robots that stand on the field.
    #[must_use]
    pub const fn new(attacks: GoalColour, robot: Pose2, ball: Vec2, others: Vec<Pose2>) -> Self {
        let posture = Posture::Upright;
        Self { attacks, start: robot, robot, posture, ball, ball_velocity: Vec2::ZERO, others, events: Vec::new() }
    }

    /// Sets the robot's true pose and posture. For implementations of worlds.
    pub const fn set_robot(&mut self, robot: Pose2, posture: Posture) {
        (self.robot, self.posture) = (robot, posture);
    }

    /// Sets the ball's true position, m, and velocity, m/s. For implementations of worlds.
    pub const fn set_ball(&mut self, ball: Vec2, velocity: Vec2) {
        (self.ball, self.ball_velocity) = (ball, velocity);
    }

    /// Sets the true poses of the other robots. For worlds in which they move.
    pub fn set_others(&mut self, others: impl Iterator<Item = Pose2>) {
        self.others.clear();
        self.others.extend(others);
    }

    /// Appends an event; times must not decrease. For implementations of worlds.
    pub fn record(&mut self, at: Duration, event: Event) {
        self.events.push(TimedEvent { at, event });
    }

    /// Colour of the attacked goal, the one at positive x.
    #[must_use]
    pub const fn attacks(&self) -> GoalColour {
        self.attacks
    }

    /// True pose of the robot at the start.
    #[must_use]
    pub const fn start(&self) -> Pose2 {
        self.start
    }

    /// True pose of the robot frame, projected to the ground, in the field frame.
    ///
    /// While the robot lies, the heading is the one before the fall.
    #[must_use]
    pub const fn robot(&self) -> Pose2 {
        self.robot
    }

    /// Returns whether the robot stands or has fallen.
    #[must_use]
    pub const fn posture(&self) -> Posture {
        self.posture
    }

    /// True position of the ball, m, field frame.
    #[must_use]
    pub const fn ball(&self) -> Vec2 {
        self.ball
    }

    /// True velocity of the ball, m/s, field frame.
    #[must_use]
    pub const fn ball_velocity(&self) -> Vec2 {
        self.ball_velocity
    }

    /// True poses of the other robots, field frame; the goalkeeper first if there is one.
    #[must_use]
    pub fn others(&self) -> &[Pose2] {
        &self.others
    }

    /// All events so far, oldest first.
    #[must_use]
    pub fn events(&self) -> &[TimedEvent] {
        &self.events
    }

    /// Number of goals scored by the robot's team.
    #[must_use]
    pub fn goals(&self) -> usize {
        self.count(|event| *event == Event::Goal)
    }

    /// Number of own goals.
    #[must_use]
    pub fn own_goals(&self) -> usize {
        self.count(|event| *event == Event::OwnGoal)
    }

    /// Number of the robot's falls.
    #[must_use]
    pub fn falls(&self) -> usize {
        self.count(|event| matches!(event, Event::Fall(_)))
    }

    /// Number of times that the ball left the field beside the goals.
    #[must_use]
    pub fn outs(&self) -> usize {
        self.count(|event| *event == Event::BallOut)
    }

    /// Number of events for which `matches` returns true.
    pub fn count(&self, matches: impl Fn(&Event) -> bool) -> usize {
        self.events.iter().filter(|timed| matches(&timed.event)).count()
    }
}
