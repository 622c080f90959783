//! When a player sends.

use bica_motion::fall::FallState;
use bica_motion::pose::Pose2;
use bica_player::team::{Intention, Role};
use glam::Vec2;

use super::*;
use crate::{ms, scene};

const ME: u8 = 2;

/// A player in a game with a budget, that knows its pose unless `place` is none.
fn player(control: Control, place: Option<Pose2>) -> Harness<Mind> {
    let mut test = Harness::new(Mind::new());
    scene(&mut test).place = place;
    packet(&mut test, ME, control, 0);
    test
}

/// Runs some cycles; returns the messages.
fn sent(test: &mut Harness<Mind>, cycles: u32) -> Vec<TeamMessage> {
    let run = |_| {
        test.cycle();
        test.tree_mut().get_mut::<TeamComm>().take()
    };
    (0..cycles).filter_map(run).collect()
}

#[test]
fn message_has_pose_ball_and_role() {
    let mut test = player(playing(12_000), Some(Pose2::new(-1.0, 0.5, 0.0)));
    scene(&mut test).shows_ball(Vec2::new(0.5, -0.5));
    let messages = sent(&mut test, 300);
    let last = messages.last().expect("messages");
    assert_eq!((last.from.team, last.from.player, last.role), (TEAM, ME, Role::Striker));
    assert_eq!((last.pose, last.intention), ([-1.0, 0.5, 0.0], Intention::Play));
    assert_eq!(last.ball.map(|ball| ball.at), Some([-0.5, 0.0]));
    assert!(last.time_to_ball.is_some_and(|time| (3.0..10.0).contains(&time)), "{last:?}");
    assert_eq!(TeamMessage::decode(&last.encode()), Ok(*last));
}

#[test]
fn nothing_is_sent_without_pose_budget_or_packets() {
    let here = Some(Pose2::ORIGIN);
    assert!(sent(&mut player(playing(12_000), None), 1000).is_empty());
    assert!(sent(&mut player(playing(0), here), 1000).is_empty());
    assert!(sent(&mut player(playing(9), here), 1000).is_empty(), "the reserve of three players");
    let initial = Control { state: PlayState::Initial, ..playing(12_000) };
    assert!(sent(&mut player(initial, here), 1000).is_empty());
    let mut alone = Harness::new(Mind::new());
    scene(&mut alone).place = here;
    assert!(sent(&mut alone, 1000).is_empty());
    assert!(!sent(&mut player(playing(12_000), here), 1000).is_empty());
}

#[test]
fn news_are_sent_at_once_and_else_seldom() {
    let mut test = player(playing(12_000), Some(Pose2::ORIGIN));
    sent(&mut test, 500);
    let quiet = sent(&mut test, 1000).len();
    assert!((10..=21).contains(&quiet), "{quiet} in 10 s");
    scene(&mut test).shows_ball(Vec2::X);
    assert!(!sent(&mut test, 12).is_empty(), "a ball");
    sent(&mut test, 100);
    scene(&mut test).shows_ball(Vec2::X * 2.0);
    assert!(!sent(&mut test, 12).is_empty(), "the ball moved");
    sent(&mut test, 100);
    scene(&mut test).fall = FallState::Fallen(bica_motion::fall::Direction::Front);
    assert!(sent(&mut test, 12).iter().any(|message| message.role == Role::Absent), "a fall");
}

#[test]
fn silent_and_penalized_mates_are_absent() {
    let mut test = player(playing(12_000), Some(Pose2::ORIGIN));
    let from = Identity { team: TEAM, player: 3 };
    let message = TeamMessage { from, role: Role::Striker, claim: 4, interval: 0.5, ..TeamMessage::default() };
    let strikers = |test: &Harness<Mind>| test.tree().get::<TeamMates>().strikers();
    hear(&mut test, message);
    test.run_for(ms(1900));
    assert_eq!(strikers(&test), 1);
    test.run_for(ms(200));
    assert_eq!(strikers(&test), 0, "four messages were lost");
    hear(&mut test, message);
    test.run_for(ms(20));
    let mut control = Control { number: 1, ..playing(12_000) };
    control.teams[1].players[2].penalty = bica_player::referee::packet::Penalty::Pushing;
    packet(&mut test, ME, control, 0);
    test.run_for(ms(20));
    assert_eq!(strikers(&test), 0, "it is penalized");
}

#[test]
fn ball_that_nobody_plays_is_taken_without_messages() {
    let mut test = player(playing(0), Some(Pose2::new(-2.0, 0.0, 0.0)));
    let mut role_after = |ball, time| {
        scene(&mut test).shows_ball(Vec2::X * ball);
        test.run_for(ms(time));
        test.tree().get::<Roles>().role()
    };
    assert_eq!(role_after(1.0, 89_000), Role::Defender, "player 1 is the striker");
    assert_eq!(role_after(1.0, 2_000), Role::Striker);
    assert_eq!(role_after(2.0, 100), Role::Defender);
}
