//! Condition for a kick in walking.

use bica::prelude::*;
use glam::Vec2;
use libm::{atan2f, fabsf};

use crate::roles::{Ball, Goal};

/// When the forward kicks in walking.
#[derive(Clone, Debug, PartialEq, Params)]
#[params(check = Self::is_ordered)]
pub struct DribbleCondition {
    /// Least distance from ball to goal: from farther away a kick past the keeper is unlikely to score.
    #[param(default = 2.2, range = 0.5..=6.0, unit = "m", step = 0.1)]
    pub dribble_goal_distance: f32,
    /// Least forward distance of the ball.
    #[param(default = 0.25, range = 0.1..=1.0, unit = "m", step = 0.05)]
    pub dribble_min_ahead: f32,
    /// Largest forward distance of the ball. `Dribble.far_distance` should be above it.
    #[param(default = 0.6, range = 0.1..=1.5, unit = "m", step = 0.05)]
    pub dribble_max_ahead: f32,
    /// Largest sideways distance of the ball; 0 never kicks in walking.
    #[param(default = 0.12, range = 0.0..=0.5, unit = "m", step = 0.01)]
    pub dribble_max_aside: f32,
    /// Largest angle between straight ahead and the direction from ball to goal.
    #[param(default = 0.5, range = 0.05..=1.5, unit = "rad", step = 0.05)]
    pub dribble_max_angle: f32,
}

impl DribbleCondition {
    const fn is_ordered(&self) -> Result<(), &'static str> {
        if self.dribble_min_ahead <= self.dribble_max_ahead {
            Ok(())
        } else {
            Err("`dribble_min_ahead` must not be above `dribble_max_ahead`")
        }
    }

    /// Whether positions of ball and goal, m, in the ground frame, allow a kick in walking.
    fn allows(&self, ball: Vec2, goal: Vec2) -> bool {
        let to_goal = goal - ball;
        let before = ball.x > self.dribble_min_ahead
            && ball.x < self.dribble_max_ahead
            && fabsf(ball.y) < self.dribble_max_aside;
        before
            && to_goal.length() > self.dribble_goal_distance
            && fabsf(atan2f(to_goal.y, to_goal.x)) < self.dribble_max_angle
    }
}

/// Whether to kick in walking: the ball is straight ahead, and the goal far behind it.
#[must_use]
pub fn can_dribble(ball: &impl Ball, goal: &impl Goal, condition: &DribbleCondition) -> bool {
    let Some((ball, goal)) = ball.position().zip(goal.position()).filter(|_| ball.is_confirmed()) else { return false };
    condition.allows(ball, goal)
}

#[cfg(test)]
mod tests {
    use super::*;

    const BALL: Vec2 = Vec2::new(0.4, 0.05);
    const GOAL: Vec2 = Vec2::new(3.0, 0.0);

    #[test]
    fn each_limit_of_the_condition_counts() {
        assert!(DribbleCondition::DEFAULT.allows(BALL, GOAL));
        let stricter = [
            DribbleCondition { dribble_goal_distance: 2.7, ..DribbleCondition::DEFAULT },
            DribbleCondition { dribble_min_ahead: 0.45, ..DribbleCondition::DEFAULT },
            DribbleCondition { dribble_max_ahead: 0.35, ..DribbleCondition::DEFAULT },
            DribbleCondition { dribble_max_aside: 0.04, ..DribbleCondition::DEFAULT },
            DribbleCondition { dribble_max_angle: 0.01, ..DribbleCondition::DEFAULT },
        ];
        for condition in stricter {
            assert!(condition.check().is_ok() && !condition.allows(BALL, GOAL), "{condition:?}");
        }
    }

    #[test]
    fn distances_in_wrong_order_are_refused() {
        assert!(DribbleCondition { dribble_max_ahead: 0.2, ..DribbleCondition::DEFAULT }.check().is_err());
    }
}
