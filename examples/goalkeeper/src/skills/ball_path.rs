//! Where the ball rolls.

use bica::prelude::*;
use bica_player::perception::BallDetector;
use glam::Vec2;
use libm::sqrtf;

/// Which balls count as shots.
#[derive(Clone, Debug, PartialEq, Params)]
pub struct Shooting {
    /// Distance in front of the robot's middle at which the feet stop a ball.
    #[param(default = 0.08, range = 0.0..=0.3, unit = "m", step = 0.01)]
    pub front: f32,
    /// Least speed towards the robot.
    #[param(default = 0.25, range = 0.05..=2.0, unit = "m/s", step = 0.05)]
    pub min_speed: f32,
    /// Deceleration of the rolling ball; low, so that a slow ball still counts.
    #[param(default = 0.3, range = 0.0..=2.0, unit = "m/s²", step = 0.05)]
    pub deceleration: f32,
    /// Distance to the side beyond which a ball misses the goal.
    #[param(default = 1.0, range = 0.2..=2.0, unit = "m", step = 0.05)]
    pub goal_aside: f32,
}

impl Shooting {
    /// Crossing of a ball at a position, m, with a velocity, m/s, in the ground frame; `None` if it does not come.
    fn crossing(&self, at: Vec2, velocity: Vec2) -> Option<Crossing> {
        if velocity.x > -self.min_speed {
            return None;
        }
        let (ahead, speed) = (at.x - self.front, velocity.length());
        let way = ahead * speed / -velocity.x;
        let left = speed * speed - 2.0 * self.deceleration * way;
        let aside = at.y + ahead * velocity.y / -velocity.x;
        let comes = ahead > 0.0 && left > 0.0 && aside.abs() < self.goal_aside;
        comes.then(|| Crossing { aside, seconds: 2.0 * way / (speed + sqrtf(left)) })
    }
}

/// Where and when a rolling ball crosses the line through the robot's toes.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Distance to the left of the robot, m.
    pub aside: f32,
    /// Time until then, s.
    pub seconds: f32,
}

/// Where the ball will pass the robot, if it rolls towards it.
#[derive(Debug)]
pub struct BallPath {
    crossing: Option<Crossing>,
    rests: bool,
}

#[component(hz = 50, budget_us = 5)]
impl BallPath {
    /// Creates the component without a ball.
    #[must_use]
    pub const fn new() -> Self {
        Self { crossing: None, rests: false }
    }

    fn step(&mut self, tuned: &Tuned<Shooting>, ball: &BallDetector) {
        let velocity = ball.memory().velocity();
        self.rests = ball.position().is_some() && velocity.length() < tuned.min_speed;
        self.crossing = ball.position().and_then(|at| tuned.crossing(at, velocity));
    }

    /// Where and when the ball passes the robot; `None` if it does not come.
    #[output(unit = "m, s")]
    #[must_use]
    pub const fn crossing(&self) -> Option<Crossing> {
        self.crossing
    }

    /// Whether the position of the ball is known and it does not roll.
    #[output]
    #[must_use]
    pub const fn rests(&self) -> bool {
        self.rests
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ball_without_friction_crosses_on_straight_line() {
        let tuned = Shooting { front: 0.1, deceleration: 0.0, ..Shooting::DEFAULT };
        let crossing = tuned.crossing(Vec2::new(2.1, 0.5), Vec2::new(-1.0, -0.1)).expect("it comes");
        assert!((crossing.aside - 0.3).abs() < 1e-5 && (crossing.seconds - 2.0).abs() < 1e-2, "{crossing:?}");
    }

    #[test]
    fn deceleration_delays_the_crossing_only() {
        // From 2 m/s with 0.5 m/s² it takes 2 s for 3 m: 2 t - 0.25 t².
        let tuned = Shooting { front: 0.0, deceleration: 0.5, ..Shooting::DEFAULT };
        let crossing = tuned.crossing(Vec2::new(3.0, -0.2), Vec2::new(-2.0, 0.0)).expect("it comes");
        assert!((crossing.aside + 0.2).abs() < 1e-6 && (crossing.seconds - 2.0).abs() < 1e-5, "{crossing:?}");
    }

    #[test]
    fn only_an_approaching_ball_crosses() {
        let tuned = Shooting { deceleration: 0.5, goal_aside: 0.8, ..Shooting::DEFAULT };
        for (at, velocity) in [
            (Vec2::new(3.0, 0.0), Vec2::new(-1.0, 0.0)),
            (Vec2::new(1.0, 0.0), Vec2::new(-1.5, 1.5)),
            (Vec2::new(1.0, 0.0), Vec2::new(1.5, 0.0)),
            (Vec2::new(0.05, 0.1), Vec2::new(-1.5, 0.0)),
            (Vec2::new(1.0, 0.0), Vec2::new(-0.1, 0.0)),
        ] {
            assert_eq!(tuned.crossing(at, velocity), None, "{at} {velocity}");
        }
    }
}
