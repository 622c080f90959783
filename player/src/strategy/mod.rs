//! What to do with the ball: decided once for each kick, at the ball.
//!
//! Data flow: what perception remembers → [`Situation`] → [`plan`] → a kick, or a way round the ball.

mod aim;
mod dribble;
mod obstacles;
mod situation;

pub use dribble::dribbles;
pub use situation::Situation;

use bica_motion::kick::{Kick, KickKind, Kicks};
use bica_motion::pose::{rotate, wrap};
use libm::{atan2f, fabsf};

use aim::Aim;

/// What to do with the ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Plan {
    /// Kick it.
    Kick(Strike),
    /// Go round it first, turning by this angle, rad to the left.
    GoRound(f32),
}

/// A kick and the heading to play it in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strike {
    /// Which of the six.
    pub kick: Kick,
    /// Heading of the body, rad.
    pub heading: f32,
}

/// Turning farther than this goes round the ball, less is left to the alignment, rad.
const FAR: f32 = 0.6;
/// How far to go round when no goal was seen, rad: it is behind.
const BEHIND: f32 = 2.5;
/// What it costs to go round the ball at all, rad: more than any kick without.
const ROUND: f32 = 10.0;
/// Who goes round the ball anyway goes to where the surest kick does it: what a kick costs counts for more, by this factor.
const CHOICE: f32 = 4.0;
/// What it costs to try again what something was in the way of, rad.
const IN_VAIN: f32 = 1.0;

/// Plans what to do with the ball: the kick that asks for the least turning, that nothing is in the way of, and that need
/// not be played from where something stands. Headings are relative to the body's. A kick that was given up just now, `in_vain`, is
/// planned again only if all else costs much more.
///
/// A goal of which nobody knows is behind. A ball from which no free way leads into the goal, as beside a post, is kicked
/// before the goal.
#[must_use]
#[inline(never)]
pub fn plan(situation: &Situation, kicks: &Kicks, in_vain: Option<Kick>) -> Plan {
    let Some(goal) = &situation.goal else { return Plan::GoRound(BEHIND) };
    let choice = |aims: &[Aim]| choose(situation, aims, kicks, in_vain);
    let possible = choice(&aim::scoring(goal)).or_else(|| choice(&aim::open(goal)));
    possible.or_else(|| choose(&situation.alone(), &aim::scoring(goal), kicks, None)).unwrap_or(Plan::GoRound(BEHIND))
}

/// The cheapest kick that is possible with little turning; else the way round to the cheapest that is possible from there.
#[inline(never)]
fn choose(situation: &Situation, aims: &[Aim], kicks: &Kicks, in_vain: Option<Kick>) -> Option<Plan> {
    let mut best = (f32::INFINITY, None);
    for aim in aims {
        for kick in Kick::ALL {
            let again = if in_vain == Some(kick) { IN_VAIN } else { 0.0 };
            if let Some((effort, plan)) = weigh(situation, aim, kick, kicks, again, best.0) {
                best = (effort, Some(plan));
            }
        }
    }
    best.1
}

/// What leads to a kick, and the effort that it asks for, rad of turning; none if that is not below `limit`, or something is in
/// the way.
fn weigh(situation: &Situation, aim: &Aim, kick: Kick, kicks: &Kicks, again: f32, limit: f32) -> Option<(f32, Plan)> {
    let way = aim.at - situation.ball;
    let turn = wrap(atan2f(way.y, way.x) - kick.direction());
    let cost = aim.cost + reluctance(kick) + again;
    let is_near = fabsf(turn) < FAR;
    let least = if is_near { fabsf(turn) + cost } else { ROUND + fabsf(turn) + CHOICE * cost };
    let stand = || situation.ball - rotate(kick.ball(kicks), turn);
    let obstacles = &situation.obstacles;
    if least >= limit || !obstacles.lets_pass(situation.ball, way) || !obstacles.lets_stand(stand()) {
        return None;
    }
    if is_near {
        return Some((least, Plan::Kick(Strike { kick, heading: turn })));
    }
    let round = situation.way_round(turn)?;
    let effort = least - fabsf(turn) + fabsf(round);
    (effort < limit).then_some((effort, Plan::GoRound(round)))
}

/// What a kick costs beside the turning, rad: the front kick is the surest.
const fn reluctance(kick: Kick) -> f32 {
    match kick.kind {
        KickKind::Front => 0.0,
        KickKind::Diagonal => 0.25,
        KickKind::Lateral => 0.4,
    }
}

impl Plan {
    /// The same plan with headings in a frame in which the body has this heading, rad.
    #[must_use]
    pub fn seen_with(self, heading: f32) -> Self {
        match self {
            Self::Kick(strike) => Self::Kick(Strike { heading: strike.heading + heading, ..strike }),
            Self::GoRound(angle) => Self::GoRound(angle),
        }
    }
}

#[cfg(test)]
mod tests {
    use core::f32::consts::{FRAC_PI_2, PI};

    use bica_motion::model::{Nao, RobotModel};
    use glam::Vec2;

    use super::obstacles::{Obstacle, Obstacles};
    use super::situation::Goal;
    use super::*;

    const KICKS: Kicks = Nao::DYNAMIC_PROFILE.kicks;
    const BALL: Vec2 = Vec2::new(0.3, 0.0);

    /// Goal posts stand where its middle and direction say; other robots at `robots`, m.
    fn situation(ball: Vec2, middle: Vec2, heading: f32, gap: Option<f32>, robots: &[Vec2]) -> Situation {
        let across = rotate(Vec2::Y, heading);
        let post = |side: f32| Obstacle { at: middle + 0.7 * side * across, radius: 0.05 };
        let robots = robots.iter().map(|&at| Obstacle { at, radius: 0.12 });
        let obstacles = Obstacles([post(1.0), post(-1.0)].into_iter().chain(robots).collect());
        Situation { ball, goal: Some(Goal { middle, across, gap }), obstacles }
    }

    fn kick(situation: &Situation) -> (Strike, Vec2, Vec2) {
        let Plan::Kick(strike) = plan(situation, &KICKS, None) else { panic!("a kick was expected: {situation:?}") };
        let stand = situation.ball - rotate(strike.kick.ball(&KICKS), strike.heading);
        (strike, stand, rotate(Vec2::X, strike.heading + strike.kick.direction()))
    }

    #[test]
    fn a_far_goal_straight_ahead_is_kicked_at_where_the_gap_is() {
        for gap in [-0.4_f32, 0.3] {
            let (strike, _, way) = kick(&situation(BALL, Vec2::new(2.3, 0.0), 0.0, Some(gap), &[]));
            assert_eq!(strike.kick.kind, KickKind::Front);
            assert!((way.to_angle() - (gap / 2.0).atan()).abs() < 0.01, "{strike:?}");
        }
    }

    #[test]
    fn a_goal_to_a_side_is_kicked_at_with_the_kick_that_needs_little_turning() {
        for (direction, kind) in [(FRAC_PI_2, KickKind::Lateral), (0.8, KickKind::Diagonal)] {
            for side in [1.0, -1.0] {
                let angle = side * direction;
                let goal = BALL + 2.0 * Vec2::from_angle(angle);
                let (strike, ..) = kick(&situation(BALL, goal, angle, Some(0.0), &[]));
                assert_eq!(strike.kick.kind, kind);
                assert!(strike.heading.abs() < 0.1, "{strike:?}");
            }
        }
    }

    #[test]
    fn a_goal_that_is_behind_or_unknown_asks_for_a_way_round_the_ball() {
        let behind = situation(BALL, Vec2::new(-2.0, 0.0), PI, Some(0.0), &[]);
        assert!(matches!(plan(&behind, &KICKS, None), Plan::GoRound(angle) if angle.abs() > 3.0));
        let unknown = Situation { goal: None, ..behind };
        assert_eq!(plan(&unknown, &KICKS, None), Plan::GoRound(BEHIND));
    }

    #[test]
    fn a_ball_at_the_keepers_foot_is_kicked_past_it_and_from_beside_it() {
        for side in [1.0, -1.0] {
            let keeper = Vec2::new(0.37, -0.12 * side);
            let (_, stand, way) = kick(&situation(BALL, Vec2::new(0.5, 0.0), 0.0, Some(0.3 * side), &[keeper]));
            assert!(stand.distance(keeper) > 0.27, "{stand}");
            let off = keeper - BALL;
            assert!(off.dot(way) < 0.0 || off.perp_dot(way).abs() > 0.15, "{way}");
            let at_line = BALL + way * (0.2 / way.x);
            assert!(way.x > 0.0 && at_line.y.abs() < 0.65, "it goes into the goal: {at_line}");
        }
    }

    #[test]
    fn a_ball_beside_a_post_is_kicked_before_the_goal() {
        let beside = situation(BALL, Vec2::new(0.32, 0.88), 0.0, Some(0.0), &[]);
        let Plan::GoRound(angle) = plan(&beside, &KICKS, None) else { panic!("it is too far to turn") };
        let turned = rotate(BALL, -angle);
        let after = situation(turned, rotate(Vec2::new(0.32, 0.88), -angle), -angle, Some(0.0), &[]);
        let (_, stand, way) = kick(&after);
        let way = rotate(way, angle);
        assert!(way.x < -0.3 && way.y > 0.3, "back into the field, towards the goal's middle: {way}");
        assert!(after.obstacles.lets_stand(stand));
    }

    #[test]
    fn a_kick_that_was_in_vain_is_not_tried_again_if_another_one_will_do() {
        let at_goal = situation(BALL, Vec2::new(0.8, 0.0), 0.0, Some(0.0), &[]);
        let (first, ..) = kick(&at_goal);
        let Plan::Kick(second) = plan(&at_goal, &KICKS, Some(first.kick)) else { panic!("a kick") };
        assert_ne!(first.kick, second.kick);
    }

    #[test]
    fn the_way_round_the_ball_goes_where_nobody_stands() {
        for side in [1.0, -1.0] {
            let goal = (Vec2::new(-2.0, 0.3 * side), PI);
            let Plan::GoRound(short) = plan(&situation(BALL, goal.0, goal.1, Some(0.0), &[]), &KICKS, None) else {
                panic!("far")
            };
            // Who turns to the left goes round on the right.
            let robot = BALL + Vec2::new(0.0, -0.3 * short.signum());
            let Plan::GoRound(long) = plan(&situation(BALL, goal.0, goal.1, Some(0.0), &[robot]), &KICKS, None) else {
                panic!("far")
            };
            assert!(long * short < 0.0, "{short} {long}");
        }
    }

    #[test]
    fn who_is_surrounded_tries_what_would_be_right_without_the_others() {
        let ring: [Vec2; 4] = core::array::from_fn(|i| BALL + 0.2 * Vec2::from_angle(i as f32 * FRAC_PI_2));
        let goal = Vec2::new(2.0, 0.0);
        let free = plan(&situation(BALL, goal, 0.0, Some(0.0), &[]), &KICKS, None);
        assert_eq!(plan(&situation(BALL, goal, 0.0, Some(0.0), &ring), &KICKS, None), free);
    }
}
