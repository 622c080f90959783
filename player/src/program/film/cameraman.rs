//! Where the film is taken from.

use bica_sim::{Onlooker, Referee};
use glam::Vec3;

/// How long the cameraman takes to follow, s.
const LAZINESS: f32 = 0.8;
/// The way from what is filmed to the camera; its length does not matter.
const ASIDE: Vec3 = Vec3::new(-0.55, -1.0, 0.5);
/// How far the camera is away, m: at least, at most, and for each metre between robot and ball.
const DISTANCE: (f32, f32, f32) = (1.2, 2.6, 0.9);
/// The hall's walls are beyond this, m.
const HALL: Vec3 = Vec3::new(5.7, 4.7, 3.2);

/// Follows robot and ball.
pub(crate) struct Cameraman {
    /// What is filmed, and from how far.
    now: Option<(Vec3, f32)>,
}

impl Cameraman {
    /// Has seen nothing yet.
    pub(crate) const fn new() -> Self {
        Self { now: None }
    }

    /// Where to film from, `dt` seconds after the last time.
    pub(crate) fn follow(&mut self, referee: &Referee, dt: f32) -> Onlooker {
        let (robot, ball) = (referee.robot().position, referee.ball());
        let apart = robot.distance(ball);
        let middle = robot.lerp(ball, 0.35).extend(0.22);
        let distance = (DISTANCE.0 + DISTANCE.2 * (apart - 0.4).max(0.0)).clamp(DISTANCE.0, DISTANCE.1);
        let (target, away) = match self.now {
            None => (middle, distance),
            Some((target, away)) => {
                let share = (dt / LAZINESS).min(1.0);
                (target.lerp(middle, share), away + share * (distance - away))
            }
        };
        self.now = Some((target, away));
        let eye = (target + away * ASIDE.normalize()).clamp(-HALL, HALL);
        Onlooker { eye, target }
    }
}
