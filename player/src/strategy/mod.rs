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
pub fn plan(situation: &Situation, kicks: &Kicks, in_vain: Option<Kick>) -> Plan {
    let Some(goal) = &situation.goal else { return Plan::GoRound(BEHIND) };
    let choice = |aims: &[Aim]| choose(situation, aims, kicks, in_vain);
    let possible = choice(&aim::scoring(goal)).or_else(|| choice(&aim::open(goal)));
    possible.or_else(|| choose(&situation.alone(), &aim::scoring(goal), kicks, None)).unwrap_or(Plan::GoRound(BEHIND))
}

/// A kick that is possible.
#[derive(Clone, Copy)]
struct Choice {
    kick: Kick,
    /// The body has to turn by this, rad.
    turn: f32,
    /// What it costs beside the turning, rad.
    cost: f32,
}

/// The cheapest kick that is possible with little turning; else the cheapest that is possible from round the ball.
fn choose(situation: &Situation, aims: &[Aim], kicks: &Kicks, in_vain: Option<Kick>) -> Option<Plan> {
    let choices =
        || aims.iter().flat_map(|aim| Kick::ALL.map(|kick| choice(situation, aim, kick, kicks, in_vain))).flatten();
    let near = choices().filter(|choice| fabsf(choice.turn) < FAR);
    if let Some(Choice { kick, turn, .. }) = least(near, |choice| fabsf(choice.turn) + choice.cost) {
        return Some(Plan::Kick(Strike { kick, heading: turn }));
    }
    let round = choices().filter_map(|choice| Some(Choice { turn: situation.way_round(choice.turn)?, ..choice }));
    least(round, |choice| fabsf(choice.turn) + CHOICE * choice.cost).map(|choice| Plan::GoRound(choice.turn))
}

fn choice(situation: &Situation, aim: &Aim, kick: Kick, kicks: &Kicks, in_vain: Option<Kick>) -> Option<Choice> {
    let way = aim.at - situation.ball;
    let turn = wrap(atan2f(way.y, way.x) - kick.direction());
    let stand = situation.ball - rotate(kick.ball(kicks), turn);
    let again = if in_vain == Some(kick) { IN_VAIN } else { 0.0 };
    let possible = situation.obstacles.lets_stand(stand) && situation.obstacles.lets_pass(situation.ball, way);
    possible.then_some(Choice { kick, turn, cost: aim.cost + reluctance(kick) + again })
}

fn least(choices: impl Iterator<Item = Choice>, effort: impl Fn(&Choice) -> f32) -> Option<Choice> {
    choices.min_by(|a, b| effort(a).total_cmp(&effort(b)))
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
