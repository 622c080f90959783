//! The approach to the ball.

use bica::prelude::*;
use bica_motion::robot::CameraId;
use bica_motion::walk::Velocity;
use glam::Vec2;
use libm::fabsf;

use super::FaceBall;
use crate::motion::{Body, Head};
use crate::perception::BallDetector;

/// Head pan above which the body turns on the spot, rad (35°).
const TURN_PAN: f32 = 0.61;
/// Head pan below which a turn on the spot ends, rad.
const AHEAD_PAN: f32 = 0.25;
/// Walking speed, m/s.
const SPEED: f32 = 0.25;
/// Walking speed near the ball, m/s.
const NEAR_SPEED: f32 = 0.12;
/// Steering gain: turning speed per head pan, 1/s.
const STEERING_GAIN: f32 = 1.0;
/// Slowest turn on the spot, rad/s.
const MIN_TURN: f32 = 0.4;
/// Fastest turn on the spot, rad/s.
const MAX_TURN: f32 = 1.0;
/// Head tilt from which a ball in the bottom camera is near, rad.
const NEAR_TILT: f32 = -0.1;
/// Head tilt from which a ball in the bottom camera is reached, rad.
const REACHED_TILT: f32 = 0.28;
/// Head pan below which the ball can be reached, rad.
const REACHED_PAN: f32 = 0.6;

/// Minimum decrease of the distance within [`PROGRESS_TIME`] without which the approach counts as stalled, m.
const PROGRESS_DISTANCE: f32 = 0.1;
/// Time in which the distance must decrease, s.
const PROGRESS_TIME: f32 = 5.0;
/// Increase of the distance at which the ball is considered rolling and the approach begins anew, m.
const ROLLED_DISTANCE: f32 = 0.4;
/// Sidestepping speed, m/s.
const ASIDE_SPEED: f32 = 0.1;
/// Duration of sidestepping, s.
const ASIDE_TIME: f32 = 4.0;

/// Walks to the ball in the direction of the head, which faces the ball. A stalled approach sidesteps, alternately to
/// both sides.
#[derive(Debug)]
pub struct FollowBall {
    turning: bool,
    reached: bool,
    /// Least distance to the ball, m.
    nearest: f32,
    /// Time since the distance `nearest` was reached, s.
    stalled_time: f32,
    /// Side of the next sidestep: 1 left, −1 right.
    side: f32,
}

#[component(hz = 20, budget_us = 5)]
impl FollowBall {
    /// Creates the component with the ball not reached.
    #[must_use]
    pub const fn new() -> Self {
        Self { turning: false, reached: false, nearest: f32::INFINITY, stalled_time: 0.0, side: 1.0 }
    }

    #[start]
    fn begin(&mut self) {
        *self = Self { side: self.side, ..Self::new() };
    }

    fn step(&mut self, time: &Time, ball: &BallDetector, head: &Head, face: &mut FaceBall, body: &mut Body) {
        let pan = head.pan();
        let tilt = ball.seen().filter(|seen| seen.camera == CameraId::Bottom).map(|_| head.tilt());
        let near = tilt.is_some_and(|tilt| tilt > NEAR_TILT);
        self.reached = ball.is_confirmed()
            && tilt.is_some_and(|tilt| tilt > REACHED_TILT)
            && fabsf(pan) < REACHED_PAN
            && face.centred();
        self.turning = fabsf(pan) > if self.turning { AHEAD_PAN } else { TURN_PAN };
        if self.reached {
            body.stand();
        } else if self.is_stalled(ball.position(), time.dt()) {
            body.step_with(Velocity { forward: 0.0, left: self.side * ASIDE_SPEED, turn: STEERING_GAIN * pan });
        } else if self.turning {
            body.turn(fabsf(pan).clamp(MIN_TURN, MAX_TURN).copysign(pan));
        } else {
            body.go(if near { NEAR_SPEED } else { SPEED }, STEERING_GAIN * pan);
        }
    }

    /// Whether the approach is stalled, `seconds` after the last call.
    fn is_stalled(&mut self, ball: Option<Vec2>, seconds: f32) -> bool {
        self.stalled_time += seconds;
        let distance = ball.map_or(self.nearest, Vec2::length);
        if self.stalled_time > PROGRESS_TIME + ASIDE_TIME {
            (self.nearest, self.stalled_time, self.side) = (distance, 0.0, -self.side);
        } else if distance < self.nearest - PROGRESS_DISTANCE || distance > self.nearest + ROLLED_DISTANCE {
            (self.nearest, self.stalled_time) = (distance, 0.0);
        }
        self.stalled_time > PROGRESS_TIME
    }

    /// Whether the ball is in front of the feet: centred in the bottom camera, with the head far down and nearly
    /// straight.
    #[must_use]
    pub const fn reached(&self) -> bool {
        self.reached
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PERIOD: f32 = 0.05;

    /// Simulates runs over some seconds, with the distance to the ball as a function of time, and returns for each
    /// whether the approach is stalled.
    fn runs(follow: &mut FollowBall, seconds: f32, distance: impl Fn(f32) -> f32) -> impl Iterator<Item = bool> {
        let times = (0..(seconds / PERIOD) as u16).map(|run| f32::from(run) * PERIOD);
        times.map(move |time| follow.is_stalled(Some(Vec2::X * distance(time)), PERIOD))
    }

    #[test]
    fn approach_with_changing_distance_is_never_stalled() {
        assert!(!runs(&mut FollowBall::new(), 20.0, |time| 3.0 - 0.1 * time).any(|stalled| stalled), "nearer");
        assert!(!runs(&mut FollowBall::new(), 20.0, |time| 1.0 + 0.2 * time).any(|stalled| stalled), "rolls away");
    }

    #[test]
    fn stalled_approach_sidesteps_alternately() {
        let mut follow = FollowBall::new();
        assert!(!runs(&mut follow, PROGRESS_TIME - 0.2, |_| 1.0).any(|stalled| stalled));
        assert_eq!(runs(&mut follow, ASIDE_TIME, |_| 1.0).last(), Some(true));
        let side = follow.side;
        assert_eq!(runs(&mut follow, 1.0, |_| 1.0).last(), Some(false), "sidestepping ends");
        assert_eq!(runs(&mut follow, PROGRESS_TIME, |_| 1.0).last(), Some(true));
        assert_eq!((side, follow.side), (1.0, -1.0));
        assert!(!follow.is_stalled(Some(Vec2::X * 0.8), PERIOD), "a shorter distance ends the stall at once");
    }
}
