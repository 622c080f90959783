//! The approach to the ball.

use bica::prelude::*;
use bica_motion::bounds::clamp;
use bica_motion::robot::CameraId;
use bica_motion::walk::Velocity;
use glam::Vec2;
use libm::fabsf;

use super::FaceBall;
use crate::motion::Head;
use crate::roles::{Ball, Legs};

/// How the robot walks to the ball.
#[derive(Clone, Debug, PartialEq, Params)]
#[params(check = Self::is_ordered)]
pub struct Approach {
    /// Walking speed.
    #[param(default = 0.25, range = 0.05..=0.4, unit = "m/s", step = 0.01)]
    pub speed: f32,
    /// Walking speed near the ball.
    #[param(default = 0.12, range = 0.02..=0.4, unit = "m/s", step = 0.01)]
    pub near_speed: f32,
    /// Head pan above which the body turns on the spot.
    #[param(default = 0.61, range = 0.1..=1.5, unit = "rad", step = 0.01)]
    pub turn_pan: f32,
    /// Head pan below which a turn on the spot ends.
    #[param(default = 0.25, range = 0.05..=1.0, unit = "rad", step = 0.01)]
    pub ahead_pan: f32,
    /// Turning speed per head pan while walking.
    #[param(default = 1.0, range = 0.1..=3.0, unit = "1/s", step = 0.05)]
    pub steering_gain: f32,
    /// Slowest turn on the spot.
    #[param(default = 0.4, range = 0.1..=1.5, unit = "rad/s", step = 0.05)]
    pub min_turn: f32,
    /// Fastest turn on the spot.
    #[param(default = 1.0, range = 0.1..=1.5, unit = "rad/s", step = 0.05)]
    pub max_turn: f32,
    /// Head tilt, down, above which a ball in the bottom camera is near.
    #[param(default = -0.1, range = -0.5..=1.3, unit = "rad", step = 0.01)]
    pub near_tilt: f32,
    /// Head tilt, down, above which a ball in the bottom camera is reached.
    #[param(default = 0.28, range = -0.3..=1.3, unit = "rad", step = 0.01)]
    pub reached_tilt: f32,
    /// Head pan below which the ball can be reached.
    #[param(default = 0.6, range = 0.1..=1.2, unit = "rad", step = 0.01)]
    pub reached_pan: f32,
}

impl Approach {
    const fn is_ordered(&self) -> Result<(), &'static str> {
        if self.ahead_pan > self.turn_pan {
            Err("`ahead_pan` must not be above `turn_pan`")
        } else if self.min_turn > self.max_turn {
            Err("`min_turn` must not be above `max_turn`")
        } else if self.near_tilt > self.reached_tilt {
            Err("`near_tilt` must not be above `reached_tilt`")
        } else {
            Ok(())
        }
    }
}

/// When an approach counts as stalled, and how the robot sidesteps then.
#[derive(Clone, Debug, PartialEq, Params)]
pub struct Stall {
    /// Decrease of the distance within `progress_time` without which the approach counts as stalled.
    #[param(default = 0.1, range = 0.02..=0.5, unit = "m", step = 0.01)]
    pub progress_distance: f32,
    /// Time in which the distance must decrease.
    #[param(default = 5.0, range = 1.0..=20.0, unit = "s", step = 0.5)]
    pub progress_time: f32,
    /// Increase of the distance at which the ball counts as rolling and the approach begins anew.
    #[param(default = 0.4, range = 0.1..=2.0, unit = "m", step = 0.05)]
    pub rolled_distance: f32,
    /// Sidestepping speed.
    #[param(default = 0.1, range = 0.02..=0.2, unit = "m/s", step = 0.01)]
    pub aside_speed: f32,
    /// Duration of sidestepping.
    #[param(default = 4.0, range = 0.5..=10.0, unit = "s", step = 0.5)]
    pub aside_time: f32,
}

/// Walks to the ball in the direction of the head, which faces the ball; stands while the ball is neither seen nor remembered. A
/// stalled approach sidesteps, alternately to both sides.
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

    fn step(
        &mut self,
        tuned: &Tuned<Approach>,
        stall: &Tuned<Stall>,
        time: &Time,
        ball: &impl Ball,
        head: &Head,
        face: &mut FaceBall,
        body: &mut impl Legs,
    ) {
        let pan = head.pan();
        let tilt = ball.camera().filter(|camera| *camera == CameraId::Bottom).map(|_| head.tilt());
        let near = tilt.is_some_and(|tilt| tilt > tuned.near_tilt);
        self.reached = ball.is_confirmed()
            && tilt.is_some_and(|tilt| tilt > tuned.reached_tilt)
            && fabsf(pan) < tuned.reached_pan
            && face.centred();
        self.turning = fabsf(pan) > if self.turning { tuned.ahead_pan } else { tuned.turn_pan };
        if self.reached || ball.bearing().is_none() {
            body.stand();
        } else if self.is_stalled(stall, ball.position(), time.dt()) {
            let left = self.side * stall.aside_speed;
            body.step_with(Velocity { forward: 0.0, left, turn: tuned.steering_gain * pan });
        } else if self.turning {
            body.turn(clamp(fabsf(pan), tuned.min_turn, tuned.max_turn).copysign(pan));
        } else {
            body.go(if near { tuned.near_speed } else { tuned.speed }, tuned.steering_gain * pan);
        }
    }

    /// Whether the approach is stalled, `seconds` after the last call.
    fn is_stalled(&mut self, stall: &Stall, ball: Option<Vec2>, seconds: f32) -> bool {
        self.stalled_time += seconds;
        let distance = ball.map_or(self.nearest, Vec2::length);
        if self.stalled_time > stall.progress_time + stall.aside_time {
            (self.nearest, self.stalled_time, self.side) = (distance, 0.0, -self.side);
        } else if distance < self.nearest - stall.progress_distance || distance > self.nearest + stall.rolled_distance {
            (self.nearest, self.stalled_time) = (distance, 0.0);
        }
        self.stalled_time > stall.progress_time
    }

    /// Whether the ball is in front of the feet: centred in the bottom camera, with the head far down and nearly straight.
    #[output]
    #[must_use]
    pub const fn reached(&self) -> bool {
        self.reached
    }

    /// Whether the direction of the ball asks for a turn on the spot.
    #[output]
    #[must_use]
    pub const fn is_turning(&self) -> bool {
        self.turning
    }

    /// Least distance to the ball since the approach began or the ball rolled away; `None` while it is unknown.
    #[output(unit = "m")]
    #[must_use]
    pub fn nearest(&self) -> Option<f32> {
        self.nearest.is_finite().then_some(self.nearest)
    }

    /// Time without progress: without a decrease of the least distance by `progress_distance`. The robot sidesteps while it
    /// is above `progress_time`.
    #[output(unit = "s")]
    #[must_use]
    pub const fn stalled_time(&self) -> f32 {
        self.stalled_time
    }
}

#[cfg(test)]
mod tests {
    use super::super::time;
    use super::*;
    use crate::motion::Body;
    use crate::motion::Request;
    use crate::perception::BallDetector;

    const PERIOD: f32 = 0.05;
    /// Different from the defaults.
    const STALL: Stall = Stall { progress_time: 3.0, aside_time: 2.0, ..Stall::DEFAULT };

    /// Simulates runs over some seconds, with the distance to the ball as a function of time, and returns for each
    /// whether the approach is stalled.
    fn runs(follow: &mut FollowBall, seconds: f32, distance: impl Fn(f32) -> f32) -> impl Iterator<Item = bool> {
        let times = (0..(seconds / PERIOD) as u16).map(|run| f32::from(run) * PERIOD);
        times.map(move |time| follow.is_stalled(&STALL, Some(Vec2::X * distance(time)), PERIOD))
    }

    #[test]
    fn approach_with_changing_distance_is_never_stalled() {
        assert!(!runs(&mut FollowBall::new(), 20.0, |time| 3.0 - 0.1 * time).any(|stalled| stalled), "nearer");
        assert!(!runs(&mut FollowBall::new(), 20.0, |time| 1.0 + 0.2 * time).any(|stalled| stalled), "rolls away");
    }

    #[test]
    fn stalled_approach_sidesteps_alternately() {
        let mut follow = FollowBall::new();
        assert!(!runs(&mut follow, STALL.progress_time - 0.2, |_| 1.0).any(|stalled| stalled));
        assert_eq!(runs(&mut follow, STALL.aside_time, |_| 1.0).last(), Some(true));
        let side = follow.side;
        assert_eq!(runs(&mut follow, 1.0, |_| 1.0).last(), Some(false), "sidestepping ends");
        assert_eq!(runs(&mut follow, STALL.progress_time, |_| 1.0).last(), Some(true));
        assert_eq!((side, follow.side), (1.0, -1.0));
        assert!(!follow.is_stalled(&STALL, Some(Vec2::X * 0.8), PERIOD), "a shorter distance ends the stall at once");
    }

    #[test]
    fn robot_walks_and_sidesteps_to_a_known_ball_only() {
        let tuned = Tuned::new(Approach { speed: 0.17, ..Approach::DEFAULT });
        let stall = Tuned::new(Stall { progress_time: 1.0, aside_speed: 0.06, ..Stall::DEFAULT });
        let (mut follow, mut ball, head) = (FollowBall::new(), BallDetector::remembering(Vec2::X), Head::new());
        let (mut face, mut body) = (FaceBall::new(), Body::new());
        follow.step(&tuned, &stall, &time(500), &ball, &head, &mut face, &mut body);
        assert_eq!(body.request(), Request::Straight { forward: 0.17, turn: 0.0 });
        for _ in 0..2 {
            follow.step(&tuned, &stall, &time(600), &ball, &head, &mut face, &mut body);
        }
        assert_eq!(body.request(), Request::Step(Velocity { forward: 0.0, left: 0.06, turn: 0.0 }));
        (0..60).for_each(|_| ball.pass_cycle());
        follow.step(&tuned, &stall, &time(700), &ball, &head, &mut face, &mut body);
        assert_eq!(body.request(), Request::Stand, "the position is old");
    }

    #[test]
    fn limits_in_wrong_order_are_refused() {
        assert!(Approach::DEFAULT.check().is_ok());
        for wrong in [
            Approach { ahead_pan: 0.62, ..Approach::DEFAULT },
            Approach { min_turn: 1.1, ..Approach::DEFAULT },
            Approach { near_tilt: 0.3, ..Approach::DEFAULT },
        ] {
            assert!(wrong.check().is_err(), "{wrong:?}");
        }
    }
}
