//! Attacks. `docs/security.md` lists all of them.

use std::io::{ErrorKind, Read, Write};
use std::net::TcpStream;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

use bica::runner::Request;
use bica::runner::{Runner, World};
use bica_link::{Error, LinkServer, MAX_MONITORS, ServerOptions};
use bica_wire::message::{Hold, LeaseAction};
use bica_wire::{Encoder, FromMonitor};

use crate::faults::{assert_served, cut, monitor_packet, raw};
use crate::proxy::Proxy;
use crate::robot::{CART, OtherTree};
use crate::session::{CYCLE_US, LIMIT, Session, Way, anywhere, connect};

const HOLD: Request<'static> = Request::Hold { component: CART, hold: Hold::Latent };

/// Attacks 1 and 3: a web page makes a browser send packets to the link. The bytes that the page chooses come after a head.
#[test]
fn connection_without_a_packet_is_closed() {
    let session = Session::start(Way::Tcp);
    let http = b"POST / HTTP/1.1\r\nHost: 127.0.0.1:7400\r\nContent-Type: text/plain\r\nContent-Length: 200\r\n\r\n";
    let handshake = [0x16, 3, 1, 2, 0, 1, 0, 1, 0xfc, 3, 3];
    for (number, head) in (1..).zip([&http[..], &handshake]) {
        let mut browser = raw(&session);
        let take = monitor_packet(&mut Encoder::new(), &FromMonitor::Lease(LeaseAction::Take));
        browser.write_all(&[head, &[0], &take, &take].concat()).unwrap();
        assert_closed(&mut browser);
        assert_eq!(session.server.stats().damaged, number);
        assert!(!session.client().lease().owned);
    }
    assert_served(&session);
}

/// Attack 11: connections that send nothing occupy no place of a monitor, and do not delay newer connections.
#[test]
fn silent_connections_leave_room_for_an_operator() {
    let session = Session::start(Way::Tcp);
    let mut silent: Vec<_> = (0..3 * MAX_MONITORS).map(|_| raw(&session)).collect();
    let mut operator = session.client();
    operator.acquire(false).unwrap();
    operator.request(HOLD).unwrap();
    assert_eq!(session.server.stats().monitors, 1);
    assert_closed(&mut silent[0]);
    assert_closed(silent.last_mut().unwrap());
    operator.request(HOLD).unwrap();
}

/// Waits until the server has closed a connection.
#[track_caller]
fn assert_closed(stream: &mut TcpStream) {
    stream.set_read_timeout(Some(LIMIT)).unwrap();
    let read = stream.read(&mut [0; 64]).map_err(|error| error.kind());
    let cut = [ErrorKind::ConnectionReset, ErrorKind::ConnectionAborted, ErrorKind::BrokenPipe];
    assert!(read.map_or_else(|kind| cut.contains(&kind), |count| count == 0), "{read:?}");
}

/// Attack 15: the same robot, started again, has another operator.
#[test]
fn a_lease_of_an_earlier_run_is_void() {
    let first = Session::start(Way::Tcp);
    let proxy = Proxy::start(first.server.address());
    let mut client = connect(&proxy.address.parse().unwrap());
    client.acquire(false).unwrap();
    let old = client.lease().lease;
    let second = Session::start(Way::Tcp);
    let mut other = second.client();
    other.acquire(false).unwrap();
    assert_ne!(other.lease().lease, old);
    proxy.lead_to(second.server.address());
    proxy.cut();
    cut(&mut client);
    client.reconnect(LIMIT).unwrap();
    assert!(!client.lease().yours);
    other.request(HOLD).unwrap();
}

struct Still(u64);

impl World<OtherTree> for Still {
    fn now(&self) -> bica::Instant {
        bica::Instant::from_micros(self.0 * CYCLE_US)
    }

    fn sensors(&mut self) -> f32 {
        1.0
    }

    fn act(&mut self, (): &()) {
        self.0 += 1;
    }
}

/// Attack 15: another robot answers at the address.
#[test]
fn a_client_does_not_continue_with_another_robot() {
    let session = Session::start(Way::Tcp);
    let proxy = Proxy::start(session.server.address());
    let mut client = connect(&proxy.address.parse().unwrap());
    client.acquire(false).unwrap();
    let (server, requests, observer) = LinkServer::start::<OtherTree>(&anywhere(), ServerOptions::default()).unwrap();
    let stop = Arc::new(AtomicBool::new(false));
    let stopped = Arc::clone(&stop);
    let other = thread::spawn(move || {
        let runner = Runner::new(Box::new(OtherTree::new()), Still(0));
        let mut runner = runner.with_requests(requests).with_observer(observer);
        while !stopped.load(Ordering::SeqCst) {
            runner.cycle().unwrap();
            thread::sleep(Duration::from_millis(1));
        }
    });
    proxy.lead_to(server.address());
    proxy.cut();
    cut(&mut client);
    let result = client.reconnect(LIMIT);
    stop.store(true, Ordering::SeqCst);
    other.join().unwrap();
    assert!(
        matches!(&result, Err(Error::OtherRobot { expected, found }) if (&**expected, &**found) == ("CartTree", "OtherTree")),
        "{result:?}"
    );
}
