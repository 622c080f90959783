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

    /// Cancels the return of a ball that is out of play, because it was placed by other means.
    pub(crate) const fn cancel_return(&mut self) {
        self.pending_return = None;
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

#[cfg(test)]
mod tests {
    use bica_field::GoalColour;
    use bica_motion::pose::Pose2;

    use super::*;

    const fn ms(time: u64) -> Duration {
        Duration::from_millis(time)
    }

    fn referee() -> Referee {
        Referee::new(GoalColour::Yellow, Pose2::new(-2.0, 0.0, 0.0), Vec2::ZERO, Vec::new())
    }

    fn events(referee: &Referee) -> Vec<(u64, Event)> {
        referee.events().iter().map(|timed| (timed.at.as_millis() as u64, timed.event)).collect()
    }

    #[test]
    fn contacts_closer_than_half_second_are_one_touch() {
        for (second, touches) in [(490, 1), (510, 2)] {
            let (mut rules, mut referee) = (Rules::default(), referee());
            rules.record_touch(ms(0), Some(Side::Left), 0.0, &mut referee);
            rules.record_touch(ms(second), Some(Side::Left), 0.0, &mut referee);
            assert_eq!(events(&referee).len(), touches, "second contact after {second} ms");
        }
    }

    #[test]
    fn fast_ball_counts_as_one_kick() {
        for (speed, delay, kicks) in [(0.6, 10, 1), (0.4, 10, 0), (0.6, 20, 0)] {
            let (mut rules, mut referee) = (Rules::default(), referee());
            rules.record_touch(ms(0), Some(Side::Right), speed, &mut referee);
            rules.record_touch(ms(delay), None, speed, &mut referee);
            rules.record_touch(ms(delay), None, speed, &mut referee);
            let kick = Event::Kick { foot: Side::Right, speed };
            assert_eq!(referee.count(|event| *event == kick), kicks, "{speed} m/s after {delay} ms");
        }
    }

    #[test]
    fn ball_returns_after_out_and_after_goal() {
        let cases = [
            (Vec2::new(3.2, 0.0), Event::Goal, 3_000, Vec2::ZERO),
            (Vec2::new(-3.2, 0.0), Event::OwnGoal, 3_000, Vec2::ZERO),
            (Vec2::new(0.5, 2.1), Event::BallOut, 1_000, Vec2::new(0.5, 1.6)),
        ];
        for (ball, event, pause, place) in cases {
            let (mut rules, mut referee) = (Rules::default(), referee());
            assert_eq!(rules.apply(ms(0), ball, &mut referee), None);
            assert_eq!(rules.apply(ms(pause - 10), ball, &mut referee), None);
            assert_eq!(rules.apply(ms(pause), ball, &mut referee), Some(place));
            assert_eq!(events(&referee), [(0, event), (pause, Event::BallPlaced { at: place })]);
        }
    }

    #[test]
    fn ball_returns_beside_robot_in_its_place() {
        let (mut rules, mut referee) = (Rules::default(), referee());
        let place = Vec2::new(0.5, 1.6);
        referee.set_robot(Pose2 { position: place, heading: 0.0 }, crate::referee::Posture::Upright);
        let _ = rules.apply(ms(0), Vec2::new(0.5, 2.1), &mut referee);
        let at = rules.apply(ms(1_000), Vec2::new(0.5, 2.1), &mut referee).unwrap();
        assert!((at.distance(place) - 0.6).abs() < 1e-5 && at.length() < place.length(), "{at}");
    }
}
