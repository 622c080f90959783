//! In-walk kick: a step whose foot swings through the ball before it comes down as planned.
//!
//! Method: in-walk kicks of HULKs 2025 (`kick_steps`) and B-Human 2023. The curve and its parameters are our own.

use glam::Vec2;

use crate::easing::smooth;
use crate::model::Parameters;
use crate::side::Side;

/// Phase of the swing at which the foot is farthest forward.
const FARTHEST_PHASE: f32 = 0.65;

/// Foot whose next step can kick the ball in a forward walk, if any.
///
/// `ball`: position of the ball's centre, m, in the frame of the ground between the feet, x ahead.
#[must_use]
pub fn in_walk_kick_foot(ball: Vec2, gait: &Parameters) -> Option<Side> {
    let side = if ball.y > 0.0 { Side::Left } else { Side::Right };
    let ahead = ball.x > gait.kick_min_distance && ball.x < gait.kick_max_distance;
    let meets = ahead && (ball.y.abs() - gait.half_spacing).abs() < gait.kick_lateral_tolerance;
    meets.then_some(side)
}

/// Forward displacement of the foot at a phase of its swing, relative to its maximum.
pub(super) fn kick_displacement(phase: f32) -> f32 {
    smooth(phase / FARTHEST_PHASE) - smooth((phase - FARTHEST_PHASE) / (1.0 - FARTHEST_PHASE))
}
