//! The way to the ball.

use bica::prelude::*;
use bica_motion::robot::CameraId;
use libm::fabsf;

use super::FaceBall;
use crate::motion::{Body, Head};
use crate::perception::BallDetector;

/// Head pan within which the body goes on, rad (35°); beyond it turns on the spot.
const STRAIGHT: f32 = 0.61;
/// Head pan below which a turn on the spot ends, rad.
const AHEAD: f32 = 0.25;
/// Speed to the ball and speed when it is near, m/s.
const SPEED: (f32, f32) = (0.25, 0.12);
/// How hard to steer towards the ball, 1/s.
const STEER: f32 = 1.0;
/// Slowest and fastest turn on the spot, rad/s.
const TURN: (f32, f32) = (0.4, 1.0);
/// With the bottom camera, head tilt from which the ball is near, rad.
const NEAR: f32 = -0.1;
/// With the bottom camera, head tilt from which the ball is reached, rad.
const REACHED: f32 = 0.28;
/// Head pan within which the ball counts as reached, rad.
const REACHED_PAN: f32 = 0.6;

/// Walks to the ball by the head alone: no distance is used, only where the head looks while it faces the ball.
#[derive(Debug)]
pub struct FollowBall {
    turning: bool,
    reached: bool,
}

#[component(hz = 20, budget_us = 5)]
impl FollowBall {
    /// Has not followed a ball yet.
    #[must_use]
    pub const fn new() -> Self {
        Self { turning: false, reached: false }
    }

    #[start]
    fn begin(&mut self) {
        *self = Self::new();
    }

    fn step(&mut self, ball: &BallDetector, head: &Head, face: &mut FaceBall, body: &mut Body) {
        let pan = head.pan();
        let tilt = ball.seen().filter(|seen| seen.camera == CameraId::Bottom).map(|_| head.tilt());
        let near = tilt.is_some_and(|tilt| tilt > NEAR);
        self.reached =
            ball.sure() && tilt.is_some_and(|tilt| tilt > REACHED) && fabsf(pan) < REACHED_PAN && face.centred();
        self.turning = fabsf(pan) > if self.turning { AHEAD } else { STRAIGHT };
        if self.reached {
            body.stand();
        } else if self.turning {
            body.turn(fabsf(pan).clamp(TURN.0, TURN.1).copysign(pan));
        } else {
            body.go(if near { SPEED.1 } else { SPEED.0 }, STEER * pan);
        }
    }

    /// Whether the ball lies before the feet: seen by the bottom camera, head far down and not far to a side.
    #[must_use]
    pub const fn reached(&self) -> bool {
        self.reached
    }
}
