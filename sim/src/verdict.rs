//! The rules on a ball that leaves the field.

use glam::Vec2;

use bica_field::FIELD;

/// What the rules say about a ball that lies at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Verdict {
    /// Play on.
    InPlay,
    /// In the goal at positive x.
    Goal,
    /// In the goal at negative x.
    OwnGoal,
    /// Out, and comes back in here.
    Out(Vec2),
}

/// Judges a ball by where its middle is. Goals and outs need the whole ball over the whole line.
pub(crate) fn judge(ball: Vec2) -> Verdict {
    let over = FIELD.field_corner() + Vec2::splat(FIELD.line_width() / 2.0 + FIELD.ball_radius());
    if ball.x.abs() > over.x && ball.y.abs() < FIELD.goal_post().y - FIELD.post_radius() {
        return if ball.x > 0.0 { Verdict::Goal } else { Verdict::OwnGoal };
    }
    if ball.x.abs() > over.x || ball.y.abs() > over.y {
        let throw_in = FIELD.throw_in_corner();
        let x = ball.x.clamp(-throw_in.x, throw_in.x);
        return Verdict::Out(Vec2::new(x, throw_in.y.copysign(ball.y)));
    }
    Verdict::InPlay
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_goal_needs_the_whole_ball_over_the_line_between_the_posts() {
        assert_eq!(judge(Vec2::new(3.025 + 0.032, 0.0)), Verdict::InPlay);
        assert_eq!(judge(Vec2::new(3.025 + 0.033, 0.0)), Verdict::Goal);
        assert_eq!(judge(Vec2::new(3.1, 0.64)), Verdict::Goal);
        assert_eq!(judge(Vec2::new(-3.1, -0.64)), Verdict::OwnGoal);
        assert_eq!(judge(Vec2::new(3.1, 0.8)), Verdict::Out(Vec2::new(2.0, 1.6)));
    }

    #[test]
    fn a_ball_over_the_side_line_comes_back_on_the_throw_in_line() {
        assert_eq!(judge(Vec2::new(0.5, -2.05)), Verdict::InPlay);
        assert_eq!(judge(Vec2::new(0.5, -2.06)), Verdict::Out(Vec2::new(0.5, -1.6)));
        assert_eq!(judge(Vec2::new(-2.7, 2.06)), Verdict::Out(Vec2::new(-2.0, 1.6)));
    }
}
