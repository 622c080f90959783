//! The ball kicked on in the walk.

use bica::prelude::*;
use bica_motion::walk::{Velocity, in_walk_kick_foot};
use libm::atan2f;

use crate::input::Measured;
use crate::motion::Body;
use crate::perception::{BallDetector, NetDetector};

/// Speed ahead, m/s.
const SPEED: f32 = 0.15;
/// How hard to bring a foot before the ball, 1/s, and to face the goal, 1/s.
const GAIN: (f32, f32) = (1.0, 0.8);
/// Fastest correction, m/s and rad/s.
const FASTEST: (f32, f32) = (0.05, 0.3);
/// A ball that far ahead rolls, or is not worth the straight way any more, m.
const AWAY: f32 = 0.7;
/// A ball less far ahead was missed, m.
const BEHIND: f32 = 0.08;

/// Walks through the ball towards the goal: brings a foot before it, and lets that foot swing through it in a step.
#[derive(Debug)]
pub struct Dribble {
    done: bool,
}

#[component(hz = 30, budget_us = 5)]
impl Dribble {
    /// Has nothing to kick.
    #[must_use]
    pub const fn new() -> Self {
        Self { done: false }
    }

    #[start]
    fn begin(&mut self) {
        *self = Self::new();
    }

    fn step(&mut self, measured: &Measured, ball: &BallDetector, net: &NetDetector, body: &mut Body) {
        let Some(at) = ball.at().filter(|at| (BEHIND..AWAY).contains(&at.x)) else {
            self.done = true;
            return;
        };
        let gait = &measured.profile().gait;
        if let Some(foot) = in_walk_kick_foot(at, gait) {
            body.kick(foot);
        }
        let aside = at.y - gait.half_spacing.copysign(at.y);
        let way = net.at().map_or(at, |goal| goal - at);
        body.step_to(Velocity {
            forward: SPEED,
            left: (GAIN.0 * aside).clamp(-FASTEST.0, FASTEST.0),
            turn: (GAIN.1 * atan2f(way.y, way.x)).clamp(-FASTEST.1, FASTEST.1),
        });
    }

    /// Whether the ball is no longer before the feet: kicked on, or missed.
    #[must_use]
    pub const fn done(&self) -> bool {
        self.done
    }
}
