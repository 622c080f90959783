//! The field of 2009: lengths and the rules that depend on them only.
//!
//! Source: rules of the Standard Platform League 2009, with the centres of lines and posts as in B-Human 2009's
//! `field.cfg`. Everything lies mirrored at negative x and negative y. Field frame, m.

use glam::Vec2;

/// The carpet's corner.
pub(crate) const CARPET: Vec2 = Vec2::new(3.7, 2.7);
/// The middle of the corner of the lines around the field.
pub(crate) const CORNER: Vec2 = Vec2::new(3.0, 2.0);
/// How wide lines are.
pub(crate) const LINE_WIDTH: f32 = 0.05;
/// The middle of the inner corner of a penalty area's lines.
pub(crate) const PENALTY_AREA: Vec2 = Vec2::new(2.4, 1.5);
/// The middle of the centre circle's line.
pub(crate) const CIRCLE: f32 = 0.6;
/// The penalty marks' x.
pub(crate) const PENALTY_MARK: f32 = 1.2;
/// How long the bars of a mark are: it is a plus sign.
pub(crate) const MARK: f32 = 0.1;

/// Where a goal post stands.
pub(crate) const POST: Vec2 = Vec2::new(3.05, 0.7);
/// How thick posts are.
pub(crate) const POST_RADIUS: f32 = 0.05;
/// How thick the crossbar is.
pub(crate) const BAR_RADIUS: f32 = 0.025;
/// How high goals are.
pub(crate) const GOAL_HEIGHT: f32 = 0.8;
/// The x of a goal's back on the ground.
pub(crate) const GOAL_BACK: f32 = 3.5;
/// How high and how deep the triangles at the goal's sides are.
pub(crate) const GOAL_TRIANGLE: f32 = 0.4;

/// The corner of the invisible lines on which a ball that was out comes back.
pub(crate) const THROW_IN: Vec2 = Vec2::new(2.0, 1.6);

/// The ball's radius (street-hockey ball of 65 mm, rules 2010).
pub(crate) const BALL_RADIUS: f32 = 0.0325;

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
