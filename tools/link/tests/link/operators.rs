//! Operators and their requests.

use std::time::Duration;

use bica::ComponentId;
use bica::runner::Request;
use bica_link::{Client, Error, Event};
use bica_wire::message::{Hold, LeaseAction, RefusalCode, Setting, Value};

use crate::robot::{CART, DRIVE};
use crate::session::{Session, anywhere, next, refusal, silence_ends_lease, snapshot};

fn set(index: u16, value: f32) -> Setting {
    Setting::new(CART, index, Value::F32(value))
}

fn batch(settings: &[Setting]) -> Request<'_> {
    Request::Params(settings)
}

const HOLD: Request<'static> = Request::Hold { component: CART, hold: Hold::Latent };
const SLOW: Request<'static> = Request::Rate { component: DRIVE, hz: Some(5.0) };

#[test]
fn a_parameter_is_in_force_in_the_first_or_second_cycle_after_its_arrival() {
    let session = Session::start();
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

#[test]
fn a_batch_is_applied_whole_or_refused_whole() {
    let session = Session::start();
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

#[test]
fn the_end_of_a_lease_ends_holds_and_rates_and_keeps_parameters() {
    let session = Session::start();
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

#[test]
fn silence_of_the_operator_ends_its_lease_on_the_robots_clock() {
    let silence = Duration::from_secs(30);
    let session = Session::start_with(&anywhere(), silence);
    let mut watcher = session.client();
    watcher.watch(1).unwrap();
    let mut operator = session.client();
    operator.acquire(false).unwrap();
    operator.request(HOLD).unwrap();
    let last = operator.request(batch(&[set(0, 0.25)])).unwrap().cycle;
    // From here on the operator is silent, and its connection stays open.
    silence_ends_lease(&mut watcher, last, silence);
    assert!(!watcher.lease().owned);
    assert_eq!(watcher.description().components[0].params[0].value, Some(Value::F32(0.25)));
    assert_eq!(refusal(operator.request(HOLD)).0, RefusalCode::NoLease);
}

#[test]
fn a_second_operator_is_refused_until_it_takes_the_lease() {
    let session = Session::start();
    let (mut first, mut second) = (session.client(), session.client());
    first.acquire(false).unwrap();
    let old = first.lease().lease;
    // The answer to the request of the second one is not what it was told before.
    next!(&mut second, "the lease of the first", Event::Lease(lease) if lease.owned => ());
    assert!(matches!(second.acquire(false), Err(Error::Lease)));
    first.request(batch(&[set(0, 0.25)])).unwrap();
    assert_eq!(second.lease().lease, 0, "only the owner learns the number");
    assert_eq!(refusal(second.request(HOLD)).0, RefusalCode::NoLease);
    let guessed = second.send_request_with(HOLD, old, u64::MAX).unwrap();
    assert_eq!(refusal(second.answer(guessed)).0, RefusalCode::NoLease);
    second.acquire(true).unwrap();
    second.request(batch(&[set(0, 0.25)])).unwrap();
    let stale = first.send_request_with(HOLD, old, u64::MAX).unwrap();
    assert_eq!(refusal(first.answer(stale)).0, RefusalCode::NoLease);
    let newer = first.send_request_with(HOLD, second.lease().lease, u64::MAX).unwrap();
    assert_eq!(refusal(first.answer(newer)).0, RefusalCode::NoLease);
    assert!(!first.lease().yours && first.lease().owned);
    assert_eq!(session.requests(), 2);
}

#[test]
fn numbers_of_leases_cannot_be_guessed_and_a_live_lease_is_not_moved_by_its_number() {
    let session = Session::start();
    let (mut operator, mut other) = (session.client(), session.client());
    let numbers = [(); 4].map(|()| {
        operator.acquire(true).unwrap();
        operator.lease().lease
    });
    assert!(numbers.windows(2).all(|pair| pair[1].wrapping_sub(pair[0]) > 1000), "{numbers:?}");
    let lease = numbers[3];
    other.send_lease(LeaseAction::Keep { lease }).unwrap();
    let known = other.send_request_with(HOLD, lease, u64::MAX).unwrap();
    assert_eq!(refusal(other.answer(known)).0, RefusalCode::NoLease);
    operator.request(HOLD).unwrap();
    other.acquire(true).unwrap();
    let lost = "control has ended: another monitor has taken it";
    next!(&mut operator, "the loss of control", Event::Log { text, .. } if text == lost => ());
    assert!(!operator.lease().yours);
}

#[test]
fn a_request_after_its_expiry_is_refused() {
    let session = Session::start();
    let mut operator = session.client();
    operator.acquire(false).unwrap();
    let lease = operator.lease();
    session.run(10);
    let late = operator.send_request_with(HOLD, lease.lease, lease.time_us).unwrap();
    assert_eq!(refusal(operator.answer(late)).0, RefusalCode::Expired);
    let in_time = operator.send_request_with(HOLD, lease.lease, lease.time_us + 3_600_000_000).unwrap();
    operator.answer(in_time).unwrap();
}

#[test]
fn what_a_cut_connection_left_in_the_queue_is_dropped() {
    let session = Session::start();
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
