//! The situation at the ball.

use core::f32::consts::TAU;

use bica_motion::pose::rotate;
use glam::Vec2;
use libm::{ceilf, fabsf};

use super::obstacles::{Clearance, Obstacle, Obstacles};
use crate::roles::{self, Ball, Place, Robots};

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
    /// Its width, m.
    pub(super) width: f32,
}

impl Situation {
    /// The remembered situation; `None` while the position of the ball is unknown. The position of a goal that was not seen
    /// completely comes from the localization.
    #[must_use]
    #[inline(never)]
    pub fn of(
        ball: &impl Ball,
        goal: &impl roles::Goal,
        field: &impl Place,
        robots: &impl Robots,
        clearance: &Clearance,
    ) -> Option<Self> {
        let goal = Goal::of(goal, field);
        let mut obstacles = Obstacles::default();
        let half = |goal: Goal| 0.5 * goal.width * goal.across;
        let posts = goal.into_iter().flat_map(|goal| [goal.middle + half(goal), goal.middle - half(goal)]);
        let posts = posts.map(|at| Obstacle { at, radius: field.field().post_radius() });
        let (toe_distance, radius) = (clearance.robot_toe_distance, clearance.robot_radius);
        let robots = roles::positions(robots)
            .map(|toes| Obstacle { at: toes + toe_distance * toes.normalize_or_zero(), radius });
        obstacles.0.extend(posts.chain(robots));
        Some(Self { ball: ball.position()?, goal, obstacles })
    }

    /// The same situation without obstacles.
    pub(super) fn without_obstacles(&self) -> Self {
        Self { obstacles: Obstacles::default(), ..*self }
    }

    /// The angle of the path around the ball after which the body has turned by `turn`, rad: the shorter way if it is free, else
    /// the longer one; `None` if both are blocked.
    pub(super) fn way_round(&self, turn: f32, clearance: &Clearance) -> Option<f32> {
        let other = turn - TAU.copysign(turn);
        [turn, other].into_iter().find(|&way| self.is_free(way, clearance))
    }

    fn is_free(&self, turn: f32, clearance: &Clearance) -> bool {
        let from = -clearance.way_round_radius * self.ball.normalize_or_zero();
        let steps = ceilf(fabsf(turn) / ROUND_STEP) as u8;
        (1..=steps).all(|step| {
            let turned = rotate(from, turn * f32::from(step) / f32::from(steps));
            self.obstacles.allow_stand(self.ball + turned, clearance)
        })
    }
}

impl Goal {
    fn of(goal: &impl roles::Goal, field: &impl Place) -> Option<Self> {
        let localized =
            || field.posts().map(|[left, right]| (left.midpoint(right), (left - right).normalize_or_zero()));
        let seen = goal.position().map(|at| (at, goal.across()));
        let (middle, across) =
            if goal.is_complete() { seen } else { localized().or(seen.filter(|_| goal.is_found())) }?;
        Some(Self { middle, across, gap: goal.gap(), width: field.field().goal_width() })
    }
}

#[cfg(test)]
mod tests {
    use bica::prelude::*;

    use super::*;

    #[test]
    fn path_around_ball_is_shorter_one() {
        let ball = Vec2::new(0.3, 0.0);
        let with = |robots: &[Vec2]| {
            let robots = robots.iter().map(|&at| Obstacle { at, radius: 0.12 });
            Situation { ball, goal: None, obstacles: Obstacles(robots.collect()) }
        };
        let way = |robots: &[Vec2], turn| with(robots).way_round(turn, &Clearance::DEFAULT);
        let (right, left) = (ball - 0.3 * Vec2::Y, ball + 0.3 * Vec2::Y);
        // A turn to the left leads round the right side of the ball.
        assert_eq!(way(&[], 3.0), Some(3.0));
        assert_eq!(way(&[left], 3.0), Some(3.0));
        assert_eq!(way(&[right], 3.0), Some(3.0 - TAU));
        assert_eq!(way(&[right], -3.0), Some(-3.0));
        assert_eq!(way(&[left], -3.0), Some(TAU - 3.0));
        assert_eq!(way(&[left, right], 3.0), None);
    }

    #[test]
    fn path_around_ball_has_tuned_radius() {
        let ball = Vec2::new(0.3, 0.0);
        let robot = Obstacle { at: ball - 0.55 * Vec2::Y, radius: 0.12 };
        let situation = Situation { ball, goal: None, obstacles: Obstacles([robot].into_iter().collect()) };
        assert_eq!(situation.way_round(3.0, &Clearance::DEFAULT), Some(3.0));
        let wide = Clearance { way_round_radius: 0.4, ..Clearance::DEFAULT };
        assert_eq!(situation.way_round(3.0, &wide), Some(3.0 - TAU));
    }
}
