//! The way to the ball.

use bica::prelude::*;
use bica_motion::robot::CameraId;
use bica_motion::walk::Velocity;
use glam::Vec2;
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

/// The ball comes nearer by this, m, in this time, s, or something is in the way.
const PROGRESS: (f32, f32) = (0.1, 5.0);
/// A ball that is farther away than before by this, m, rolls: the way to it begins anew.
const ROLLS: f32 = 0.4;
/// How fast and how long to step aside then, m/s and s.
const ASIDE: (f32, f32) = (0.1, 4.0);

/// Walks to the ball by the head alone: where the head looks while it faces the ball is the way. If the ball comes no
/// nearer, something is in the way, and it steps aside, to the one side and then to the other.
#[derive(Debug)]
pub struct FollowBall {
    turning: bool,
    reached: bool,
    /// The least distance to the ball, m, and the time since, s.
    nearest: f32,
    in_vain: f32,
    /// Where to step aside: 1 to the left, −1 to the right.
    side: f32,
}

#[component(hz = 20, budget_us = 5)]
impl FollowBall {
    /// Has not followed a ball yet.
    #[must_use]
    pub const fn new() -> Self {
        Self { turning: false, reached: false, nearest: f32::INFINITY, in_vain: 0.0, side: 1.0 }
    }

    #[start]
    fn begin(&mut self) {
        *self = Self { side: self.side, ..Self::new() };
    }

    fn step(&mut self, time: &Time, ball: &BallDetector, head: &Head, face: &mut FaceBall, body: &mut Body) {
        let pan = head.pan();
        let tilt = ball.seen().filter(|seen| seen.camera == CameraId::Bottom).map(|_| head.tilt());
        let near = tilt.is_some_and(|tilt| tilt > NEAR);
        self.reached =
            ball.sure() && tilt.is_some_and(|tilt| tilt > REACHED) && fabsf(pan) < REACHED_PAN && face.centred();
        self.turning = fabsf(pan) > if self.turning { AHEAD } else { STRAIGHT };
        if self.reached {
            body.stand();
        } else if self.is_blocked(ball.at(), time.dt()) {
            body.step_to(Velocity { forward: 0.0, left: self.side * ASIDE.0, turn: STEER * pan });
        } else if self.turning {
            body.turn(fabsf(pan).clamp(TURN.0, TURN.1).copysign(pan));
        } else {
            body.go(if near { SPEED.1 } else { SPEED.0 }, STEER * pan);
        }
    }

    /// Whether it has come no nearer to the ball for long.
    fn is_blocked(&mut self, ball: Option<Vec2>, seconds: f32) -> bool {
        self.in_vain += seconds;
        let distance = ball.map_or(self.nearest, Vec2::length);
        if self.in_vain > PROGRESS.1 + ASIDE.1 {
            (self.nearest, self.in_vain, self.side) = (distance, 0.0, -self.side);
        } else if distance < self.nearest - PROGRESS.0 || distance > self.nearest + ROLLS {
            (self.nearest, self.in_vain) = (distance, 0.0);
        }
        self.in_vain > PROGRESS.1
    }

    /// Whether the ball lies before the feet: seen by the bottom camera, head far down and not far to a side.
    #[must_use]
    pub const fn reached(&self) -> bool {
        self.reached
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PERIOD: f32 = 0.05;

    /// In which runs of so many seconds it is blocked, if the ball is as far away as this says.
    fn runs(follow: &mut FollowBall, seconds: f32, distance: impl Fn(f32) -> f32) -> impl Iterator<Item = bool> {
        let times = (0..(seconds / PERIOD) as u16).map(|run| f32::from(run) * PERIOD);
        times.map(move |time| follow.is_blocked(Some(Vec2::X * distance(time)), PERIOD))
    }

    #[test]
    fn who_comes_nearer_is_not_blocked() {
        assert!(!runs(&mut FollowBall::new(), 20.0, |time| 3.0 - 0.1 * time).any(|blocked| blocked));
        assert!(!runs(&mut FollowBall::new(), 20.0, |time| 1.0 + 0.2 * time).any(|blocked| blocked), "it rolls away");
    }

    #[test]
    fn who_comes_no_nearer_steps_to_one_side_and_then_to_the_other() {
        let mut follow = FollowBall::new();
        assert!(!runs(&mut follow, PROGRESS.1 - 0.2, |_| 1.0).any(|blocked| blocked));
        assert_eq!(runs(&mut follow, ASIDE.1, |_| 1.0).last(), Some(true));
        let before = follow.side;
        assert_eq!(runs(&mut follow, 1.0, |_| 1.0).last(), Some(false), "stepping aside ends");
        assert_eq!(runs(&mut follow, PROGRESS.1, |_| 1.0).last(), Some(true));
        assert!(follow.side * before < 0.0);
        follow.is_blocked(Some(Vec2::X * 0.8), PERIOD);
        assert!(!follow.is_blocked(Some(Vec2::X * 0.8), PERIOD), "the way is free");
    }
}
