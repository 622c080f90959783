//! When to kick the ball on in the walk.

use libm::{atan2f, fabsf};

use crate::perception::{BallDetector, NetDetector};

/// A goal farther than this from the ball is too far for a kick past its keeper, m.
const LONG: f32 = 2.2;
/// Where the ball must lie to be kicked on in the walk: nearest and farthest ahead, and aside, m.
const BEFORE: ([f32; 2], f32) = ([0.25, 0.6], 0.12);
/// How far aside of straight ahead the goal may be from the ball, rad.
const ALONG: f32 = 0.5;

/// Whether to kick the ball on in the walk: it lies straight ahead, and far behind it the goal.
#[must_use]
pub fn dribbles(ball: &BallDetector, net: &NetDetector) -> bool {
    let Some((ball, goal)) = ball.at().zip(net.at()).filter(|_| ball.sure()) else { return false };
    let ([near, far], aside) = BEFORE;
    let way = goal - ball;
    let before = ball.x > near && ball.x < far && fabsf(ball.y) < aside;
    before && way.length() > LONG && fabsf(atan2f(way.y, way.x)) < ALONG
}
