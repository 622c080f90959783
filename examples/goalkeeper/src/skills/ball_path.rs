//! Where the ball rolls.

use bica::prelude::*;
use bica_player::perception::BallDetector;
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

/// Where and when a rolling ball crosses the line through the robot's toes.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, postcard_schema::Schema)]
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
        self.crossing = ball.position().filter(|_| velocity.x < -tuned.min_speed).and_then(|at| {
            let (ahead, speed) = (at.x - tuned.front, velocity.length());
            let way = ahead * speed / -velocity.x;
            let left = speed * speed - 2.0 * tuned.deceleration * way;
            let aside = at.y + ahead * velocity.y / -velocity.x;
            let comes = ahead > 0.0 && left > 0.0 && aside.abs() < tuned.goal_aside;
            comes.then(|| Crossing { aside, seconds: 2.0 * way / (speed + sqrtf(left)) })
        });
    }

    /// Where and when the ball passes the robot; `None` if it does not come.
    #[info(unit = "m, s")]
    #[must_use]
    pub const fn crossing(&self) -> Option<Crossing> {
        self.crossing
    }

    /// Whether the position of the ball is known and it does not roll.
    #[info]
    #[must_use]
    pub const fn rests(&self) -> bool {
        self.rests
    }
}
