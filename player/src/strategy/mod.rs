//! Planning at the ball, once for each kick.
//!
//! Data flow: remembered ball, goal and robots → [`Situation`] → [`plan`] → a kick, or a path around the ball.

mod aim;
mod dribble;
mod free_path;
mod obstacles;
mod situation;

pub use dribble::can_dribble;
pub(crate) use free_path::free_path;
pub use situation::Situation;

use bica_motion::kick::{Kick, KickKind, Kicks};
use bica_motion::pose::{rotate, wrap};
use libm::{atan2f, fabsf};

use aim::Aim;

/// Next action at the ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Plan {
    /// Kick it.
    Kick(Strike),
    /// Walk around it first, with a turn by this angle, rad to the left.
    GoRound(f32),
}

/// Kick with the heading in which to play it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strike {
    /// The kick.
    pub kick: Kick,
    /// Heading of the body during the kick, rad.
    pub heading: f32,
}

/// Maximum turn of an alignment, rad; a larger one needs a path around the ball.
const MAX_ALIGNMENT: f32 = 0.6;
/// Turn around the ball if no goal was seen, rad: the goal is assumed behind the robot.
const UNKNOWN_GOAL_TURN: f32 = 2.5;
/// Cost of a path around the ball, rad: above that of every kick without one.
const CIRCLING_COST: f32 = 10.0;
/// Weight of the cost of a kick in addition to a path around the ball.
const CIRCLING_WEIGHT: f32 = 4.0;
/// Additional cost of the last failed kick, rad.
const REPETITION_COST: f32 = 1.0;

/// Plans the next action at the ball: the kick with the smallest turn whose path and standing position are free.
/// Headings are relative to the body. `last_failed_kick` is repeated only if every other kick costs much more.
///
/// An unknown goal is assumed behind the robot. If no free path leads from the ball into the goal, for example beside a
/// post, the ball is kicked in front of the goal.
#[must_use]
#[inline(never)]
pub fn plan(situation: &Situation, kicks: &Kicks, last_failed_kick: Option<Kick>) -> Plan {
    let Some(goal) = &situation.goal else { return Plan::GoRound(UNKNOWN_GOAL_TURN) };
    let choice = |aims: &[Aim]| choose(situation, aims, kicks, last_failed_kick);
    let possible = choice(&aim::scoring(goal)).or_else(|| choice(&aim::open(goal)));
    possible
        .or_else(|| choose(&situation.without_obstacles(), &aim::scoring(goal), kicks, None))
        .unwrap_or(Plan::GoRound(UNKNOWN_GOAL_TURN))
}

/// The cheapest kick that needs a small turn; otherwise the path around the ball to the cheapest one.
#[inline(never)]
fn choose(situation: &Situation, aims: &[Aim], kicks: &Kicks, last_failed_kick: Option<Kick>) -> Option<Plan> {
    let mut best = (f32::INFINITY, None);
    for aim in aims {
        for kick in Kick::ALL {
            let again = if last_failed_kick == Some(kick) { REPETITION_COST } else { 0.0 };
            if let Some((effort, plan)) = weigh(situation, aim, kick, kicks, again, best.0) {
                best = (effort, Some(plan));
            }
        }
    }
    best.1
}

/// Plan for a kick and its cost, rad of turning; `None` if the cost is not below `limit`, or an obstacle prevents the
/// kick.
fn weigh(situation: &Situation, aim: &Aim, kick: Kick, kicks: &Kicks, again: f32, limit: f32) -> Option<(f32, Plan)> {
    let path = aim.at - situation.ball;
    let turn = wrap(atan2f(path.y, path.x) - kick.direction());
    let cost = aim.cost + kick_cost(kick) + again;
    let is_near = fabsf(turn) < MAX_ALIGNMENT;
    let least = if is_near { fabsf(turn) + cost } else { CIRCLING_COST + fabsf(turn) + CIRCLING_WEIGHT * cost };
    let stand = || situation.ball - rotate(kick.ball(kicks), turn);
    let obstacles = &situation.obstacles;
    if least >= limit || !obstacles.allow_kick(situation.ball, path) || !obstacles.allow_stand(stand()) {
        return None;
    }
    if is_near {
        return Some((least, Plan::Kick(Strike { kick, heading: turn })));
    }
    let round = situation.way_round(turn)?;
    let effort = least - fabsf(turn) + fabsf(round);
    (effort < limit).then_some((effort, Plan::GoRound(round)))
}

/// Cost of a kick in addition to the turning, rad: the front kick is the most reliable.
const fn kick_cost(kick: Kick) -> f32 {
    match kick.kind {
        KickKind::Front => 0.0,
        KickKind::Diagonal => 0.25,
        KickKind::Lateral => 0.4,
    }
}

impl Plan {
    /// The same plan with headings in a frame in which the body has this heading, rad.
    #[must_use]
    pub fn in_frame(self, heading: f32) -> Self {
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

    /// A situation with the two posts of a goal, given by its middle and heading, and robots at these positions, m.
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
    fn a_far_goal_straight_ahead_gets_a_front_kick_into_the_gap() {
        for gap in [-0.4_f32, 0.3] {
            let (strike, _, way) = kick(&situation(BALL, Vec2::new(2.3, 0.0), 0.0, Some(gap), &[]));
            assert_eq!(strike.kick.kind, KickKind::Front);
            assert!((way.to_angle() - (gap / 2.0).atan()).abs() < 0.01, "{strike:?}");
        }
    }

    #[test]
    fn a_goal_to_a_side_gets_the_kick_with_the_least_turning() {
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
    fn a_goal_behind_the_robot_or_unknown_needs_a_path_around_the_ball() {
        let behind = situation(BALL, Vec2::new(-2.0, 0.0), PI, Some(0.0), &[]);
        assert!(matches!(plan(&behind, &KICKS, None), Plan::GoRound(angle) if angle.abs() > 3.0));
        let unknown = Situation { goal: None, ..behind };
        assert_eq!(plan(&unknown, &KICKS, None), Plan::GoRound(UNKNOWN_GOAL_TURN));
    }

    #[test]
    fn a_ball_at_the_keepers_foot_is_kicked_past_it_from_beside_it() {
        for side in [1.0, -1.0] {
            let keeper = Vec2::new(0.37, -0.12 * side);
            let (_, stand, way) = kick(&situation(BALL, Vec2::new(0.5, 0.0), 0.0, Some(0.3 * side), &[keeper]));
            assert!(stand.distance(keeper) > 0.27, "{stand}");
            let off = keeper - BALL;
            assert!(off.dot(way) < 0.0 || off.perp_dot(way).abs() > 0.15, "{way}");
            let at_line = BALL + way * (0.2 / way.x);
            assert!(way.x > 0.0 && at_line.y.abs() < 0.65, "the path ends in the goal: {at_line}");
        }
    }

    #[test]
    fn a_ball_beside_a_post_is_kicked_before_the_goal() {
        let beside = situation(BALL, Vec2::new(0.32, 0.88), 0.0, Some(0.0), &[]);
        let Plan::GoRound(angle) = plan(&beside, &KICKS, None) else { panic!("the turn is too large") };
        let turned = rotate(BALL, -angle);
        let after = situation(turned, rotate(Vec2::new(0.32, 0.88), -angle), -angle, Some(0.0), &[]);
        let (_, stand, way) = kick(&after);
        let way = rotate(way, angle);
        assert!(way.x < -0.3 && way.y > 0.3, "into the field, towards the middle of the goal: {way}");
        assert!(after.obstacles.allow_stand(stand));
    }

    #[test]
    fn a_failed_kick_is_not_repeated_if_another_one_is_possible() {
        let at_goal = situation(BALL, Vec2::new(0.8, 0.0), 0.0, Some(0.0), &[]);
        let (first, ..) = kick(&at_goal);
        let Plan::Kick(second) = plan(&at_goal, &KICKS, Some(first.kick)) else { panic!("a kick") };
        assert_ne!(first.kick, second.kick);
    }

    #[test]
    fn the_path_around_the_ball_avoids_other_robots() {
        for side in [1.0, -1.0] {
            let goal = (Vec2::new(-2.0, 0.3 * side), PI);
            let Plan::GoRound(short) = plan(&situation(BALL, goal.0, goal.1, Some(0.0), &[]), &KICKS, None) else {
                panic!("far")
            };
            // A turn to the left leads round the right side of the ball.
            let robot = BALL + Vec2::new(0.0, -0.3 * short.signum());
            let Plan::GoRound(long) = plan(&situation(BALL, goal.0, goal.1, Some(0.0), &[robot]), &KICKS, None) else {
                panic!("far")
            };
            assert!(long * short < 0.0, "{short} {long}");
        }
    }

    #[test]
    fn a_surrounded_ball_is_played_as_if_there_were_no_robots() {
        let ring: [Vec2; 4] = core::array::from_fn(|i| BALL + 0.2 * Vec2::from_angle(i as f32 * FRAC_PI_2));
        let goal = Vec2::new(2.0, 0.0);
        let free = plan(&situation(BALL, goal, 0.0, Some(0.0), &[]), &KICKS, None);
        assert_eq!(plan(&situation(BALL, goal, 0.0, Some(0.0), &ring), &KICKS, None), free);
    }
}
