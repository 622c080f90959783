//! Actions of a simulated world.

use bica::Value;
use bica_link::{Event, ServerOptions, Truth};
use bica_wire::message::{ExtraKind, RefusalCode, WorldChange};
use bica_wire::model::{NamedRequest, Plain};

use crate::extras::distance;
use crate::session::{Session, Way, logged, next, over_ways, placed, refusal};
use crate::wall::FARTHEST;

const NEAR: [Value; 1] = [Value::F32(1.0)];

fn actions_are_found_by_name(way: Way) {
    let session = Session::start_world(way);
    let client = session.client();
    let request = |action: &str, x: f64| {
        let arguments = vec![Plain::Number(x)];
        client.description().request(&NamedRequest::World { action: action.to_owned(), arguments })
    };
    assert_eq!(request("place_wall", 1.0).unwrap().borrow(), placed(&NEAR));
    let unknown = request("place_door", 1.0).unwrap_err();
    assert_eq!(unknown.to_string(), "the world has no action `place_door`");
    assert_eq!(unknown.help, "did you mean `place_wall`?");
    assert!(request("place_wall", 9.0).unwrap_err().to_string().contains("9 is outside 0..=3"));
}

fn an_action_is_in_force_in_the_cycle_of_its_answer(way: Way) {
    let session = Session::start_world(way);
    let (mut operator, mut watcher) = (session.client(), session.client());
    watcher.watch_extra(ExtraKind::Truth, 1).unwrap();
    operator.acquire(false).unwrap();
    let paused_at = operator.change_world(WorldChange::Pause).unwrap().cycle;
    for step in 1..50 {
        let x = step as f32 / 50.0 * FARTHEST;
        let answer = operator.request(placed(&[Value::F32(x)])).unwrap();
        assert_eq!((answer.cycle, &answer.values[..]), (paused_at + step, &[][..]));
        logged(&mut watcher, &format!("act place_wall({x})"));
        operator.change_world(WorldChange::Step { cycles: 1 }).unwrap();
        let is_after_step = |truth: &Truth| truth.time_us == 10_000 * answer.cycle;
        let truth = next!(&mut watcher, "the true state", Event::Truth(truth) if is_after_step(&truth) => truth);
        let distance = distance(&truth);
        // In a cycle the cart drives at most 3 cm, and the wall moves by 1 m in each 300th one.
        let moved = distance - x;
        assert!(moved.abs() < 0.031 || (moved - 1.0).abs() < 0.031, "placed at {x}, {distance} after a cycle");
    }
}

fn refused_action_is_answered_with_its_reason(way: Way) {
    let session = Session::start_world(way);
    let (mut operator, mut watcher) = (session.client(), session.client());
    operator.acquire(false).unwrap();
    let error = operator.request(placed(&[Value::F32(0.0)])).unwrap_err();
    assert!(error.help().contains("what can be done in the world,"), "{}", error.help());
    assert_eq!(refusal(Err(error)), (RefusalCode::World, 0, "`world.place_wall`: the cart is there".to_owned()));
    logged(&mut watcher, "act place_wall(0) refused: `world.place_wall`: the cart is there");
    for (x, reason) in [(FARTHEST + 1.0, "4 is outside 0..=3"), (f32::NAN, "the value is not finite")] {
        let refused = refusal(operator.request(placed(&[Value::F32(x)])));
        assert_eq!(refused, (RefusalCode::World, 0, format!("`world.x`: {reason}")));
    }
    operator.request(placed(&[Value::F32(FARTHEST)])).unwrap();
}

fn only_the_operator_acts_and_nothing_old_is_applied(way: Way) {
    let session = Session::start_world(way);
    let (mut operator, mut other) = (session.client(), session.client());
    assert_eq!(refusal(other.request(placed(&NEAR))).0, RefusalCode::NoLease);
    operator.acquire(false).unwrap();
    let lease = operator.lease().lease;
    let number = other.send_request_with(placed(&NEAR), lease, u64::MAX).unwrap();
    assert_eq!(refusal(other.answer(number)).0, RefusalCode::NoLease);
    session.run(1);
    let number = operator.send_request_with(placed(&NEAR), lease, 0).unwrap();
    assert_eq!(refusal(operator.answer(number)).0, RefusalCode::Expired);
    let number = operator.send_request_with(placed(&NEAR), lease, u64::MAX).unwrap();
    operator.answer(number).unwrap();
}

fn an_unknown_action_and_a_server_for_watching_refuse(way: Way) {
    let session = Session::start_world(way);
    let mut client = session.client();
    client.acquire(false).unwrap();
    let unknown = bica::runner::Request::World { action: 1, arguments: &NEAR };
    let expected = "`world`: no such world action; there are: place_wall";
    assert_eq!(refusal(client.request(unknown)), (RefusalCode::World, 0, expected.to_owned()));
    session.run(20);

    let options = ServerOptions { watch_only: true, ..ServerOptions::default() };
    let session = Session::serve(way, options);
    assert_eq!(refusal(session.client().request(placed(&NEAR))).0, RefusalCode::Unsupported);
    session.run(20);
}

over_ways! { memory tcp serial:
    actions_are_found_by_name
}
over_ways! { memory tcp:
    an_action_is_in_force_in_the_cycle_of_its_answer, refused_action_is_answered_with_its_reason,
    only_the_operator_acts_and_nothing_old_is_applied, an_unknown_action_and_a_server_for_watching_refuse
}
