//! Which kick, and where to: decided once for each kick, at the ball.

use bica_motion::kick::{Kick, KickKind};
use bica_motion::pose::wrap;
use glam::Vec2;
use libm::{atan2f, fabsf};

use crate::perception::{BallDetector, Localization, NetDetector, Odometry};

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
    /// Heading of the body, rad, in the frame of the odometry.
    pub heading: f32,
}

/// Turning farther than this goes round the ball, less is left to the alignment, rad.
const FAR: f32 = 0.6;
/// How far to go round when no goal was seen, rad: it is behind.
const BEHIND: f32 = 2.5;
/// How far beside the goal's middle to aim where the gap is not known, m: the keeper stands in the middle.
const BESIDE: f32 = 0.38;

/// Plans what to do with the ball: the kick that asks for the least turning, if the goal was seen. A goal that was not
/// seen whole is where the place on the field says; one of which nobody knows is behind.
#[must_use]
pub fn plan(ball: &BallDetector, net: &NetDetector, field: &Localization, odometry: &Odometry) -> Plan {
    let Some(ball) = ball.at() else { return Plan::GoRound(BEHIND) };
    let Some((goal, across)) = goal(net, field) else { return Plan::GoRound(BEHIND) };
    let targets = net.gap().map_or([BESIDE, -BESIDE], |gap| [gap; 2]).map(|aside| goal + aside * across);
    let turns = targets.into_iter().flat_map(|target| {
        let direction = heading(target - ball);
        Kick::ALL.into_iter().map(move |kick| (kick, wrap(direction - kick.direction())))
    });
    let effort = |&(kick, turn): &(Kick, f32)| fabsf(turn) + reluctance(kick);
    let best = turns.filter(|&(_, turn)| fabsf(turn) < FAR).min_by(|a, b| effort(a).total_cmp(&effort(b)));
    best.map_or(Plan::GoRound(heading(targets[0] - ball)), |(kick, turn)| {
        Plan::Kick(Strike { kick, heading: odometry.pose().heading + turn })
    })
}

/// The middle of the goal, and the direction from its right post to its left one.
fn goal(net: &NetDetector, field: &Localization) -> Option<(Vec2, Vec2)> {
    let by_place = || field.posts().map(|[left, right]| (left.midpoint(right), (left - right).normalize_or_zero()));
    let seen = net.at().map(|at| (at, net.across()));
    if net.whole() { seen } else { by_place().or(seen.filter(|_| net.found())) }
}

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
    before && way.length() > LONG && fabsf(heading(way)) < ALONG
}

fn heading(way: Vec2) -> f32 {
    atan2f(way.y, way.x)
}

/// What a kick costs beside the turning, rad: the front kick is the surest.
fn reluctance(kick: Kick) -> f32 {
    match kick.kind {
        KickKind::Front => 0.0,
        KickKind::Diagonal => 0.25,
        KickKind::Lateral => 0.4,
    }
}
