//! Monitors that misbehave, and lines that break.

use std::collections::BTreeMap;
use std::io::{Read, Write};
use std::net::{TcpListener, TcpStream};
use std::thread;
use std::time::Duration;

use bica::runner::Request;
use bica_link::{Address, Client, ClientOptions, Error, Event, LinkServer, Memory, ServerOptions};
use bica_wire::message::{ClockMode, Hello, Hold, Setting, Value, Watch, WatchOutput};
use bica_wire::{Encoder, FromMonitor, FromRobot, MAX_PACKET, SCHEMA, ToRobot};

use crate::proxy::Proxy;
use crate::robot::{CART, CartTree};
use crate::session::{Session, Way, connect, next, snapshot};

/// A connection without a client.
pub(crate) fn raw(session: &Session) -> TcpStream {
    TcpStream::connect(session.server.address()).expect("the server listens")
}

fn packet(encoder: &mut Encoder, message: &ToRobot<'_>) -> Vec<u8> {
    encoder.encode(message, &mut [0; MAX_PACKET]).expect("the packet fits").to_vec()
}

pub(crate) fn monitor_packet(encoder: &mut Encoder, message: &FromMonitor) -> Vec<u8> {
    packet(encoder, &ToRobot::Monitor(&postcard::to_stdvec(message).expect("serializable")))
}

/// Checks that a monitor is still served.
pub(crate) fn assert_served(session: &Session) {
    let mut client = session.client();
    client.watch(1).unwrap();
    let first = snapshot(&mut client, "a snapshot", |_| true).info.cycle;
    snapshot(&mut client, "a later snapshot", |snapshot| snapshot.info.cycle > first + 20);
}

#[test]
fn monitor_that_never_reads_is_disconnected() {
    let session = Session::start(Way::Tcp);
    let mut deaf = raw(&session);
    let mut encoder = Encoder::new();
    for message in [
        FromMonitor::Attach,
        FromMonitor::Watch(Watch { every: 1 }),
        FromMonitor::WatchOutput(WatchOutput { component: 1, output: 0, every: 1 }),
    ] {
        deaf.write_all(&monitor_packet(&mut encoder, &message)).unwrap();
    }
    session.run(200);
    assert_served(&session);
    // Its lossless queue overflows: descriptions fill the buffers of the operating system first.
    let ask = packet(&mut encoder, &ToRobot::Describe).repeat(100);
    for _ in 0..1000 {
        if session.server.stats().too_slow > 0 || deaf.write_all(&ask).is_err() {
            break;
        }
    }
    session.until_stats("the monitor is disconnected", |stats| stats.too_slow == 1 && stats.monitors <= 1);
    assert_served(&session);
}

#[test]
fn a_storm_of_requests_is_limited_in_each_cycle() {
    const STORM: usize = 5000;
    let session = Session::start(Way::Tcp);
    let mut operator = session.client();
    operator.acquire(false).unwrap();
    let mut watcher = session.client();
    watcher.watch(1).unwrap();
    let lease = operator.lease().lease;
    for count in 0..STORM {
        let value = Value::F32((count % 100) as f32 * 0.01);
        let settings = &[Setting::new(CART, 0, value)];
        operator.send_request_with(Request::Params(settings), lease, u64::MAX).unwrap();
        if count % 50 == 49 {
            while operator.poll(Duration::from_millis(1)).unwrap().is_some() {}
        }
    }
    let last =
        operator.send_request_with(Request::Hold { component: CART, hold: Hold::Tree }, lease, u64::MAX).unwrap();
    operator.answer(last).unwrap();
    assert_eq!(session.requests(), STORM + 1);
    assert!(session.most_requests() <= 64, "{}", session.most_requests());
    let now = session.cycles();
    snapshot(&mut watcher, "a current snapshot", |snapshot| snapshot.info.cycle >= now);
}

#[test]
fn messages_before_a_cycle_are_limited() {
    const EACH: usize = 32;
    let session = Session::start(Way::Tcp);
    let mut clients: Vec<_> = (0..6).map(|_| session.client()).collect();
    session.pause(true);
    for client in &mut clients {
        for _ in 0..EACH {
            // Nobody owns the lease, so each is refused in the cycle in which it is handled.
            client.send_request_with(Request::Hold { component: CART, hold: Hold::Tree }, 1, u64::MAX).unwrap();
        }
    }
    // Time in which all arrive; if some do not, the test checks less.
    thread::sleep(Duration::from_millis(500));
    session.pause(false);
    let mut cycles = BTreeMap::new();
    for client in &mut clients {
        for _ in 0..EACH {
            let cycle = next!(client, "an answer", Event::Answer(answer) => answer.cycle);
            *cycles.entry(cycle).or_insert(0_usize) += 1;
        }
    }
    assert!(cycles.values().all(|count| *count <= 64), "{cycles:?}");
}

#[test]
fn garbage_is_counted_and_skipped() {
    let session = Session::start(Way::Tcp);
    let mut link = raw(&session);
    let mut encoder = Encoder::new();
    link.write_all(&monitor_packet(&mut encoder, &FromMonitor::Attach)).unwrap();
    let mut state = 1_u64;
    let noise: Vec<u8> = (0..1 << 18)
        .map(|_| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 56) as u8
        })
        .collect();
    link.write_all(&noise).unwrap();
    // A packet without an end, longer than any.
    link.write_all(&vec![7; 1 << 16]).unwrap();
    link.write_all(&[0]).unwrap();
    let hello = Hello { schema: SCHEMA, messages: 0, clock_mode: ClockMode::Lockstep, set_up: &[] };
    link.write_all(&packet(&mut encoder, &ToRobot::Hello(hello))).unwrap();
    session.until_stats("garbage is counted", |stats| stats.damaged > 500 && stats.unknown == 1);
    // The same connection still works.
    link.write_all(&packet(&mut encoder, &ToRobot::Describe)).unwrap();
    link.set_read_timeout(Some(Duration::from_mins(1))).unwrap();
    // More than the answers to `Attach` have.
    link.read_exact(&mut [0; 256]).unwrap();
    assert_served(&session);
    assert_eq!(session.requests(), 0);
}

#[test]
fn other_addresses_than_loopback_need_permission() {
    let start = |anywhere| {
        let options = ServerOptions { anywhere, ..ServerOptions::default() };
        LinkServer::start::<CartTree>(&"0.0.0.0:0".parse().unwrap(), options)
    };
    assert!(matches!(start(false), Err(Error::NotLoopback(_))));
    start(true).unwrap();
}

#[test]
fn place_in_memory_is_served_while_its_server_runs() {
    let place = Memory::default();
    let address = Address::Memory(place.clone());
    assert!(!place.is_served_within(Duration::ZERO));
    let served = LinkServer::start::<CartTree>(&address, ServerOptions::default()).unwrap();
    assert!(place.is_served_within(Duration::ZERO));
    drop(served);
    assert!(!place.is_served_within(Duration::ZERO));
    let options = ClientOptions { timeout: Duration::from_millis(1), ..ClientOptions::default() };
    assert!(matches!(Client::connect(&address, options), Err(Error::Connect { .. })));
}

/// Waits until a connection is cut; returns the reason.
pub(crate) fn cut(client: &mut Client) -> Error {
    loop {
        if let Err(error) = client.poll(Duration::from_secs(10)) {
            return error;
        }
    }
}

#[test]
fn reconnected_client_keeps_watches_and_lease() {
    let session = Session::start(Way::Tcp);
    let proxy = Proxy::start(session.server.address());
    let mut client = connect(&proxy.address.parse().unwrap());
    client.watch(1).unwrap();
    client.acquire(false).unwrap();
    client.request(Request::Hold { component: CART, hold: Hold::Latent }).unwrap();
    let lease = client.lease().lease;
    proxy.cut();
    assert!(matches!(cut(&mut client), Error::Disconnected(_)));
    client.reconnect(Duration::from_mins(1)).unwrap();
    assert_eq!((client.lease().yours, client.lease().lease), (true, lease));
    let now = session.cycles();
    let after = snapshot(&mut client, "a new snapshot", |snapshot| snapshot.info.cycle >= now);
    assert_eq!(after.states[0].held, Hold::Latent);
    client.request(Request::Hold { component: CART, hold: Hold::Tree }).unwrap();
}

#[test]
fn a_robot_of_an_older_version_is_named_as_such() {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let address = listener.local_addr().unwrap().to_string();
    let robot = thread::spawn(move || {
        let (mut stream, _) = listener.accept().unwrap();
        stream.read_exact(&mut [0]).unwrap();
        // The answer to `Attach` before robots stated what they offer.
        let attached = postcard::to_stdvec(&(0_u8, SCHEMA ^ 1, 7_u64, "Tree", true, 3000_u32)).unwrap();
        let mut packet = [0; MAX_PACKET];
        let packet = Encoder::new().encode(&FromRobot::Monitor(&attached), &mut packet).unwrap();
        stream.write_all(packet).unwrap();
        // Until the client closes the connection.
        let _ = stream.read_to_end(&mut Vec::new());
    });
    let result = Client::connect(&address.parse().unwrap(), ClientOptions::default());
    assert!(matches!(&result, Err(Error::Schema { robot }) if *robot == SCHEMA ^ 1), "{:?}", result.err());
    drop(result);
    robot.join().unwrap();
}
