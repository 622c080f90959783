//! What the rules make of the ball's way, and what counts as a touch, a kick or a collision; the same in every world.

use core::time::Duration;

use bica_motion::pose::rotate;
use bica_motion::side::Side;
use glam::Vec2;

use crate::referee::{Event, Referee};
use crate::verdict::{Verdict, judge};

/// A ball that leaves a foot this fast was kicked, m/s.
const KICKED: f32 = 0.5;
/// A kick is known within this after the contact.
const LEAVING: Duration = Duration::from_millis(10);
/// Contacts within this of each other are one.
const SAME_TOUCH: Duration = Duration::from_millis(500);
/// From the ball's leaving the field to its coming back.
const OUT_PAUSE: Duration = Duration::from_secs(1);
/// From a goal to the next kick-off.
const GOAL_PAUSE: Duration = Duration::from_secs(3);

/// The rules, applied cycle by cycle.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rules {
    /// Where and when the ball comes back, while it is out.
    comes_back: Option<(Duration, Vec2)>,
    last_touch: Option<(Duration, Side)>,
    last_kick: Option<Duration>,
    last_collision: Option<Duration>,
}

impl Rules {
    /// Notes that the robot ran into something.
    pub(crate) fn note_collision(&mut self, now: Duration, referee: &mut Referee) {
        if long_ago(now, self.last_collision) {
            referee.record(now, Event::Collision);
        }
        self.last_collision = Some(now);
    }

    /// Notes which foot touches the ball in this cycle, if any, and how fast the ball is at its end, m/s.
    pub(crate) fn note_touch(&mut self, now: Duration, touching: Option<Side>, speed: f32, referee: &mut Referee) {
        if let Some(foot) = touching {
            if long_ago(now, self.last_touch.map(|(at, _)| at)) {
                referee.record(now, Event::Touch { foot });
            }
            self.last_touch = Some((now, foot));
            return;
        }
        let Some((at, foot)) = self.last_touch else { return };
        let just_left = now.saturating_sub(at) <= LEAVING;
        if just_left && speed >= KICKED && long_ago(now, self.last_kick) {
            referee.record(now, Event::Kick { foot, speed });
            self.last_kick = Some(now);
        }
    }

    /// Judges by where the ball is. Says where it is to be put, if it comes back into play in this cycle.
    pub(crate) fn apply(&mut self, now: Duration, ball: Vec2, referee: &mut Referee) -> Option<Vec2> {
        if let Some((when, at)) = self.comes_back {
            if now < when {
                return None;
            }
            self.comes_back = None;
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
        self.comes_back = Some((now + pause, free_place(at, referee)));
        None
    }
}

fn long_ago(now: Duration, last: Option<Duration>) -> bool {
    last.is_none_or(|last| now.saturating_sub(last) >= SAME_TOUCH)
}

/// The place itself, or one beside it if a robot is there.
fn free_place(at: Vec2, referee: &Referee) -> Vec2 {
    const ROOM: f32 = 0.3;
    let robots = || referee.others().iter().copied().chain([referee.robot()]);
    let free = |place: &Vec2| robots().all(|robot| robot.position.distance(*place) > ROOM);
    let around = (0..8).map(|eighth| at - rotate(at.normalize_or(Vec2::X), eighth as f32 * 0.785) * 2.0 * ROOM);
    core::iter::once(at).chain(around).find(free).unwrap_or(at)
}
