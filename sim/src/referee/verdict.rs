//! Rules for a ball that leaves the field.

use glam::Vec2;

use crate::field::{BALL_RADIUS, CORNER, LINE_WIDTH, POST, POST_RADIUS, THROW_IN};

/// Decision of the rules for a position of the ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Verdict {
    /// In play.
    InPlay,
    /// In the goal at positive x.
    Goal,
    /// In the goal at negative x.
    OwnGoal,
    /// Out of the field; returns into play at this position, m.
    Out(Vec2),
}

/// Decides by the centre of the ball, m, field frame. A goal or an out requires the whole ball beyond the whole line.
pub(crate) fn judge(ball: Vec2) -> Verdict {
    let over = CORNER + Vec2::splat(LINE_WIDTH / 2.0 + BALL_RADIUS);
    if ball.x.abs() > over.x && ball.y.abs() < POST.y - POST_RADIUS {
        return if ball.x > 0.0 { Verdict::Goal } else { Verdict::OwnGoal };
    }
    if ball.x.abs() > over.x || ball.y.abs() > over.y {
        let x = ball.x.clamp(-THROW_IN.x, THROW_IN.x);
        return Verdict::Out(Vec2::new(x, THROW_IN.y.copysign(ball.y)));
    }
    Verdict::InPlay
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn goal_requires_whole_ball_over_line() {
        assert_eq!(judge(Vec2::new(3.025 + 0.032, 0.0)), Verdict::InPlay);
        assert_eq!(judge(Vec2::new(3.025 + 0.033, 0.0)), Verdict::Goal);
        assert_eq!(judge(Vec2::new(3.1, 0.64)), Verdict::Goal);
        assert_eq!(judge(Vec2::new(-3.1, -0.64)), Verdict::OwnGoal);
        assert_eq!(judge(Vec2::new(3.1, 0.8)), Verdict::Out(Vec2::new(2.0, 1.6)));
    }

    #[test]
    fn ball_out_returns_on_throw_in_line() {
        assert_eq!(judge(Vec2::new(0.5, -2.05)), Verdict::InPlay);
        assert_eq!(judge(Vec2::new(0.5, -2.06)), Verdict::Out(Vec2::new(0.5, -1.6)));
        assert_eq!(judge(Vec2::new(-2.7, 2.06)), Verdict::Out(Vec2::new(-2.0, 1.6)));
    }
}
