//! A stop needs no lease, waits for nothing, and is not undone without one.

use std::time::Duration;

use bica::Value;
use bica::runner::Request;
use bica_link::Event;
use bica_wire::message::{Hold, RefusalCode, WorldChange};

use crate::robot::{CART, DRIVE};
use crate::session::{Session, Way, logged, next, over_ways, refusal, snapshot};

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

fn stop_ends_control_and_a_start_needs_a_lease(way: Way) {
    let session = Session::start(way);
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

fn stop_waits_for_no_request_of_others(way: Way) {
    let session = Session::start(way);
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

fn stop_of_a_monitor_that_leaves_at_once_is_applied(way: Way) {
    let session = Session::start(way);
    let (mut leaving, mut watcher) = (session.client(), session.client());
    session.pause(true);
    leaving.send_request(call(1)).unwrap();
    drop(leaving);
    session.until_stats("it is gone", |stats| stats.monitors == 1);
    session.pause(false);
    logged(&mut watcher, "Drive.stop");
}

fn stop_is_in_force_in_a_paused_world(way: Way) {
    let session = Session::start_world(way);
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

over_ways! { memory tcp:
    stop_ends_control_and_a_start_needs_a_lease, stop_waits_for_no_request_of_others,
    stop_of_a_monitor_that_leaves_at_once_is_applied, stop_is_in_force_in_a_paused_world
}
