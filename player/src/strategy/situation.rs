//! What is known at the ball.

use core::f32::consts::TAU;

use bica_field::FIELD;
use bica_motion::pose::rotate;
use glam::Vec2;
use libm::{ceilf, fabsf};

use super::obstacles::{Obstacle, Obstacles};
use crate::perception::{BallDetector, Localization, NetDetector, RobotDetector};

/// A robot's radius, m: half of what it measures from arm to arm, less what arms give way.
const ROBOT: f32 = 0.12;
/// A robot's place is that of its toes; its middle is this much farther away, m.
const TOES: f32 = 0.08;
/// How far from the ball the way round it goes, m, and the steps in which it is looked at, rad.
const ROUND: (f32, f32) = (0.24, 0.3);

/// Where ball, goal and what is in the way are: m, in the frame on the ground between the feet.
#[derive(Clone, Debug, PartialEq)]
pub struct Situation {
    pub(super) ball: Vec2,
    pub(super) goal: Option<Goal>,
    pub(super) obstacles: Obstacles,
}

/// The goal to score in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Goal {
    pub(super) middle: Vec2,
    /// From the right post to the left one, length 1.
    pub(super) across: Vec2,
    /// The middle of what the keeper leaves free, m to the left of the goal's middle.
    pub(super) gap: Option<f32>,
}

impl Situation {
    /// What is remembered; none if nobody knows where the ball is. A goal that was not seen whole is where the place on the field
    /// says.
    #[must_use]
    #[inline(never)]
    pub fn of(ball: &BallDetector, net: &NetDetector, field: &Localization, robots: &RobotDetector) -> Option<Self> {
        let goal = Goal::of(net, field);
        let mut obstacles = Obstacles::default();
        let half = |goal: Goal| 0.5 * FIELD.goal_width() * goal.across;
        let posts = goal.into_iter().flat_map(|goal| [goal.middle + half(goal), goal.middle - half(goal)]);
        let posts = posts.map(|at| Obstacle { at, radius: FIELD.post_radius() });
        let robots = robots.places().map(|place| place.position);
        let robots = robots.map(|toes| Obstacle { at: toes + TOES * toes.normalize_or_zero(), radius: ROBOT });
        obstacles.0.extend(posts.chain(robots));
        Some(Self { ball: ball.at()?, goal, obstacles })
    }

    /// The same with nothing in the way.
    pub(super) fn alone(&self) -> Self {
        Self { obstacles: Obstacles::default(), ..*self }
    }

    /// By how much to turn on the way round the ball so that the body has turned by `turn` at its end, rad: the shorter way if
    /// nothing is in it, else the longer one; none if both are blocked.
    pub(super) fn way_round(&self, turn: f32) -> Option<f32> {
        let other = turn - TAU.copysign(turn);
        [turn, other].into_iter().find(|&way| self.is_free(way))
    }

    fn is_free(&self, turn: f32) -> bool {
        let from = -ROUND.0 * self.ball.normalize_or_zero();
        let steps = ceilf(fabsf(turn) / ROUND.1) as u8;
        (1..=steps).all(|step| {
            let turned = rotate(from, turn * f32::from(step) / f32::from(steps));
            self.obstacles.lets_stand(self.ball + turned)
        })
    }
}

impl Goal {
    fn of(net: &NetDetector, field: &Localization) -> Option<Self> {
        let by_place = || field.posts().map(|[left, right]| (left.midpoint(right), (left - right).normalize_or_zero()));
        let seen = net.at().map(|at| (at, net.across()));
        let (middle, across) = if net.whole() { seen } else { by_place().or(seen.filter(|_| net.found())) }?;
        Some(Self { middle, across, gap: net.gap() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_way_round_is_the_shorter_one_the_longer_one_or_none() {
        let ball = Vec2::new(0.3, 0.0);
        let with = |robots: &[Vec2]| {
            let robots = robots.iter().map(|&at| Obstacle { at, radius: ROBOT });
            Situation { ball, goal: None, obstacles: Obstacles(robots.collect()) }
        };
        let (right, left) = (ball - 0.3 * Vec2::Y, ball + 0.3 * Vec2::Y);
        // Who turns to the left goes round on the right.
        assert_eq!(with(&[]).way_round(3.0), Some(3.0));
        assert_eq!(with(&[left]).way_round(3.0), Some(3.0));
        assert_eq!(with(&[right]).way_round(3.0), Some(3.0 - TAU));
        assert_eq!(with(&[right]).way_round(-3.0), Some(-3.0));
        assert_eq!(with(&[left]).way_round(-3.0), Some(TAU - 3.0));
        assert_eq!(with(&[left, right]).way_round(3.0), None);
    }
}
