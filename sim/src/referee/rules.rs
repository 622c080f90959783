//! Rules of the game: goals, outs, and which contacts count as a touch, a kick or a collision. Common to both simulators.

use core::time::Duration;

use bica_motion::pose::rotate;
use bica_motion::side::Side;
use glam::Vec2;

use super::verdict::{Verdict, judge};
use crate::referee::{Event, Referee};

/// Minimum speed of the ball after a kick, m/s.
const KICK_SPEED: f32 = 0.5;
/// Time after the end of a contact within which its kick is detected.
const KICK_WINDOW: Duration = Duration::from_millis(10);
/// Minimum time without contact between two events of the same kind.
const EVENT_SEPARATION: Duration = Duration::from_millis(500);
/// Time from a ball out to its return into play.
const OUT_PAUSE: Duration = Duration::from_secs(1);
/// Time from a goal to the next kick-off.
const GOAL_PAUSE: Duration = Duration::from_secs(3);

/// State of the rules; advanced once per control cycle.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rules {
    /// Time and place of the return of a ball that is out of play.
    pending_return: Option<(Duration, Vec2)>,
    last_touch: Option<(Duration, Side)>,
    last_kick: Option<Duration>,
    last_collision: Option<Duration>,
}

impl Rules {
    /// Records a contact of the robot with an obstacle.
    pub(crate) fn record_collision(&mut self, now: Duration, referee: &mut Referee) {
        if is_new(now, self.last_collision) {
            referee.record(now, Event::Collision);
        }
        self.last_collision = Some(now);
    }

    /// Records which foot touches the ball in this cycle, if any; `speed`: of the ball at the end of the cycle, m/s.
    pub(crate) fn record_touch(&mut self, now: Duration, touching: Option<Side>, speed: f32, referee: &mut Referee) {
        if let Some(foot) = touching {
            if is_new(now, self.last_touch.map(|(at, _)| at)) {
                referee.record(now, Event::Touch { foot });
            }
            self.last_touch = Some((now, foot));
            return;
        }
        let Some((at, foot)) = self.last_touch else { return };
        let just_left = now.saturating_sub(at) <= KICK_WINDOW;
        if just_left && speed >= KICK_SPEED && is_new(now, self.last_kick) {
            referee.record(now, Event::Kick { foot, speed });
            self.last_kick = Some(now);
        }
    }

    /// Applies the rules to the position of the ball. Returns its new position if it returns into play in this cycle.
    pub(crate) fn apply(&mut self, now: Duration, ball: Vec2, referee: &mut Referee) -> Option<Vec2> {
        if let Some((when, at)) = self.pending_return {
            if now < when {
                return None;
            }
            self.pending_return = None;
            referee.record(now, Event::BallPlaced { at });
            return Some(at);
        }
        let (event, pause, at) = match judge(ball) {
            Verdict::InPlay => return None,
            Verdict::Goal => (Event::Goal, GOAL_PAUSE, Vec2::ZERO),
            Verdict::OwnGoal => (Event::OwnGoal, GOAL_PAUSE, Vec2::ZERO),
            Verdict::Out(at) => (Event::BallOut, OUT_PAUSE, at),
        };
        referee.record(now, event);
        self.pending_return = Some((now + pause, free_place(at, referee)));
        None
    }
}

/// Returns whether the last contact of the kind is so long ago that this one is a new event.
fn is_new(now: Duration, last: Option<Duration>) -> bool {
    last.is_none_or(|last| now.saturating_sub(last) >= EVENT_SEPARATION)
}

/// Returns `at`, or a place beside it if a robot stands there.
fn free_place(at: Vec2, referee: &Referee) -> Vec2 {
    const CLEARANCE: f32 = 0.3;
    let robots = || referee.others().iter().copied().chain([referee.robot()]);
    let free = |place: &Vec2| robots().all(|robot| robot.position.distance(*place) > CLEARANCE);
    let around = (0..8).map(|eighth| at - rotate(at.normalize_or(Vec2::X), eighth as f32 * 0.785) * 2.0 * CLEARANCE);
    core::iter::once(at).chain(around).find(free).unwrap_or(at)
}
