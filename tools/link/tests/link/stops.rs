//! A stop needs no lease, waits for nothing, and is not undone without one.

use std::time::Duration;

use bica::Value;
use bica::runner::Request;
use bica_link::Event;
use bica_wire::message::{Hold, RefusalCode, WorldChange};

use crate::robot::{CART, DRIVE};
use crate::session::{Session, next, refusal, snapshot};

const fn call(modulation: u16) -> Request<'static> {
    Request::Modulate { component: DRIVE, modulation, arguments: &[] }
}

const RELEASE: Request<'static> = call(2);

/// Asserts that the robot stands from a cycle on.
fn assert_stands(session: Session, from: u64) {
    let commands = session.finish();
    let moved = commands[from as usize..].iter().position(|bits| f32::from_bits(*bits) != 0.0);
    assert!(commands.len() > from as usize && moved.is_none(), "{from}: {moved:?}");
}

#[test]
fn stop_ends_what_an_operator_does_and_a_start_needs_a_lease() {
    let session = Session::start();
    let (mut operator, mut other) = (session.client(), session.client());
    operator.acquire(false).unwrap();
    let old = operator.lease().lease;
    operator.request(Request::Hold { component: CART, hold: Hold::Latent }).unwrap();
    let arguments = &[Value::F32(0.5)];
    operator.request(Request::Modulate { component: DRIVE, modulation: 0, arguments }).unwrap();
    let answers = other.stop().unwrap();
    assert!(answers.len() == 1 && answers[0].cycle - answers[0].arrived <= 1, "{answers:?}");
    next!(&mut operator, "the end of control", Event::Lease(lease) if !lease.owned => ());
    other.watch(1).unwrap();
    snapshot(&mut other, "its holds have ended", |snapshot| snapshot.states[0].held == Hold::Tree);
    for client in [&mut operator, &mut other] {
        let stale = client.send_request_with(RELEASE, old, u64::MAX).unwrap();
        assert_eq!(refusal(client.answer(stale)).0, RefusalCode::NoLease);
    }
    session.run(300);
    assert_stands(session, answers[0].cycle);
}

#[test]
fn stop_of_the_operator_ends_its_own_lease_too() {
    let session = Session::start();
    let mut operator = session.client();
    operator.acquire(false).unwrap();
    operator.request(call(1)).unwrap();
    assert_eq!(refusal(operator.request(RELEASE)).0, RefusalCode::NoLease);
    operator.acquire(false).unwrap();
    operator.request(RELEASE).unwrap();
}

#[test]
fn stop_waits_for_no_request_of_others() {
    let session = Session::start();
    let (mut floods, mut other) = ([(); 4].map(|()| session.client()), session.client());
    floods[0].acquire(false).unwrap();
    session.pause(true);
    // More than is handled before a cycle.
    for flood in &mut floods {
        for _ in 0..32 {
            flood.send_request(RELEASE).unwrap();
        }
    }
    let stop = other.send_request(call(1)).unwrap();
    // Time in which all arrive: without it the test passes, too.
    while other.poll(Duration::from_millis(200)).unwrap().is_some() {}
    session.pause(false);
    let stopped = other.answer(stop).unwrap();
    assert!(stopped.cycle - stopped.arrived <= 1, "{stopped:?}");
    assert_stands(session, stopped.cycle);
}

#[test]
fn stop_of_a_monitor_that_leaves_at_once_is_applied() {
    let session = Session::start();
    let (mut leaving, mut watcher) = (session.client(), session.client());
    session.pause(true);
    leaving.send_request(call(1)).unwrap();
    drop(leaving);
    session.until_stats("it is gone", |stats| stats.monitors == 1);
    session.pause(false);
    next!(&mut watcher, "the stop", Event::Log { text, .. } if text.contains("Drive.stop") => ());
}

#[test]
fn stop_is_in_force_in_a_paused_world() {
    let session = Session::start_world();
    let (mut operator, mut other) = (session.client(), session.client());
    operator.acquire(false).unwrap();
    operator.change_world(WorldChange::Pause).unwrap();
    let cycle = other.stop().unwrap()[0].cycle;
    assert_eq!(session.cycles(), cycle, "time stands still");
    operator.acquire(false).unwrap();
    operator.change_world(WorldChange::Resume).unwrap();
    session.run(50);
    assert_stands(session, cycle);
}
