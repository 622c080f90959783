//! The situation at the ball.

use core::f32::consts::TAU;

use bica_field::FIELD;
use bica_motion::pose::rotate;
use glam::Vec2;
use libm::{ceilf, fabsf};

use super::obstacles::{Obstacle, Obstacles};
use crate::perception::{BallDetector, GoalDetector, Localization, RobotDetector};

/// Radius of another robot, m: half of its width, less the compliance of its arms.
const ROBOT_RADIUS: f32 = 0.12;
/// Distance from the toes of a robot, which are detected, to its middle, m.
const TOES: f32 = 0.08;
/// Radius of the path around the ball, m.
const ROUND_RADIUS: f32 = 0.24;
/// Angle between the tested points of the path around the ball, rad.
const ROUND_STEP: f32 = 0.3;

/// Ball, goal and obstacles, m, in the ground frame between the feet.
#[derive(Clone, Debug, PartialEq)]
pub struct Situation {
    pub(super) ball: Vec2,
    pub(super) goal: Option<Goal>,
    pub(super) obstacles: Obstacles,
}

/// The attacked goal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Goal {
    /// Its middle, m.
    pub(super) middle: Vec2,
    /// Unit vector from the right post to the left one.
    pub(super) across: Vec2,
    /// Middle of the gap beside the keeper, m to the left of the middle of the goal.
    pub(super) gap: Option<f32>,
}

impl Situation {
    /// The remembered situation; `None` while the position of the ball is unknown. The position of a goal that was not seen
    /// completely comes from the localization.
    #[must_use]
    #[inline(never)]
    pub fn of(ball: &BallDetector, goal: &GoalDetector, field: &Localization, robots: &RobotDetector) -> Option<Self> {
        let goal = Goal::of(goal, field);
        let mut obstacles = Obstacles::default();
        let half = |goal: Goal| 0.5 * FIELD.goal_width() * goal.across;
        let posts = goal.into_iter().flat_map(|goal| [goal.middle + half(goal), goal.middle - half(goal)]);
        let posts = posts.map(|at| Obstacle { at, radius: FIELD.post_radius() });
        let robots = robots.places().map(|place| place.position);
        let robots = robots.map(|toes| Obstacle { at: toes + TOES * toes.normalize_or_zero(), radius: ROBOT_RADIUS });
        obstacles.0.extend(posts.chain(robots));
        Some(Self { ball: ball.position()?, goal, obstacles })
    }

    /// The same situation without obstacles.
    pub(super) fn without_obstacles(&self) -> Self {
        Self { obstacles: Obstacles::default(), ..*self }
    }

    /// The angle of the path around the ball after which the body has turned by `turn`, rad: the shorter way if it is free, else
    /// the longer one; `None` if both are blocked.
    pub(super) fn way_round(&self, turn: f32) -> Option<f32> {
        let other = turn - TAU.copysign(turn);
        [turn, other].into_iter().find(|&way| self.is_free(way))
    }

    fn is_free(&self, turn: f32) -> bool {
        let from = -ROUND_RADIUS * self.ball.normalize_or_zero();
        let steps = ceilf(fabsf(turn) / ROUND_STEP) as u8;
        (1..=steps).all(|step| {
            let turned = rotate(from, turn * f32::from(step) / f32::from(steps));
            self.obstacles.allow_stand(self.ball + turned)
        })
    }
}

impl Goal {
    fn of(goal: &GoalDetector, field: &Localization) -> Option<Self> {
        let localized =
            || field.posts().map(|[left, right]| (left.midpoint(right), (left - right).normalize_or_zero()));
        let seen = goal.position().map(|at| (at, goal.across()));
        let (middle, across) =
            if goal.is_complete() { seen } else { localized().or(seen.filter(|_| goal.is_found())) }?;
        Some(Self { middle, across, gap: goal.gap() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_path_around_the_ball_is_the_shorter_free_one() {
        let ball = Vec2::new(0.3, 0.0);
        let with = |robots: &[Vec2]| {
            let robots = robots.iter().map(|&at| Obstacle { at, radius: ROBOT_RADIUS });
            Situation { ball, goal: None, obstacles: Obstacles(robots.collect()) }
        };
        let (right, left) = (ball - 0.3 * Vec2::Y, ball + 0.3 * Vec2::Y);
        // A turn to the left leads round the right side of the ball.
        assert_eq!(with(&[]).way_round(3.0), Some(3.0));
        assert_eq!(with(&[left]).way_round(3.0), Some(3.0));
        assert_eq!(with(&[right]).way_round(3.0), Some(3.0 - TAU));
        assert_eq!(with(&[right]).way_round(-3.0), Some(-3.0));
        assert_eq!(with(&[left]).way_round(-3.0), Some(TAU - 3.0));
        assert_eq!(with(&[left, right]).way_round(3.0), None);
    }
}
