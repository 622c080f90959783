//! Kicking without a halt: a step whose foot swings through the ball before it comes down as planned.
//!
//! The idea is that of the in-walk kicks of HULKs 2025 (`kick_steps`) and B-Human 2023; curve and figures are our own.

use glam::Vec2;

use crate::easing::smooth;
use crate::side::Side;

/// How far to either side of the ankle's line a foot still meets the ball well, m.
const BESIDE: f32 = 0.025;
/// From the hips to the nearest and the farthest ball that the next swing meets, m.
const AHEAD: [f32; 2] = [0.13, 0.20];
/// When the foot has swung farthest, as a share of its time in the air.
const FARTHEST: f32 = 0.65;

/// The foot whose next step can kick a ball that lies at `ball`, m (frame: on the ground between the feet, x ahead), in a
/// walk ahead.
#[must_use]
pub fn in_walk_kick_foot(ball: Vec2, half_spacing: f32) -> Option<Side> {
    let side = if ball.y > 0.0 { Side::Left } else { Side::Right };
    let [near, far] = AHEAD;
    let meets = ball.x > near && ball.x < far && (ball.y.abs() - half_spacing).abs() < BESIDE;
    meets.then_some(side)
}

/// How far through the ball the foot is at a share of its time in the air, 0 to 1.
pub(super) fn through(air: f32) -> f32 {
    smooth(air / FARTHEST) - smooth((air - FARTHEST) / (1.0 - FARTHEST))
}
