//! Walking around the ball.

use bica::prelude::*;
use bica_motion::pose::wrap;
use bica_motion::walk::Velocity;
use libm::{atan2f, fabsf};

use crate::motion::Body;
use crate::perception::{BallDetector, Odometry};

/// Distance from the middle of the feet to the ball, m.
const RADIUS: f32 = 0.24;
/// Sideways speed, m/s.
const SPEED: f32 = 0.11;
/// Gain of the distance control, 1/s.
const DISTANCE_GAIN: f32 = 1.0;
/// Gain of the turn to the ball, 1/s.
const TURN_GAIN: f32 = 1.2;
/// Maximum remaining angle of a completed turn, rad.
const DONE: f32 = 0.1;

/// Steps sideways around the ball, facing it, until the body has turned by an angle.
#[derive(Debug)]
pub struct GoRound {
    /// Requested angle, rad.
    angle: f32,
    /// Remaining angle, rad.
    remaining: f32,
    /// Heading at the last run, rad.
    last: Option<f32>,
}

#[component(hz = 20, budget_us = 5)]
impl GoRound {
    /// Creates the component without a requested angle.
    #[must_use]
    pub const fn new() -> Self {
        Self { angle: 0.0, remaining: 0.0, last: None }
    }

    #[stop]
    fn reset(&mut self) {
        *self = Self::new();
    }

    fn step(&mut self, ball: &BallDetector, odometry: &Odometry, body: &mut Body) {
        let heading = odometry.pose().heading;
        match self.last.replace(heading) {
            None => self.remaining = self.angle,
            Some(last) => self.remaining -= wrap(heading - last),
        }
        let Some(at) = ball.position() else { return body.stand() };
        let side = 1.0_f32.copysign(self.remaining);
        let bearing = atan2f(at.y, at.x);
        body.step_with(Velocity {
            forward: DISTANCE_GAIN * (at.length() - RADIUS),
            left: -side * SPEED,
            turn: side * SPEED / RADIUS + TURN_GAIN * bearing,
        });
    }

    /// Requests a turn by `angle` rad, positive to the left, counted from the first run.
    pub const fn turn_by(&mut self, angle: f32) {
        self.angle = angle;
    }

    /// Whether the body has turned by the requested angle.
    #[must_use]
    pub fn done(&self) -> bool {
        self.last.is_some() && (fabsf(self.remaining) < DONE || self.remaining * self.angle < 0.0)
    }
}
