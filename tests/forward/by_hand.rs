//! Tests of components that an operator holds active and modulates, while the root is latent.

use bica::Value;
use bica::prelude::*;
use bica_motion::joints::Joint;
use bica_motion::pose::{Pose2, wrap};
use bica_player::Forward;
use bica_player::behaviour::{FaceBall, Fixmove, Player, SearchBall};
use bica_player::motion::{Body, GoStraight, Head, Kicker, Turn};
use bica_player::perception::BallDetector;
use bica_sim::World;
use bica_sim::referee::Event;
use bica_sim::setup::{Setup, Start};
use glam::Vec2;

use crate::forward::game::{Game, new_game};

/// Game in which an operator holds the root latent.
struct ByHand(Game);

impl ByHand {
    fn new(start: Option<Start>) -> Self {
        let mut game = new_game(&Setup { seed: 4, goalkeeper: false, start, ..Setup::default() });
        game.robot_mut().of_mut::<Player>().hold(Hold::Latent);
        Self(game)
    }

    fn hold<C: 'static>(&mut self, hold: Hold)
    where
        Forward: Has<C>,
    {
        self.0.robot_mut().of_mut::<C>().hold(hold);
    }

    /// Calls a modulation by the name that operators use.
    fn modulate<C: 'static>(&mut self, name: &str, arguments: &[Value])
    where
        Forward: Has<C>,
    {
        let called = self.0.robot_mut().modulate(Forward::id::<C>(), name, arguments);
        called.unwrap_or_else(|refusal| panic!("{refusal}"));
    }

    fn run(&mut self, seconds: f32) {
        for _ in 0..(100.0 * seconds) as usize {
            self.0.cycle().expect("the image fits");
        }
    }

    fn robot(&self) -> &Forward {
        self.0.robot()
    }

    fn pose(&self) -> Pose2 {
        self.0.world().referee().robot()
    }

    /// Motion over the ground in some seconds, in the robot's frame at their start.
    fn motion(&mut self, seconds: f32) -> Pose2 {
        let before = self.pose();
        self.run(seconds);
        before.inverse() * self.pose()
    }

    fn kicks(&self) -> usize {
        self.0.world().referee().count(|event| matches!(event, Event::Kick { .. }))
    }
}

#[test]
fn head_follows_its_modulation_in_the_next_cycle() {
    let mut hand = ByHand::new(None);
    hand.hold::<Head>(Hold::Active);
    hand.run(0.1);
    hand.modulate::<Head>("look_at", &[Value::F32(-0.6), Value::F32(0.2)]);
    let command = hand.0.cycle().expect("the image fits");
    assert!(command.targets[Joint::HeadYaw] < 0.0 && command.targets[Joint::HeadPitch] > 0.0);
    hand.run(1.0);
    assert!(hand.robot().get::<Head>().arrived());
    assert!((hand.robot().get::<Head>().pan() + 0.6).abs() < 1e-3);
}

#[test]
fn turn_and_go_straight_need_no_body() {
    let mut hand = ByHand::new(None);
    hand.hold::<Turn>(Hold::Active);
    hand.modulate::<Turn>("set_speed", &[Value::F32(-0.5)]);
    let turned = hand.motion(2.0).heading;
    assert!((-1.0..-0.6).contains(&turned), "{turned}");
    assert!(!hand.robot().of::<Body>().is_active());

    let mut hand = ByHand::new(None);
    hand.hold::<GoStraight>(Hold::Active);
    hand.modulate::<GoStraight>("set_speed", &[Value::F32(0.15), Value::F32(0.0)]);
    let moved = hand.motion(3.0).position;
    assert!((0.2..0.45).contains(&moved.x) && moved.y.abs() < 0.05, "{moved}");
}

#[test]
fn a_speed_does_not_outlast_the_hold() {
    let mut hand = ByHand::new(None);
    hand.hold::<Turn>(Hold::Active);
    hand.modulate::<Turn>("set_speed", &[Value::F32(0.5)]);
    hand.run(0.1);
    hand.hold::<Turn>(Hold::Tree);
    hand.run(0.1);
    assert_eq!(hand.robot().get::<Turn>().speed().to_bits(), 0.0_f32.to_bits());
}

#[test]
fn the_body_walks_in_each_way_and_stands() {
    let mut hand = ByHand::new(None);
    hand.hold::<Body>(Hold::Active);
    hand.run(0.1);
    assert!(hand.robot().get::<Body>().is_still());
    hand.modulate::<Body>("walk", &[Value::F32(0.0), Value::F32(0.08), Value::F32(0.0)]);
    let moved = hand.motion(3.0).position;
    assert!(moved.y > 0.1 && moved.x.abs() < 0.05, "to the left: {moved}");
    hand.modulate::<Body>("turn", &[Value::F32(0.6)]);
    let turned = hand.motion(2.0).heading;
    assert!(turned > 0.6, "{turned}");
    hand.modulate::<Body>("go", &[Value::F32(0.1), Value::F32(0.0)]);
    hand.run(1.0);
    assert_eq!(hand.robot().of::<Body>().state_name(), Some("going"));
    hand.modulate::<Body>("stand", &[]);
    hand.run(2.0);
    assert!(hand.robot().get::<Body>().is_still());
}

#[test]
fn the_body_swings_a_foot_through_the_ball() {
    let robot = Pose2::ORIGIN;
    let mut hand = ByHand::new(Some(Start { robot, ball: Vec2::new(0.22, 0.05) }));
    hand.hold::<Body>(Hold::Active);
    hand.run(0.5);
    hand.modulate::<Body>("swing", &[Value::Choice(0)]);
    hand.modulate::<Body>("walk", &[Value::F32(0.1), Value::F32(0.0), Value::F32(0.0)]);
    hand.run(2.0);
    let ball = hand.0.world().referee().ball();
    assert!(ball.x > 0.4, "{ball}");
}

#[test]
fn the_kicker_plays_one_kick_after_another() {
    let mut hand = ByHand::new(None);
    hand.hold::<Kicker>(Hold::Active);
    hand.run(0.1);
    for foot in [0, 1] {
        hand.modulate::<Kicker>("kick", &[Value::Choice(0), Value::Choice(foot)]);
        let requested = hand.robot().get::<Kicker>().requested().map(|kick| kick.foot.index() as u32);
        assert_eq!((requested, hand.robot().get::<Kicker>().done()), (Some(foot), false));
        hand.modulate::<Kicker>("kick", &[Value::Choice(2), Value::Choice(0)]);
        hand.run(3.0);
        assert!(hand.robot().get::<Kicker>().done());
        let played = hand.robot().get::<Kicker>().requested().map(|kick| kick.foot.index() as u32);
        assert_eq!(played, Some(foot), "a request during a kick has no effect");
    }
    assert_eq!(hand.0.world().referee().falls(), 0);
}

#[test]
fn fixmove_kicks_once_for_each_modulation() {
    let start = Start { robot: Pose2::ORIGIN, ball: Vec2::new(0.25, 0.05) };
    let mut hand = ByHand::new(Some(start));
    hand.hold::<SearchBall>(Hold::Active);
    hand.run(1.0);
    assert!(hand.robot().get::<BallDetector>().position().is_some(), "the ball is in front of the feet");
    hand.hold::<SearchBall>(Hold::Tree);
    hand.hold::<FaceBall>(Hold::Active);
    hand.hold::<Fixmove>(Hold::Active);
    hand.run(0.5);
    assert_eq!(hand.kicks(), 0);
    hand.modulate::<Fixmove>("kick", &[Value::Choice(0), Value::Choice(0), Value::F32(0.0)]);
    hand.run(0.1);
    assert!(hand.robot().get::<Fixmove>().error().is_some());
    hand.run(9.0);
    assert_eq!((hand.kicks(), hand.robot().of::<Fixmove>().state_name()), (1, Some("over")));
    hand.modulate::<Fixmove>("kick", &[Value::Choice(1), Value::Choice(1), Value::F32(0.0)]);
    hand.run(0.1);
    assert_eq!(hand.robot().of::<Fixmove>().state_name(), Some("align"));
}

#[test]
fn search_begins_on_the_modulated_side() {
    let mut hand = ByHand::new(None);
    hand.hold::<BallDetector>(Hold::Latent);
    hand.hold::<SearchBall>(Hold::Active);
    hand.run(0.1);
    hand.modulate::<SearchBall>("search_side", &[Value::Choice(1)]);
    let mut first_pan = 0.0;
    while first_pan == 0.0 {
        hand.run(0.02);
        first_pan = hand.robot().get::<Head>().target().yaw;
    }
    assert!(first_pan < 0.0, "the right side first: {first_pan}");
    hand.modulate::<SearchBall>("search_elsewhere", &[]);
    hand.run(0.05);
    assert_eq!(hand.robot().of::<SearchBall>().state_name(), Some("find_path"));
    let turned = wrap(hand.motion(1.0).heading);
    assert!(turned < -0.2, "it turns to the right as well: {turned}");
}
