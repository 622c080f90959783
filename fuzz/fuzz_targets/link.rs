//! Arbitrary frames from a monitor: decoding of the messages of both directions, and a server with a running tree.
//!
//! No input causes a panic in the server or in the loop, and afterwards another monitor is served.
#![no_main]

use std::io::{Read, Write};
use std::net::TcpStream;
use std::sync::{LazyLock, Mutex, PoisonError};
use std::thread;
use std::time::Duration;

use bica::runner::{Runner, STACK_BYTES, World};
use bica_link::{Client, ClientOptions, LinkServer, ServerOptions};
use bica_motion::model::simulation::NAO;
use bica_motion::robot::{Command, Sensors};
use bica_player::tunable::Forward;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Frame, Setup};
use bica_wire::message::{Change, LeaseAction, LeaseState, Request};
use bica_wire::{Decoder, Encoder, FromMonitor, FromRobot, MAX_PACKET, ToMonitor, ToRobot};
use libfuzzer_sys::arbitrary::{self, Arbitrary};
use libfuzzer_sys::fuzz_target;

#[derive(Arbitrary, Debug)]
enum Action {
    /// Bytes as they are.
    Raw(Vec<u8>),
    /// Content of a packet with a correct checksum.
    Packet(Vec<u8>),
    /// A message of a monitor, in postcard's format.
    Monitor(Vec<u8>),
    /// A request of the operator, if the bytes are a change in postcard's format.
    Request(Vec<u8>),
    Lease(bool),
}

/// Measurements of a robot that stands, without images.
struct Standing {
    cycle: u64,
    measured: Sensors<'static>,
}

impl World<Forward> for Standing {
    fn now(&self) -> bica::Instant {
        bica::Instant::from_millis(10 * self.cycle)
    }

    fn sensors(&mut self) -> Sensors<'_> {
        self.measured
    }

    fn act(&mut self, _command: &Command) {
        self.cycle += 1;
    }
}

fn standing() -> Standing {
    let mut world = KinematicWorld::new(NAO, &Setup { frame: Frame::Small, ..Setup::default() }).expect("valid");
    let Sensors { angles, temperatures, currents, inertial, left_foot, right_foot, buttons, .. } =
        bica_sim::World::sensors(&mut world);
    let measured = Sensors { angles, temperatures, currents, inertial, left_foot, right_foot, buttons, image: None };
    Standing { cycle: 0, measured }
}

/// Address of a server whose loop runs in a thread of its own, as fast as it can without starving others.
static SERVER: LazyLock<String> = LazyLock::new(|| {
    let options = ServerOptions { silence: Duration::from_millis(500), ..ServerOptions::default() };
    let (server, requests, observer) =
        LinkServer::start::<Forward>(&"127.0.0.1:0".parse().expect("an address"), options).expect("a server");
    let address = server.address().to_owned();
    let run = move || {
        let _server = server;
        let mut runner =
            Runner::new(Box::new(Forward::new()), standing()).with_requests(requests).with_observer(observer);
        loop {
            runner.cycle().expect("no image");
            thread::sleep(Duration::from_micros(300));
        }
    };
    thread::Builder::new().stack_size(STACK_BYTES).spawn(run).expect("a thread");
    address
});

fn packet(encoder: &mut Encoder, message: &ToRobot<'_>) -> Vec<u8> {
    encoder.encode(message, &mut [0; MAX_PACKET]).map(<[u8]>::to_vec).unwrap_or_default()
}

fn monitor(encoder: &mut Encoder, message: &FromMonitor) -> Vec<u8> {
    packet(encoder, &ToRobot::Monitor(&postcard::to_stdvec(message).expect("serializable")))
}

/// Reads what the server sends until the connection is quiet for `quiet` or closed; returns the last lease.
fn receive(stream: &mut TcpStream, quiet: Duration) -> LeaseState {
    let (mut decoder, mut buffer, mut lease) = (Decoder::<MAX_PACKET>::new(), [0; 4096], LeaseState::default());
    stream.set_read_timeout(Some(quiet)).expect("not zero");
    for _ in 0..50 {
        let Ok(count @ 1..) = stream.read(&mut buffer) else { break };
        for byte in &buffer[..count] {
            let Some(packet) = decoder.push(*byte) else { continue };
            let Ok(FromRobot::Monitor(bytes)) = packet.message() else { continue };
            if let Ok(ToMonitor::Lease(state)) = postcard::from_bytes(bytes) {
                lease = state;
            }
        }
    }
    lease
}

fn session(actions: &[Action]) {
    let mut stream = TcpStream::connect(&*SERVER).expect("the server listens");
    let (mut encoder, mut lease) = (Encoder::new(), 0);
    // A connection that begins with noise is closed.
    let _ = stream.write_all(&monitor(&mut encoder, &FromMonitor::Attach));
    for (number, action) in (0..).zip(actions.iter().take(40)) {
        let bytes = match action {
            Action::Raw(bytes) => bytes.clone(),
            Action::Packet(bytes) => {
                encoder.encode(bytes, &mut [0; MAX_PACKET]).map(<[u8]>::to_vec).unwrap_or_default()
            }
            Action::Monitor(bytes) => packet(&mut encoder, &ToRobot::Monitor(bytes)),
            Action::Request(bytes) => match postcard::from_bytes::<Change>(bytes) {
                Ok(change) => {
                    let request = Request { number, lease, expires_us: u64::MAX, change };
                    monitor(&mut encoder, &FromMonitor::Request(request))
                }
                Err(_) => continue,
            },
            Action::Lease(take) => {
                let action = if *take { LeaseAction::Take } else { LeaseAction::Acquire };
                let bytes = monitor(&mut encoder, &FromMonitor::Lease(action));
                if stream.write_all(&bytes).is_ok() {
                    lease = receive(&mut stream, Duration::from_millis(5)).lease;
                }
                continue;
            }
        };
        if stream.write_all(&bytes).is_err() {
            break;
        }
    }
    receive(&mut stream, Duration::from_millis(2));
}

/// Checks now and then that another monitor is served.
fn check() {
    static CHECKED: Mutex<u32> = Mutex::new(0);
    let mut count = CHECKED.lock().unwrap_or_else(PoisonError::into_inner);
    *count += 1;
    if count.is_multiple_of(500) {
        let options = ClientOptions { timeout: Duration::from_secs(30), ..ClientOptions::default() };
        let mut client = Client::connect(&SERVER.parse().expect("an address"), options).expect("the server answers");
        client.watch(1).expect("connected");
        let event = client.poll(Duration::from_secs(30)).expect("connected");
        assert!(event.is_some(), "no snapshot");
    }
}

fuzz_target!(|actions: Vec<Action>| {
    for action in &actions {
        if let Action::Raw(bytes) | Action::Monitor(bytes) = action {
            if let Ok(message) = postcard::from_bytes::<FromMonitor>(bytes) {
                let again = postcard::to_stdvec(&message).expect("serializable");
                let _ = format!("{:?}", postcard::from_bytes::<FromMonitor>(&again).expect("its own bytes"));
            }
            let _ = format!("{:?}", postcard::from_bytes::<ToMonitor<'_>>(bytes));
        }
    }
    session(&actions);
    check();
});
