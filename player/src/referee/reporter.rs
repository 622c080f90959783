//! The status messages of the player.

use bica::prelude::*;
use bica_motion::pose::Pose2;
use glam::Vec2;

use super::packet::{BallReport, Status};
use super::{Answer, FieldPose, GameController};
use crate::perception::{BallDetector, FallDetector, Odometry};

/// Time between two messages, s: the `GameController` expects 0.5 to 2 Hz.
const PERIOD: f32 = 1.0;

/// Writes a status message for the `GameController` each second, from its first packet on, in all states.
#[derive(Debug)]
pub struct Reporter {
    answer: Option<Answer>,
    /// Time since the last message, s.
    waited: f32,
    /// The ball when it was last seen: m, frame of the odometry; with the time since then, s.
    ball: Option<(Vec2, f32)>,
    messages: u32,
}

#[component(budget_us = 5)]
impl Reporter {
    /// Creates the component before the first message.
    #[must_use]
    pub const fn new() -> Self {
        Self { answer: None, waited: PERIOD, ball: None, messages: 0 }
    }

    fn step(
        &mut self,
        time: &Time,
        game: &GameController,
        field: &FieldPose,
        ball: &BallDetector,
        odometry: &Odometry,
        falls: &FallDetector,
    ) {
        self.waited += time.dt();
        let aged = self.ball.map(|(at, age)| (at, age + time.dt()));
        let seen = ball.position().filter(|_| ball.is_confirmed());
        self.ball = seen.map(|at| (odometry.pose().place(at), 0.0)).or(aged);
        let Some(to) = game.source().filter(|_| self.waited >= PERIOD) else { return };
        // The grid stays exact, unless the robot was late by more than a message.
        self.waited = if self.waited < 2.0 * PERIOD { self.waited - PERIOD } else { 0.0 };
        let Pose2 { position, heading } = field.pose().unwrap_or_default();
        let report = |(at, age)| BallReport { age, at: odometry.pose().locate(at).into() };
        self.answer = Some(Answer {
            to,
            status: Status {
                player: game.me().player,
                team: game.me().team,
                fallen: falls.is_down(),
                pose: [position.x, position.y, heading],
                ball: self.ball.map(report),
            },
        });
        self.messages = self.messages.saturating_add(1);
    }

    /// Takes the message of this cycle, if there is one.
    pub const fn take(&mut self) -> Option<Answer> {
        self.answer.take()
    }

    /// Number of messages so far.
    #[output]
    #[must_use]
    pub const fn messages(&self) -> u32 {
        self.messages
    }
}

#[cfg(test)]
mod tests {
    use super::super::packet::{Control, Team};
    use super::super::{Identity, Received};
    use super::*;
    use crate::behaviour::test_time;

    fn run(reporter: &mut Reporter, game: &GameController, ball: &BallDetector) -> Option<Answer> {
        let field = FieldPose::at(Pose2::new(-1.0, 0.5, 0.2));
        reporter.step(&test_time(10), game, &field, ball, &Odometry::new(), &FallDetector::new());
        reporter.take()
    }

    fn commanded() -> GameController {
        let teams = [5, 23].map(|number| Team { number, ..Team::default() });
        let control = Control { teams, ..Control::default() };
        let packet = Received { control, source: [10, 0, 1, 1], at_us: 0 };
        let mut game = GameController::new();
        game.receive(Identity { team: 23, player: 4 }, Some(&packet), 0);
        game
    }

    #[test]
    fn messages_begin_with_the_first_packet_at_one_hertz() {
        let (mut reporter, ball) = (Reporter::new(), BallDetector::new());
        let silent = GameController::new();
        assert!((0..500).all(|_| run(&mut reporter, &silent, &ball).is_none()));
        let game = commanded();
        let sent: Vec32 = (0..1000_u32).filter(|_| run(&mut reporter, &game, &ball).is_some()).collect();
        assert!(sent[0] == 0 && (9..=11).contains(&sent.len()), "{sent:?}");
        assert!(sent.windows(2).skip(1).all(|pair| (99..=101).contains(&(pair[1] - pair[0]))), "{sent:?}");
    }

    type Vec32 = heapless::Vec<u32, 64>;

    #[test]
    fn message_has_identity_pose_and_ball() {
        let mut reporter = Reporter::new();
        let Answer { to, status } = run(&mut reporter, &commanded(), &BallDetector::new()).expect("the first message");
        assert_eq!(to, [10, 0, 1, 1]);
        assert_eq!((status.team, status.player, status.fallen), (23, 4, false));
        assert_eq!((status.pose, status.ball), ([-1.0, 0.5, 0.2], None));
        reporter.ball = Some((Vec2::new(0.5, 0.1), 2.0));
        reporter.waited = PERIOD;
        let status = run(&mut reporter, &commanded(), &BallDetector::new()).expect("a message").status;
        let ball = status.ball.expect("it was seen");
        assert!((2.0..2.1).contains(&ball.age), "{ball:?}");
        assert!(Vec2::from(ball.at).distance(Vec2::new(0.5, 0.1)) < 1e-6, "{ball:?}");
    }
}
