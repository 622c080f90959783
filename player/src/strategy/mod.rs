//! Planning at the ball, once for each kick.
//!
//! Data flow: remembered ball, goal and robots → [`Situation`] → [`plan`] → a kick, or a path around the ball.

mod aim;
mod dribble;
mod free_path;
mod obstacles;
mod planning;
mod situation;
mod viewpoints;

pub use dribble::{DribbleCondition, can_dribble};
pub use free_path::Strip;
pub(crate) use free_path::free_path;
pub use obstacles::Clearance;
pub use planning::Planning;
pub use situation::Situation;
pub(crate) use viewpoints::Viewpoints;

use bica_motion::kick::{Kick, Kicks};
use bica_motion::pose::{rotate, wrap};
use libm::{atan2f, fabsf};

use aim::Aim;

/// Next action at the ball.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, postcard_schema::Schema)]
pub enum Plan {
    /// Kick it.
    Kick(Strike),
    /// Walk around it first, with a turn by this angle, rad to the left.
    GoRound(f32),
}

/// Kick with the heading in which to play it.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, postcard_schema::Schema)]
pub struct Strike {
    /// The kick.
    pub kick: Kick,
    /// Heading of the body during the kick, rad.
    pub heading: f32,
}

/// Plans the next action at the ball: the kick with the smallest turn whose path and standing position are free.
/// Headings are relative to the body. `last_failed_kick` is repeated only if every other kick costs much more.
///
/// An unknown goal is assumed behind the robot. If no free path leads from the ball into the goal, for example beside a
/// post, the ball is kicked in front of the goal.
#[must_use]
#[inline(never)]
pub fn plan(
    situation: &Situation,
    kicks: &Kicks,
    last_failed_kick: Option<Kick>,
    planning: &Planning,
    clearance: &Clearance,
) -> Plan {
    let go_round = Plan::GoRound(planning.unknown_goal_turn);
    let Some(goal) = &situation.goal else { return go_round };
    let task = Task { situation, kicks, planning, clearance };
    let scoring = aim::scoring(goal, planning);
    let choice = |aims: &[Aim]| task.choose(aims, last_failed_kick);
    let possible = choice(&scoring).or_else(|| choice(&aim::open(goal, planning)));
    possible
        .or_else(|| Task { situation: &situation.without_obstacles(), ..task }.choose(&scoring, None))
        .unwrap_or(go_round)
}

/// Inputs of a plan.
#[derive(Clone, Copy)]
struct Task<'a> {
    situation: &'a Situation,
    kicks: &'a Kicks,
    planning: &'a Planning,
    clearance: &'a Clearance,
}

impl Task<'_> {
    /// The cheapest kick that needs a small turn; otherwise the path around the ball to the cheapest one.
    #[inline(never)]
    fn choose(&self, aims: &[Aim], last_failed_kick: Option<Kick>) -> Option<Plan> {
        let mut best = (f32::INFINITY, None);
        for aim in aims {
            for kick in Kick::ALL {
                let again = if last_failed_kick == Some(kick) { self.planning.repetition_cost } else { 0.0 };
                if let Some((effort, plan)) = self.weigh(aim, kick, again, best.0) {
                    best = (effort, Some(plan));
                }
            }
        }
        best.1
    }

    /// Plan for a kick and its cost, rad of turning; `None` if the cost is not below `limit`, or an obstacle prevents the kick.
    fn weigh(&self, aim: &Aim, kick: Kick, again: f32, limit: f32) -> Option<(f32, Plan)> {
        let Self { situation, kicks, planning, clearance } = *self;
        let path = aim.at - situation.ball;
        let turn = wrap(atan2f(path.y, path.x) - kick.direction());
        let cost = aim.cost + planning.kick_cost(kick) + again;
        let is_near = fabsf(turn) < planning.max_alignment;
        let least = if is_near {
            fabsf(turn) + cost
        } else {
            planning.circling_cost + fabsf(turn) + planning.circling_weight * cost
        };
        let stand = || situation.ball - rotate(kick.ball(kicks), turn);
        let obstacles = &situation.obstacles;
        if least >= limit
            || !obstacles.allow_kick(situation.ball, path, clearance)
            || !obstacles.allow_stand(stand(), clearance)
        {
            return None;
        }
        if is_near {
            return Some((least, Plan::Kick(Strike { kick, heading: turn })));
        }
        let round = situation.way_round(turn, clearance)?;
        let effort = least - fabsf(turn) + fabsf(round);
        (effort < limit).then_some((effort, Plan::GoRound(round)))
    }
}

impl Plan {
    /// The kick; `None` for a walk around the ball.
    #[must_use]
    pub const fn kick(self) -> Option<Strike> {
        match self {
            Self::Kick(strike) => Some(strike),
            Self::GoRound(_) => None,
        }
    }

    /// The turn of a walk around the ball, rad to the left; `None` for a kick.
    #[must_use]
    pub const fn turn(self) -> Option<f32> {
        match self {
            Self::Kick(_) => None,
            Self::GoRound(angle) => Some(angle),
        }
    }
}

impl Strike {
    /// The same strike with its heading in a frame in which the body has this heading, rad.
    #[must_use]
    pub fn in_frame(self, heading: f32) -> Self {
        Self { heading: self.heading + heading, ..self }
    }
}

#[cfg(test)]
mod tests {
    use core::f32::consts::{FRAC_PI_2, PI};

    use bica::prelude::*;
    use bica_field::FIELD;
    use bica_motion::kick::KickKind;
    use bica_motion::model::NAO;
    use glam::Vec2;

    use super::obstacles::{Obstacle, Obstacles};
    use super::situation::Goal;
    use super::*;

    const KICKS: Kicks = NAO.dynamic_profile.kicks;
    const BALL: Vec2 = Vec2::new(0.3, 0.0);

    /// A situation with the two posts of a goal, given by its middle and heading, and robots at these positions, m.
    fn situation(ball: Vec2, middle: Vec2, heading: f32, gap: Option<f32>, robots: &[Vec2]) -> Situation {
        let across = rotate(Vec2::Y, heading);
        let post = |side: f32| Obstacle { at: middle + 0.7 * side * across, radius: 0.05 };
        let robots = robots.iter().map(|&at| Obstacle { at, radius: 0.12 });
        let obstacles = Obstacles([post(1.0), post(-1.0)].into_iter().chain(robots).collect());
        Situation { ball, goal: Some(Goal { middle, across, gap, width: FIELD.goal_width() }), obstacles }
    }

    fn default_plan(situation: &Situation, kicks: &Kicks, last_failed_kick: Option<Kick>) -> Plan {
        plan(situation, kicks, last_failed_kick, &Planning::DEFAULT, &Clearance::DEFAULT)
    }

    fn kick(situation: &Situation) -> (Strike, Vec2, Vec2) {
        let Plan::Kick(strike) = default_plan(situation, &KICKS, None) else {
            panic!("a kick was expected: {situation:?}")
        };
        let stand = situation.ball - rotate(strike.kick.ball(&KICKS), strike.heading);
        (strike, stand, rotate(Vec2::X, strike.heading + strike.kick.direction()))
    }

    #[test]
    fn far_goal_ahead_selects_front_kick() {
        for gap in [-0.4_f32, 0.3] {
            let (strike, _, way) = kick(&situation(BALL, Vec2::new(2.3, 0.0), 0.0, Some(gap), &[]));
            assert_eq!(strike.kick.kind, KickKind::Front);
            assert!((way.to_angle() - (gap / 2.0).atan()).abs() < 0.01, "{strike:?}");
        }
    }

    #[test]
    fn goal_to_side_selects_least_turning() {
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
    fn goal_behind_robot_needs_path_around_ball() {
        let behind = situation(BALL, Vec2::new(-2.0, 0.0), PI, Some(0.0), &[]);
        assert!(matches!(default_plan(&behind, &KICKS, None), Plan::GoRound(angle) if angle.abs() > 3.0));
        let unknown = Situation { goal: None, ..behind };
        assert_eq!(default_plan(&unknown, &KICKS, None), Plan::GoRound(Planning::DEFAULT.unknown_goal_turn));
    }

    #[test]
    fn ball_at_keepers_foot_is_kicked_past_it() {
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
    fn ball_beside_post_is_kicked_before_goal() {
        let beside = situation(BALL, Vec2::new(0.32, 0.88), 0.0, Some(0.0), &[]);
        let Plan::GoRound(angle) = default_plan(&beside, &KICKS, None) else { panic!("the turn is too large") };
        let turned = rotate(BALL, -angle);
        let after = situation(turned, rotate(Vec2::new(0.32, 0.88), -angle), -angle, Some(0.0), &[]);
        let (_, stand, way) = kick(&after);
        let way = rotate(way, angle);
        assert!(way.x < -0.3 && way.y > 0.3, "into the field, towards the middle of the goal: {way}");
        assert!(after.obstacles.allow_stand(stand, &Clearance::DEFAULT));
    }

    #[test]
    fn failed_kick_is_not_repeated() {
        let at_goal = situation(BALL, Vec2::new(0.8, 0.0), 0.0, Some(0.0), &[]);
        let (first, ..) = kick(&at_goal);
        let Plan::Kick(second) = default_plan(&at_goal, &KICKS, Some(first.kick)) else { panic!("a kick") };
        assert_ne!(first.kick, second.kick);
    }

    #[test]
    fn path_around_ball_avoids_other_robots() {
        for side in [1.0, -1.0] {
            let goal = (Vec2::new(-2.0, 0.3 * side), PI);
            let Plan::GoRound(short) = default_plan(&situation(BALL, goal.0, goal.1, Some(0.0), &[]), &KICKS, None)
            else {
                panic!("far")
            };
            // A turn to the left leads round the right side of the ball.
            let robot = BALL + Vec2::new(0.0, -0.3 * short.signum());
            let Plan::GoRound(long) = default_plan(&situation(BALL, goal.0, goal.1, Some(0.0), &[robot]), &KICKS, None)
            else {
                panic!("far")
            };
            assert!(long * short < 0.0, "{short} {long}");
        }
    }

    #[test]
    fn surrounded_ball_ignores_robots() {
        let ring: [Vec2; 4] = core::array::from_fn(|i| BALL + 0.2 * Vec2::from_angle(i as f32 * FRAC_PI_2));
        let goal = Vec2::new(2.0, 0.0);
        let free = default_plan(&situation(BALL, goal, 0.0, Some(0.0), &[]), &KICKS, None);
        assert_eq!(default_plan(&situation(BALL, goal, 0.0, Some(0.0), &ring), &KICKS, None), free);
    }

    #[test]
    fn costs_and_limits_of_planning_decide_between_kicks() {
        let aside = situation(BALL, BALL + 2.0 * Vec2::from_angle(0.8), 0.8, Some(0.0), &[]);
        let with = |planning: &Planning| plan(&aside, &KICKS, None, planning, &Clearance::DEFAULT);
        let kind = |plan| if let Plan::Kick(strike) = plan { Some(strike.kick.kind) } else { None };
        assert_eq!(kind(with(&Planning::DEFAULT)), Some(KickKind::Diagonal));
        let front = Planning { diagonal_cost: 3.0, lateral_cost: 3.0, max_alignment: 1.0, ..Planning::DEFAULT };
        assert_eq!(kind(with(&front)), Some(KickKind::Front));
        let unknown = Situation { goal: None, ..aside.clone() };
        let planning = Planning { unknown_goal_turn: -1.0, ..Planning::DEFAULT };
        assert_eq!(plan(&unknown, &KICKS, None, &planning, &Clearance::DEFAULT), Plan::GoRound(-1.0));
    }

    #[test]
    fn larger_clearance_blocks_a_kick() {
        let robot = BALL + Vec2::new(0.4, 0.25);
        let ahead = situation(BALL, Vec2::new(2.3, 0.0), 0.0, Some(0.0), &[robot]);
        let with = |clearance: &Clearance| plan(&ahead, &KICKS, None, &Planning::DEFAULT, clearance);
        let free = with(&Clearance::DEFAULT);
        assert_ne!(with(&Clearance { ball_path_radius: 0.2, ..Clearance::DEFAULT }), free);
    }
}
