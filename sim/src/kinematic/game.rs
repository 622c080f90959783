//! The ball's way through a cycle.

use core::time::Duration;

use bica_motion::side::Side;
use glam::Affine3A;

use super::ball::Ball;
use super::foot_contact::FootContact;
use crate::obstacle::Obstacle;
use crate::referee::Referee;
use crate::referee::rules::Rules;
use crate::world::CYCLE_SECONDS;

/// The ball moves in this many steps per cycle, so that nothing fast passes through.
const SUB_STEPS: u32 = 10;

/// The ball and its story.
#[derive(Clone, Debug)]
pub(crate) struct Game {
    pub(crate) ball: Ball,
    pub(crate) rules: Rules,
}

impl Game {
    pub(crate) fn new(ball: Ball) -> Self {
        Self { ball, rules: Rules::default() }
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
            (side, FootContact::new(side, from, to, CYCLE_SECONDS))
        });
        let touching = self.roll(&shoes, obstacles);
        self.rules.note_touch(now, touching, self.ball.velocity.length(), referee);
        if let Some(place) = self.rules.apply(now, self.ball.position, referee) {
            self.ball = Ball::at(place, self.ball.braking);
        }
        referee.set_ball(self.ball.position, self.ball.velocity);
    }

    fn roll(&mut self, shoes: &[(Side, FootContact); 2], obstacles: &[Obstacle]) -> Option<Side> {
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
}
