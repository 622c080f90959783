//! Kicks in walking.

use bica::prelude::*;
use bica_motion::walk::{Velocity, in_walk_kick_foot};
use libm::atan2f;

use crate::input::RobotProfile;
use crate::motion::Body;
use crate::perception::{BallDetector, GoalDetector};

/// Forward speed, m/s.
const SPEED: f32 = 0.15;
/// Gain of the lateral alignment of a foot with the ball, 1/s.
const ASIDE_GAIN: f32 = 1.0;
/// Gain of the turn to the goal, 1/s.
const TURN_GAIN: f32 = 0.8;
/// Largest sideways speed, m/s.
const MAX_ASIDE: f32 = 0.05;
/// Largest turning speed, rad/s.
const MAX_TURN: f32 = 0.3;
/// Forward distance from which the ball is out of reach, m.
const FAR: f32 = 0.7;
/// Forward distance below which the ball was missed, m.
const MISSED: f32 = 0.08;

/// Walks through the ball towards the goal: aligns a foot with the ball, which swings through it in a step.
#[derive(Debug)]
pub struct Dribble {
    done: bool,
}

#[component(hz = 30, budget_us = 5)]
impl Dribble {
    /// Creates the component with no kick done.
    #[must_use]
    pub const fn new() -> Self {
        Self { done: false }
    }

    #[start]
    fn begin(&mut self) {
        *self = Self::new();
    }

    fn step(&mut self, profile: &RobotProfile, ball: &BallDetector, goal: &GoalDetector, body: &mut Body) {
        let Some(at) = ball.position().filter(|at| (MISSED..FAR).contains(&at.x)) else {
            self.done = true;
            return;
        };
        let gait = &profile.get().gait;
        if let Some(foot) = in_walk_kick_foot(at, gait) {
            body.kick(foot);
        }
        let aside = at.y - gait.half_spacing.copysign(at.y);
        let to_goal = goal.position().map_or(at, |goal| goal - at);
        body.step_with(Velocity {
            forward: SPEED,
            left: (ASIDE_GAIN * aside).clamp(-MAX_ASIDE, MAX_ASIDE),
            turn: (TURN_GAIN * atan2f(to_goal.y, to_goal.x)).clamp(-MAX_TURN, MAX_TURN),
        });
    }

    /// Whether the ball is no longer in front of the feet: kicked, or missed.
    #[must_use]
    pub const fn done(&self) -> bool {
        self.done
    }
}
