//! The place between ball and goal.

use bica::prelude::*;
use bica::visual;
use bica_motion::bounds::clamp;
use bica_motion::pose::{Pose2, rotate, wrap};
use bica_motion::walk::Velocity;
use bica_player::motion::Body;
use bica_player::perception::BallDetector;
use bica_player::referee::FieldPose;
use bica_player::shapes;
use glam::Vec2;
use libm::{atan2f, fabsf};

/// Middle of the own goal line, m, field frame.
const GOAL: Vec2 = Vec2::new(-3.0, 0.0);

/// Where the goalkeeper stands, and how it walks there.
#[derive(Clone, Debug, PartialEq, Params)]
pub struct Guarding {
    /// Distance of the place from the middle of the goal line.
    #[param(default = 0.4, range = 0.05..=1.5, unit = "m", step = 0.05)]
    pub distance: f32,
    /// Distance from the place within which the robot has arrived.
    #[param(default = 0.05, range = 0.01..=0.5, unit = "m", step = 0.01)]
    pub tolerance: f32,
    /// Turn from the direction of the ball within which the robot has arrived.
    #[param(default = 0.1, range = 0.02..=1.0, unit = "rad", step = 0.01)]
    pub turn_tolerance: f32,
    /// Factor on both tolerances beyond which the robot leaves its place.
    #[param(default = 2.5, range = 1.0..=5.0, step = 0.1)]
    pub slack: f32,
    /// Speed per distance.
    #[param(default = 1.5, range = 0.1..=5.0, unit = "1/s", step = 0.1)]
    pub gain: f32,
    /// Largest speed.
    #[param(default = 0.2, range = 0.02..=0.3, unit = "m/s", step = 0.01)]
    pub max_speed: f32,
    /// Largest turning speed.
    #[param(default = 0.8, range = 0.05..=1.5, unit = "rad/s", step = 0.05)]
    pub max_turn: f32,
}

/// Stands between the ball and the middle of the goal, and walks there if it is elsewhere. Without a ball it stands in front of the
/// middle of the goal.
#[derive(Debug)]
pub struct GuardPost {
    arrived: bool,
    /// Way to the place, in the ground frame.
    way: Pose2,
}

#[component(hz = 30, budget_us = 10)]
impl GuardPost {
    /// Creates the component away from its place.
    #[must_use]
    pub const fn new() -> Self {
        Self { arrived: false, way: Pose2::ORIGIN }
    }

    #[start]
    fn begin(&mut self) {
        *self = Self::new();
    }

    fn step(&mut self, tuned: &Tuned<Guarding>, field: &FieldPose, ball: &BallDetector, body: &mut Body) {
        let Some(here) = field.pose() else { return body.stand() };
        let to_ball = ball.position().map_or(Vec2::X, |ball| here.place(ball) - GOAL);
        let heading = atan2f(to_ball.y, to_ball.x.max(0.3));
        let place = GOAL + rotate(Vec2::X, heading) * tuned.distance;
        self.way = Pose2 { position: here.locate(place), heading: wrap(heading - here.heading) };
        let slack = if self.arrived { tuned.slack } else { 1.0 };
        self.arrived = self.way.position.length() < slack * tuned.tolerance
            && fabsf(self.way.heading) < slack * tuned.turn_tolerance;
        if self.arrived {
            return body.stand();
        }
        let limited = |value: f32, most: f32| clamp(tuned.gain * value, -most, most);
        body.step_with(Velocity {
            forward: limited(self.way.position.x, tuned.max_speed),
            left: limited(self.way.position.y, tuned.max_speed),
            turn: limited(self.way.heading, tuned.max_turn),
        });
    }

    /// Whether the robot stands at its place.
    #[output]
    #[must_use]
    pub const fn arrived(&self) -> bool {
        self.arrived
    }

    /// Way to the place, forward and left, with the turn.
    #[output(unit = "m, rad", frame = "robot")]
    fn way(&self) -> visual::Pose2 {
        shapes::pose(self.way)
    }
}
