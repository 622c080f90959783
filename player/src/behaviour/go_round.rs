//! Walking around the ball.

use crate::roles::{Ball, Legs, Odometer};
use bica::prelude::*;
use bica_motion::pose::wrap;
use bica_motion::walk::Velocity;
use glam::Vec2;
use libm::{atan2f, fabsf};

/// How the robot walks around the ball.
#[derive(Clone, Debug, PartialEq, Params)]
pub struct Circling {
    /// Distance from the middle of the feet to the ball. `Player.way_round_radius`, the radius of the path that is
    /// tested for obstacles, should equal it.
    #[param(default = 0.24, range = 0.15..=1.0, unit = "m", step = 0.01)]
    pub radius: f32,
    /// Sideways speed.
    #[param(default = 0.11, range = 0.02..=0.2, unit = "m/s", step = 0.01)]
    pub speed: f32,
    /// Forward speed per distance error.
    #[param(default = 1.0, range = 0.1..=3.0, unit = "1/s", step = 0.05)]
    pub distance_gain: f32,
    /// Turning speed per bearing of the ball.
    #[param(default = 1.2, range = 0.1..=3.0, unit = "1/s", step = 0.05)]
    pub turn_gain: f32,
    /// Remaining angle below which the turn is complete.
    #[param(default = 0.1, range = 0.02..=0.5, unit = "rad", step = 0.01)]
    pub angle_tolerance: f32,
}

impl Circling {
    /// Velocity with the ball at a position, m, in the ground frame, and an angle that remains, rad.
    fn velocity(&self, ball: Vec2, remaining: f32) -> Velocity {
        let side = 1.0_f32.copysign(remaining);
        let bearing = atan2f(ball.y, ball.x);
        Velocity {
            forward: self.distance_gain * (ball.length() - self.radius),
            left: -side * self.speed,
            turn: side * self.speed / self.radius + self.turn_gain * bearing,
        }
    }
}

/// Steps sideways around the ball, facing it, until the body has turned by an angle.
#[derive(Debug)]
pub struct GoRound {
    /// Requested angle, rad.
    angle: f32,
    /// Remaining angle, rad.
    remaining: f32,
    /// Heading at the last run, rad.
    last: Option<f32>,
    done: bool,
}

#[component(hz = 20, budget_us = 5)]
impl GoRound {
    /// Creates the component without a requested angle.
    #[must_use]
    pub const fn new() -> Self {
        Self { angle: 0.0, remaining: 0.0, last: None, done: false }
    }

    #[stop]
    fn reset(&mut self) {
        *self = Self::new();
    }

    fn step(&mut self, tuned: &Tuned<Circling>, ball: &impl Ball, odometry: &impl Odometer, body: &mut impl Legs) {
        let heading = odometry.pose().heading;
        match self.last.replace(heading) {
            None => self.remaining = self.angle,
            Some(last) => self.remaining -= wrap(heading - last),
        }
        self.done = fabsf(self.remaining) < tuned.angle_tolerance || self.remaining * self.angle < 0.0;
        let Some(at) = ball.position() else { return body.stand() };
        body.step_with(tuned.velocity(at, self.remaining));
    }

    /// Requests a turn by `angle` rad, positive to the left, counted from the first run.
    pub const fn turn_by(&mut self, angle: f32) {
        self.angle = angle;
    }

    /// The requested angle, positive to the left.
    #[output(unit = "rad")]
    #[must_use]
    pub const fn angle(&self) -> f32 {
        self.angle
    }

    /// The part of the angle that remains, positive to the left.
    #[output(unit = "rad")]
    #[must_use]
    pub const fn remaining(&self) -> f32 {
        self.remaining
    }

    /// Whether the body has turned by the requested angle.
    #[output]
    #[must_use]
    pub const fn done(&self) -> bool {
        self.done
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::Body;
    use crate::perception::BallDetector;
    use crate::perception::Odometry;

    #[test]
    fn turn_is_done_within_tuned_tolerance() {
        for (angle_tolerance, done) in [(0.1, false), (0.2, true)] {
            let tuned = Tuned::new(Circling { angle_tolerance, ..Circling::DEFAULT });
            let mut round = GoRound::new();
            round.turn_by(0.15);
            assert!(!round.done(), "before the first run");
            round.step(&tuned, &BallDetector::new(), &Odometry::new(), &mut Body::new());
            assert_eq!(round.done(), done, "{angle_tolerance}");
        }
    }

    #[test]
    fn robot_keeps_tuned_radius_and_speed() {
        let tuned = Circling { radius: 0.3, speed: 0.06, ..Circling::DEFAULT };
        let at_radius = tuned.velocity(Vec2::new(0.3, 0.0), 1.0);
        assert!(fabsf(at_radius.forward) < 1e-6 && fabsf(at_radius.turn - 0.2) < 1e-6, "{at_radius:?}");
        assert_eq!(at_radius.left.to_bits(), (-0.06_f32).to_bits());
        assert!(tuned.velocity(Vec2::new(0.24, 0.0), 1.0).forward < 0.0, "too near");
    }
}
