//! The way around the ball.

use bica::prelude::*;
use bica_motion::pose::wrap;
use bica_motion::walk::Velocity;
use libm::{atan2f, fabsf};

use crate::motion::Body;
use crate::perception::{BallDetector, Odometry};

/// Distance from the middle of the feet to the ball while going round, m.
const RADIUS: f32 = 0.24;
/// Sideways speed, m/s.
const SPEED: f32 = 0.11;
/// How hard to keep the distance, 1/s.
const KEEP: f32 = 1.0;
/// How hard to keep facing the ball, 1/s.
const FACE: f32 = 1.2;

/// Steps sideways around the ball, facing it, until the body has turned by an angle.
#[derive(Debug)]
pub struct GoRound {
    angle: f32,
    to_go: f32,
    last: Option<f32>,
}

#[component(hz = 20, budget_us = 5)]
impl GoRound {
    /// Goes nowhere yet.
    #[must_use]
    pub const fn new() -> Self {
        Self { angle: 0.0, to_go: 0.0, last: None }
    }

    #[stop]
    fn end(&mut self) {
        *self = Self::new();
    }

    fn step(&mut self, ball: &BallDetector, odometry: &Odometry, body: &mut Body) {
        let heading = odometry.pose().heading;
        match self.last.replace(heading) {
            None => self.to_go = self.angle,
            Some(last) => self.to_go -= wrap(heading - last),
        }
        let Some(at) = ball.at() else { return body.stand() };
        let side = 1.0_f32.copysign(self.to_go);
        let bearing = atan2f(at.y, at.x);
        body.step_to(Velocity {
            forward: KEEP * (at.length() - RADIUS),
            left: -side * SPEED,
            turn: side * SPEED / RADIUS + FACE * bearing,
        });
    }

    /// Asks for a turn by `angle` rad, positive to the left. Counts from the first run on.
    pub const fn by(&mut self, angle: f32) {
        self.angle = angle;
    }

    /// Whether the body has turned as far as asked.
    #[must_use]
    pub fn done(&self) -> bool {
        self.last.is_some() && (fabsf(self.to_go) < 0.1 || self.to_go * self.angle < 0.0)
    }
}
