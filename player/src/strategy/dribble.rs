//! Condition for a kick in walking.

use libm::{atan2f, fabsf};

use crate::perception::{BallDetector, GoalDetector};

/// Distance from ball to goal above which a kick past the keeper is unlikely to score, m.
const LONG: f32 = 2.2;
/// Least forward distance of the ball, m.
const MIN_AHEAD: f32 = 0.25;
/// Largest forward distance of the ball, m.
const MAX_AHEAD: f32 = 0.6;
/// Largest sideways distance of the ball, m.
const MAX_ASIDE: f32 = 0.12;
/// Largest angle between straight ahead and the direction from ball to goal, rad.
const MAX_ANGLE: f32 = 0.5;

/// Whether to kick in walking: the ball is straight ahead, and the goal far behind it.
#[must_use]
pub fn can_dribble(ball: &BallDetector, goal: &GoalDetector) -> bool {
    let Some((ball, goal)) = ball.position().zip(goal.position()).filter(|_| ball.is_confirmed()) else { return false };
    let to_goal = goal - ball;
    let before = ball.x > MIN_AHEAD && ball.x < MAX_AHEAD && fabsf(ball.y) < MAX_ASIDE;
    before && to_goal.length() > LONG && fabsf(atan2f(to_goal.y, to_goal.x)) < MAX_ANGLE
}
