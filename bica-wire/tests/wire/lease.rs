//! Rules of the lease.

use core::time::Duration;

use bica_core::graph::{Graph, Node};
use bica_core::modulation::Modulation;
use bica_core::{ComponentId, Instant};
use bica_wire::message::{Change, Hold, LeaseAction, LeaseState, RefusalCode, Request};
use bica_wire::server::Lease;

const NOW: Instant = Instant::from_micros(5);

/// A tree whose only component has a modulation that starts it, and one that stops it.
const GRAPH: Graph = Graph {
    name: "Cart",
    commit: None,
    version: None,
    doc: "",
    cycle_hz: 100.0,
    budget_ms: None,
    tunable: true,
    root: 0,
    nodes: &[Node {
        modulations: &[
            Modulation { name: "start", doc: "", stops: false, drives: true, arguments: &[] },
            Modulation { name: "stop", doc: "", stops: true, drives: false, arguments: &[] },
        ],
        ..Node::new("Drive")
    }],
    roles: &[],
};

const fn ms(ms: u64) -> Duration {
    Duration::from_millis(ms)
}

fn request(lease: u64) -> Request {
    Request { number: 0, lease, expires_us: u64::MAX, change: hold(0, Hold::Tree) }
}

fn hold(component: u16, hold: Hold) -> Change {
    Change::Hold { component: ComponentId::new(component.into()), hold }
}

fn admits(lease: &mut Lease, connection: u64, number: u64, at: Duration) -> bool {
    lease.admit(connection, &request(number), &GRAPH, at, NOW).is_ok()
}

#[test]
fn one_connection_owns_the_lease() {
    let mut lease = Lease::new(ms(3000));
    assert!(lease.act(1, LeaseAction::Acquire, ms(0), 8));
    assert_eq!(lease.state(1, NOW), LeaseState { lease: 8, owned: true, yours: true, time_us: 5 });
    assert_eq!(lease.state(2, NOW), LeaseState { lease: 0, owned: true, yours: false, time_us: 5 });
    assert!(!lease.act(2, LeaseAction::Acquire, ms(0), 8));
    assert!(admits(&mut lease, 1, 8, ms(0)) && !admits(&mut lease, 2, 8, ms(0)) && !admits(&mut lease, 1, 7, ms(0)));
    assert!(lease.act(2, LeaseAction::Take, ms(0), 9));
    assert!(admits(&mut lease, 2, 9, ms(0)) && !admits(&mut lease, 1, 8, ms(0)) && !admits(&mut lease, 1, 9, ms(0)));
    assert!(
        !lease.act(1, LeaseAction::Return { lease: 8 }, ms(0), 0)
            && !lease.act(1, LeaseAction::Return { lease: 9 }, ms(0), 0)
    );
    assert!(lease.act(2, LeaseAction::Return { lease: 9 }, ms(0), 0));
    assert_eq!(lease.state(2, Instant::MIN), LeaseState::default());
}

#[test]
fn silence_ends_the_lease_and_its_requests() {
    let mut lease = Lease::new(ms(3000));
    lease.act(1, LeaseAction::Acquire, ms(1000), 1);
    for component in [255, 4, 5, 31, 32] {
        lease.record(&hold(component, Hold::Latent), &GRAPH);
    }
    lease.record(&hold(5, Hold::Tree), &GRAPH);
    lease.record(&Change::Rate { component: ComponentId::new(6), hz: Some(10.0) }, &GRAPH);
    lease.record(&Change::Rate { component: ComponentId::new(7), hz: Some(10.0) }, &GRAPH);
    lease.record(&Change::Rate { component: ComponentId::new(7), hz: None }, &GRAPH);
    assert!(!lease.check_silence(ms(4000)));
    lease.act(1, LeaseAction::Keep { lease: 1 }, ms(4000), 0);
    assert!(!lease.check_silence(ms(7000)));
    assert_eq!(lease.next_ending(), None);
    assert!(lease.check_silence(ms(7001)));
    for component in [4, 31, 32, 255] {
        assert_eq!(lease.next_ending(), Some(hold(component, Hold::Tree)));
    }
    assert_eq!(lease.next_ending(), Some(Change::Rate { component: ComponentId::new(6), hz: None }));
    assert_eq!(lease.next_ending(), None);
    assert!(!lease.act(1, LeaseAction::Keep { lease: 1 }, ms(7001), 0) && !admits(&mut lease, 1, 1, ms(7001)));
}

#[test]
fn new_connection_continues_only_an_ended_lease() {
    let mut lease = Lease::new(ms(3000));
    lease.act(1, LeaseAction::Acquire, ms(0), 7);
    assert!(!lease.act(2, LeaseAction::Keep { lease: 7 }, ms(1000), 0) && admits(&mut lease, 1, 7, ms(1000)));
    lease.disconnect(2);
    assert!(!lease.act(2, LeaseAction::Keep { lease: 7 }, ms(1000), 0));
    lease.disconnect(1);
    assert!(
        !lease.act(2, LeaseAction::Keep { lease: 6 }, ms(2000), 0) && !lease.act(2, LeaseAction::Acquire, ms(2000), 9)
    );
    assert!(lease.act(2, LeaseAction::Keep { lease: 7 }, ms(2000), 0));
    assert!(admits(&mut lease, 2, 7, ms(2000)) && !admits(&mut lease, 1, 7, ms(2000)));
    lease.disconnect(2);
    assert!(!lease.check_silence(ms(5000)) && lease.check_silence(ms(5001)));
}

#[test]
fn no_lease_has_the_number_before_or_none() {
    let mut lease = Lease::new(ms(3000));
    let numbers = [0, 1, u64::MAX, u64::MAX, 0].map(|random| {
        lease.act(1, LeaseAction::Take, ms(0), random);
        lease.state(1, NOW).lease
    });
    assert_eq!(numbers, [1, 2, u64::MAX, 1, 2]);
}

#[test]
fn expired_request_is_refused_but_ends_silence() {
    let mut lease = Lease::new(ms(3000));
    lease.act(1, LeaseAction::Acquire, ms(0), 1);
    let expiring = |expires_us| Request { expires_us, ..request(1) };
    assert_eq!(lease.admit(1, &expiring(5), &GRAPH, ms(2000), NOW), Ok(()));
    assert_eq!(lease.admit(1, &expiring(4), &GRAPH, ms(3000), NOW), Err(RefusalCode::Expired));
    assert_eq!(lease.admit(2, &expiring(4), &GRAPH, ms(6000), NOW), Err(RefusalCode::NoLease));
    assert!(!lease.check_silence(ms(6000)) && lease.check_silence(ms(6001)));
}

#[test]
fn stop_needs_no_lease_and_ends_it() {
    let call = |component: usize, modulation| {
        let change = Change::Modulate { component: ComponentId::new(component), modulation, arguments: [].into() };
        Request { number: 0, lease: 0, expires_us: 0, change }
    };
    let mut lease = Lease::new(ms(3000));
    let admits = |lease: &mut Lease, request: &Request| lease.admit(2, request, &GRAPH, ms(0), NOW).is_ok();
    for owned in [false, true] {
        assert!(admits(&mut lease, &call(0, 1)), "a stop, without the lease and after its expiry");
        for other in [call(0, 0), call(0, 2), call(1, 1), request(7)] {
            assert!(!admits(&mut lease, &other), "{other:?}");
        }
        assert_eq!(lease.record(&call(0, 1).change, &GRAPH), owned);
        lease.act(1, LeaseAction::Acquire, ms(0), 7);
        lease.record(&hold(0, Hold::Latent), &GRAPH);
    }
    assert!(lease.record(&call(0, 1).change, &GRAPH) && !lease.state(1, NOW).owned);
    assert_eq!((lease.next_ending(), lease.next_ending()), (Some(hold(0, Hold::Tree)), None));
    assert!(!lease.act(1, LeaseAction::Keep { lease: 7 }, ms(0), 0), "it does not come back by itself");
}
