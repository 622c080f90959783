//! The ball's way through a cycle, and what the rules make of it.

use core::time::Duration;

use bica_motion::pose::rotate;
use bica_motion::side::Side;
use glam::{Affine3A, Vec2};

use super::ball::Ball;
use super::obstacle::Obstacle;
use super::pitch::{Verdict, judge};
use super::shoe::Shoe;
use crate::referee::{Event, Referee};
use crate::world::CYCLE_SECONDS;

/// The ball moves in this many steps per cycle, so that nothing fast passes through.
const SUB_STEPS: u32 = 10;
/// A ball that leaves a foot this fast was kicked, m/s.
const KICKED: f32 = 0.5;
/// Contacts within this of each other are one.
const SAME_TOUCH: Duration = Duration::from_millis(500);
/// From the ball's leaving the field to its coming back.
const OUT_PAUSE: Duration = Duration::from_secs(1);
/// From a goal to the next kick-off.
const GOAL_PAUSE: Duration = Duration::from_secs(3);

/// The ball and its story.
#[derive(Clone, Debug)]
pub(crate) struct Game {
    pub(crate) ball: Ball,
    /// Where and when the ball comes back, while it is out.
    comes_back: Option<(Duration, Vec2)>,
    last_touch: Option<(Duration, Side)>,
    last_kick: Option<Duration>,
    last_collision: Option<Duration>,
}

impl Game {
    pub(crate) const fn new(ball: Ball) -> Self {
        Self { ball, comes_back: None, last_touch: None, last_kick: None, last_collision: None }
    }

    /// Moves the ball for one cycle among what stands still and both soles on their way, left first.
    pub(crate) fn step(
        &mut self,
        now: Duration,
        soles: [(Affine3A, Affine3A); 2],
        obstacles: &[Obstacle],
        referee: &mut Referee,
    ) {
        let shoes = Side::BOTH.map(|side| {
            let (from, to) = &soles[side.index()];
            (side, Shoe::new(side, from, to, CYCLE_SECONDS))
        });
        let touching = self.roll(&shoes, obstacles);
        self.note_touch(now, touching, referee);
        self.apply_rules(now, referee);
        referee.see_ball(self.ball.position, self.ball.velocity);
    }

    /// Notes that the robot ran into something.
    pub(crate) fn note_collision(&mut self, now: Duration, referee: &mut Referee) {
        if self.last_collision.is_none_or(|last| now.saturating_sub(last) >= SAME_TOUCH) {
            referee.note(now, Event::Collision);
        }
        self.last_collision = Some(now);
    }

    fn roll(&mut self, shoes: &[(Side, Shoe); 2], obstacles: &[Obstacle]) -> Option<Side> {
        let mut touching = None;
        for step in 1..=SUB_STEPS {
            self.ball.roll(CYCLE_SECONDS / SUB_STEPS as f32);
            for (side, shoe) in shoes {
                if shoe.is_near(self.ball.position) && shoe.push(&mut self.ball, step as f32 / SUB_STEPS as f32) {
                    touching = Some(*side);
                }
            }
            for obstacle in obstacles {
                self.ball.bounce_off(obstacle);
            }
        }
        touching
    }

    fn note_touch(&mut self, now: Duration, touching: Option<Side>, referee: &mut Referee) {
        let long_ago = |last: Option<Duration>| last.is_none_or(|last| now.saturating_sub(last) >= SAME_TOUCH);
        if let Some(foot) = touching {
            if long_ago(self.last_touch.map(|(at, _)| at)) {
                referee.note(now, Event::Touch { foot });
            }
            self.last_touch = Some((now, foot));
            return;
        }
        let Some((at, foot)) = self.last_touch else { return };
        let speed = self.ball.velocity.length();
        let just_left = now.saturating_sub(at) <= Duration::from_millis(10);
        if just_left && speed >= KICKED && long_ago(self.last_kick) {
            referee.note(now, Event::Kick { foot, speed });
            self.last_kick = Some(now);
        }
    }

    fn apply_rules(&mut self, now: Duration, referee: &mut Referee) {
        if let Some((when, at)) = self.comes_back {
            if now >= when {
                self.ball = Ball::at(at, self.ball.braking);
                self.comes_back = None;
                referee.note(now, Event::BallPlaced { at });
            }
            return;
        }
        let (event, pause, at) = match judge(self.ball.position) {
            Verdict::InPlay => return,
            Verdict::Goal => (Event::Goal, GOAL_PAUSE, Vec2::ZERO),
            Verdict::OwnGoal => (Event::OwnGoal, GOAL_PAUSE, Vec2::ZERO),
            Verdict::Out(at) => (Event::BallOut, OUT_PAUSE, at),
        };
        referee.note(now, event);
        self.comes_back = Some((now + pause, free_place(at, referee)));
    }
}

/// The place itself, or one beside it if a robot is there.
fn free_place(at: Vec2, referee: &Referee) -> Vec2 {
    const ROOM: f32 = 0.3;
    let robots = || referee.others().iter().copied().chain([referee.robot()]);
    let free = |place: &Vec2| robots().all(|robot| robot.position.distance(*place) > ROOM);
    let around = (0..8).map(|eighth| at - rotate(at.normalize_or(Vec2::X), eighth as f32 * 0.785) * 2.0 * ROOM);
    core::iter::once(at).chain(around).find(free).unwrap_or(at)
}
