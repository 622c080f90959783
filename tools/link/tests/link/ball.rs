//! Placement of the ball of a simulated world.

use bica_link::{Client, Error, Event, ServerOptions};
use bica_wire::message::{ExtraKind, Offers, RefusalCode, WorldChange};

use crate::session::{FARTHEST, Session, event};

const BALL: WorldChange = WorldChange::Ball { x: 1.0, y: 0.0 };

fn refusal(result: Result<bica_link::Answered, Error>) -> (RefusalCode, String) {
    match result {
        Err(Error::Refused { code, text, .. }) => (code, text),
        other => panic!("{other:?}"),
    }
}

/// Waits for a line of the log that contains a text.
fn logged(client: &mut Client, text: &str) {
    event(client, text, |event| matches!(event, Event::Log { text: line, .. } if line.contains(text)).then_some(()));
}

#[test]
fn a_placement_is_in_force_in_the_cycle_of_its_answer() {
    let session = Session::start_world();
    let (mut operator, mut watcher) = (session.client(), session.client());
    watcher.watch_extra(ExtraKind::Truth, 1).unwrap();
    operator.acquire(false).unwrap();
    let paused_at = operator.change_world(WorldChange::Pause).unwrap().cycle;
    for step in 1..50 {
        let x = step as f32 / 50.0 * FARTHEST;
        let answer = operator.place_ball([x, 0.25]).unwrap();
        assert_eq!((answer.cycle, &answer.values[..]), (paused_at + step, &[][..]));
        logged(&mut watcher, &format!("operator: ball at {x}, 0.25 m"));
        operator.change_world(WorldChange::Step { cycles: 1 }).unwrap();
        let distance = event(&mut watcher, "the true state of the step", |event| match event {
            Event::Truth(truth) if truth.time_us == 10_000 * answer.cycle => Some(crate::extras::distance(&truth)),
            _ => None,
        });
        // In a cycle the cart drives at most 3 cm, and the wall moves by 1 m in each 300th one.
        let moved = distance - x;
        assert!(moved.abs() < 0.031 || (moved - 1.0).abs() < 0.031, "placed at {x}, {distance} after a cycle");
    }
}

#[test]
fn a_place_that_the_world_refuses_is_answered_with_its_reason() {
    let session = Session::start_world();
    let (mut operator, mut watcher) = (session.client(), session.client());
    operator.acquire(false).unwrap();
    let error = operator.place_ball([FARTHEST + 1.0, 0.0]).unwrap_err();
    assert!(error.help().contains("on the field"), "{}", error.help());
    assert_eq!(refusal(Err(error)), (RefusalCode::World, "it is too far".to_owned()));
    logged(&mut watcher, "operator: ball at 4, 0 m refused: it is too far");
    assert_eq!(refusal(operator.place_ball([f32::NAN, 0.0])).0, RefusalCode::World);
    operator.place_ball([FARTHEST, 0.0]).unwrap();
}

#[test]
fn only_the_operator_places_the_ball_and_nothing_old_is_applied() {
    let session = Session::start_world();
    let (mut operator, mut other) = (session.client(), session.client());
    assert_eq!(refusal(other.place_ball([1.0, 0.0])).0, RefusalCode::NoLease);
    operator.acquire(false).unwrap();
    let lease = operator.lease().lease;
    let number = other.send_world_with(BALL, lease, u64::MAX).unwrap();
    assert_eq!(refusal(other.answer(number)).0, RefusalCode::NoLease);
    session.run(1);
    let number = operator.send_world_with(BALL, lease, 0).unwrap();
    assert_eq!(refusal(operator.answer(number)).0, RefusalCode::Expired);
    let number = operator.send_world_with(BALL, lease, u64::MAX).unwrap();
    operator.answer(number).unwrap();
}

#[test]
fn a_robot_without_a_world_and_a_server_for_watching_refuse() {
    let session = Session::start();
    let mut client = session.client();
    client.acquire(false).unwrap();
    let error = client.place_ball([1.0, 0.0]).unwrap_err();
    assert_eq!(error.to_string(), "the robot's program does not offer to place the ball");
    // A client that does not know what the robot offers.
    let number = client.send_world_with(BALL, client.lease().lease, u64::MAX).unwrap();
    let expected = (RefusalCode::World, "the ball can be placed only in a simulated world".to_owned());
    assert_eq!(refusal(client.answer(number)), expected);
    session.run(20);

    let options = ServerOptions { watch_only: true, offers: Offers::BALL, ..ServerOptions::default() };
    let session = Session::serve(&"127.0.0.1:0".parse().unwrap(), options);
    assert_eq!(refusal(session.client().place_ball([1.0, 0.0])).0, RefusalCode::Unsupported);
    session.run(20);
}
