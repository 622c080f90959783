//! Operators and their requests.

use std::time::Duration;

use bica::ComponentId;
use bica::runner::Request;
use bica_link::{Client, Error, Event};
use bica_wire::message::{Hold, LeaseAction, LogLine, RefusalCode, Setting, Value};

use crate::robot::{CART, DRIVE};
use crate::session::{CYCLE_US, Session, Way, next, over_ways, refusal, snapshot};

fn set(index: u16, value: f32) -> Setting {
    Setting::new(CART, index, Value::F32(value))
}

fn batch(settings: &[Setting]) -> Request<'_> {
    Request::Params(settings)
}

const HOLD: Request<'static> = Request::Hold { component: CART, hold: Hold::Latent };
const SLOW: Request<'static> = Request::Rate { component: DRIVE, hz: Some(5.0) };

fn parameter_is_in_force_within_two_cycles(way: Way) {
    let session = Session::start(way);
    let mut operator = session.client();
    operator.acquire(false).unwrap();
    for step in 0..200 {
        let value = 0.01 * step as f32;
        let answer = operator.request(batch(&[set(0, value)])).unwrap();
        assert_eq!(answer.values, [Value::F32(value)]);
        let cycles = answer.cycle - answer.arrived;
        assert!(cycles <= 1, "{answer:?}");
    }
}

fn a_batch_is_applied_whole_or_refused_whole(way: Way) {
    let session = Session::start(way);
    let mut operator = session.client();
    operator.acquire(false).unwrap();
    let answer = operator.request(batch(&[set(1, 1.5), set(2, 1.0)])).unwrap();
    assert_eq!(answer.values, [Value::F32(1.5), Value::F32(1.0)]);
    let (code, entry, text) = refusal(operator.request(batch(&[set(0, 1.0), set(1, 7.0)])));
    assert_eq!((code, entry, &*text), (RefusalCode::Tree, 1, "`Cart.wanted`: 7 is outside 0.1..=2"));
    let (code, _, text) = refusal(operator.request(batch(&[set(0, 1.0), set(2, 1.6)])));
    assert_eq!((code, &*text), (RefusalCode::Tree, "`Cart`: `nearest` must not be above `wanted`"));
    let (_, _, text) = refusal(operator.request(Request::Hold { component: ComponentId::new(99), hold: Hold::Active }));
    assert!(text.contains("no such component"), "{text}");
    for hz in [-1e30, 0.0, 1e6, f32::INFINITY] {
        let (code, _, text) = refusal(operator.request(Request::Rate { component: DRIVE, hz: Some(hz) }));
        assert!(code == RefusalCode::Tree && text.contains("above 0 Hz"), "{hz}: {text}");
    }
    let watcher = session.client();
    let values: Vec<_> = watcher.description().components[0].params.iter().map(|param| param.value).collect();
    assert_eq!(values, [Value::F32(0.5), Value::F32(1.5), Value::F32(1.0), Value::Choice(0)].map(Some));
}

fn lease_end_ends_holds_and_keeps_parameters(way: Way) {
    let session = Session::start(way);
    let (mut operator, mut watcher) = (session.client(), session.client());
    operator.acquire(false).unwrap();
    for change in [HOLD, SLOW, batch(&[set(0, 0.25)])] {
        operator.request(change).unwrap();
    }
    watcher.watch(1).unwrap();
    let held = snapshot(&mut watcher, "the requests are in force", |_| true);
    assert_eq!((held.states[0].held, held.states[2].hz), (Hold::Latent, Some(5.0)));
    operator.release().unwrap();
    let ended = snapshot(&mut watcher, "the hold ends", |snapshot| snapshot.states[0].held == Hold::Tree);
    assert_eq!(ended.states[2].hz, Some(50.0));
    assert!(ended.states[0].active);
    assert_eq!(session.client().description().components[0].params[0].value, Some(Value::F32(0.25)));
    assert_eq!(refusal(operator.request(HOLD)).0, RefusalCode::NoLease);
}

fn silence_ends_the_lease_on_the_robot_s_clock(way: Way) {
    let silence = Duration::from_secs(30);
    let session = Session::start_with(way, silence);
    let mut watcher = session.client();
    watcher.watch(1).unwrap();
    let mut operator = session.client();
    operator.acquire(false).unwrap();
    operator.request(HOLD).unwrap();
    let last = operator.request(batch(&[set(0, 0.25)])).unwrap().cycle;
    // From here on the operator is silent, and its connection stays open.
    let ended_us = next!(&mut watcher, "the lease ends",
        Event::Log(LogLine { time_us, level: 3, text, .. }) if text.contains("silent") => time_us);
    let expected = last * CYCLE_US + silence.as_micros() as u64 + CYCLE_US;
    assert_eq!(ended_us, expected, "the first cycle after the silence");
    let ended = snapshot(&mut watcher, "a snapshot", |snapshot| snapshot.info.time_us >= ended_us);
    assert_eq!(ended.states[0].held, Hold::Tree);
    assert!(!watcher.lease().owned);
    assert_eq!(watcher.description().components[0].params[0].value, Some(Value::F32(0.25)));
    assert_eq!(refusal(operator.request(HOLD)).0, RefusalCode::NoLease);
}

fn lease_numbers_cannot_be_guessed(way: Way) {
    let session = Session::start(way);
    let (mut operator, mut other) = (session.client(), session.client());
    let numbers = [(); 4].map(|()| {
        operator.acquire(true).unwrap();
        operator.lease().lease
    });
    assert!(numbers.windows(2).all(|pair| pair[1].wrapping_sub(pair[0]) > 1000), "{numbers:?}");
    assert!(matches!(other.acquire(false), Err(Error::Lease)));
    assert_eq!(other.lease().lease, 0, "only the owner learns the number");
    let lease = numbers[3];
    other.send_lease(LeaseAction::Keep { lease }).unwrap();
    let known = other.send_request_with(HOLD, lease, u64::MAX).unwrap();
    assert_eq!(refusal(other.answer(known)).0, RefusalCode::NoLease);
    operator.request(HOLD).unwrap();
    other.acquire(true).unwrap();
    let lost = "control has ended: another monitor has taken it";
    next!(&mut operator, "the loss of control", Event::Log(LogLine { text, .. }) if text == lost => ());
    assert!(!operator.lease().yours);
}

fn what_a_cut_connection_left_in_the_queue_is_dropped(way: Way) {
    let session = Session::start(way);
    let mut operator: Client = session.client();
    operator.acquire(false).unwrap();
    session.pause(true);
    for _ in 0..20 {
        operator.send_request_with(HOLD, operator.lease().lease, u64::MAX).unwrap();
    }
    drop(operator);
    session.until_stats("the connection ends", |stats| stats.monitors == 0);
    session.pause(false);
    session.run(20);
    assert_eq!(session.requests(), 0);
}

over_ways! { memory tcp serial:
    parameter_is_in_force_within_two_cycles
}
over_ways! { memory tcp:
    a_batch_is_applied_whole_or_refused_whole, lease_end_ends_holds_and_keeps_parameters,
    silence_ends_the_lease_on_the_robot_s_clock, lease_numbers_cannot_be_guessed,
    what_a_cut_connection_left_in_the_queue_is_dropped
}
