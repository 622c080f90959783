//! The server without heap and threads, with the client of a computer.

use std::io::{Read as _, Write as _};
use std::net::{TcpListener, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use bica::runner::{Request, Runner};
use bica::{Blob, Format, Hold, Setting, Tree, Value};
use bica_link::{Address, Client, ClientOptions, Error, Event, decode_output};
use bica_wire::message::{self, Change, FromMonitor, LeaseAction, RefusalCode};
use bica_wire::server::{Moment, MonitorServer, SerialLine};
use bica_wire::{Encoder, ToRobot};

use crate::robot::{CART, CartTree};
use crate::session::{LIMIT, refusal, snapshot};

/// Index of `Range`.
const RANGE: usize = 1;

/// A robot that serves the monitor of one line between its cycles.
struct Board {
    address: Address,
    stop: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Board {
    fn start() -> Self {
        let (listener, stop) = (TcpListener::bind("127.0.0.1:0").unwrap(), Arc::<AtomicBool>::default());
        let address = listener.local_addr().unwrap().to_string().parse().unwrap();
        let own = Arc::clone(&stop);
        let thread = thread::spawn(move || {
            let (stream, _) = listener.accept().unwrap();
            stream.set_nonblocking(true).unwrap();
            run(&stream, &own);
        });
        Self { address, stop, thread: Some(thread) }
    }
}

impl Drop for Board {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::Relaxed);
        self.thread.take().unwrap().join().unwrap();
    }
}

fn run(stream: &TcpStream, stop: &AtomicBool) {
    let (mut runner, mut server) = (Runner::new(Box::new(CartTree::new()), ()), MonitorServer::<1>::new());
    let (mut line, began) = (SerialLine::new(0), Instant::now());
    while !stop.load(Ordering::Relaxed) {
        let now = bica::Instant::from_micros(began.elapsed().as_micros() as u64);
        server.before_cycle(&mut runner, now);
        runner.sense(now, &(2.0, Blob { bytes: &[], format: Format::Jpeg, frame: "" })).unwrap();
        runner.think(now);
        server.after_cycle(now, now, 0);
        let moment = Moment { robot: Some(now), clock: now, random: now.as_micros() };
        let (read, write) = (|room: &mut [u8]| (&*stream).read(room), |bytes: &[u8]| (&*stream).write(bytes));
        let read = |room: &mut [u8]| read(room).unwrap_or(0);
        let write = |bytes: &[u8]| write(bytes).unwrap_or(0);
        line.serve(read, write, &mut server, &mut runner, &moment);
        thread::sleep(Duration::from_micros(500));
    }
}

#[test]
fn any_tree_is_watched_tuned_and_held() {
    let board = Board::start();
    let mut client = Client::connect(&board.address, ClientOptions::default()).unwrap();
    assert_eq!((&*client.description().name, client.description().components.len()), ("CartTree", 3));
    client.watch(1).unwrap();
    client.watch_output(RANGE, 0, 1).unwrap();
    let until = Instant::now() + LIMIT;
    let value = loop {
        assert!(Instant::now() < until);
        if let Some(Event::Output { component: RANGE, output: 0, value, .. }) = client.poll(LIMIT).unwrap() {
            break value.unwrap();
        }
    };
    assert_eq!(decode_output(client.description(), RANGE, 0, &value), Some(serde_json::json!([2.0, 4.0])));
    client.acquire(false).unwrap();
    let set = |client: &mut Client, gain| {
        client.request(Request::Params(&[Setting::new(CART, 0, Value::F32(gain))])).map(|answer| answer.values)
    };
    assert_eq!(set(&mut client, 1.5).unwrap(), [Value::F32(1.5)]);
    let Err(Error::Refused { text, .. }) = set(&mut client, 2.5) else { panic!("2.5 is outside the range") };
    assert_eq!(text, "`Cart.gain`: outside the range");
    let hold = Request::Hold { component: CART, hold: Hold::Active };
    let lease = client.lease().lease;
    for (lease, expires_us, code) in
        [(lease.wrapping_sub(1), u64::MAX, RefusalCode::NoLease), (lease, 0, RefusalCode::Expired)]
    {
        let number = client.send_request_with(hold, lease, expires_us).unwrap();
        assert_eq!(refusal(client.answer(number)).0, code);
    }
    // Each of many requests at once is answered.
    let wrong = Request::Modulate { component: CART, modulation: 0, arguments: &[] };
    for number in [(); 100].map(|()| client.send_request(wrong).unwrap()) {
        assert_eq!(refusal(client.answer(number)).0, RefusalCode::Tree);
    }
    client.request(Request::Hold { component: CART, hold: Hold::Latent }).unwrap();
    snapshot(&mut client, "the hold", |snapshot| snapshot.states[0].held == Hold::Latent);
    client.release().unwrap();
    snapshot(&mut client, "the end of the hold", |snapshot| snapshot.states[0].held == Hold::Tree);
    assert_eq!(client.damaged(), 0);
}

/// The server of two lines, and its tree.
struct Served(MonitorServer<2>, CartTree);

impl Served {
    fn receive(&mut self, line: usize, ms: u64, message: &FromMonitor) {
        let now = bica::Instant::from_millis(ms);
        let moment = Moment { robot: Some(now), clock: now, random: ms };
        let bytes = postcard::to_stdvec(message).unwrap();
        self.0.receive(line, &ToRobot::Monitor(&bytes), &mut &mut self.1, &moment);
        // An answer is sent before the next message is handled.
        while self.0.next_packet(line, &self.1, &mut Encoder::new(), &mut [0; 1280]).is_some() {}
    }

    fn request(&mut self, line: usize, ms: u64, lease: u64, hold: Hold) -> Hold {
        let change = Change::Hold { component: CART, hold };
        self.receive(
            line,
            ms,
            &FromMonitor::Request(message::Request { number: 1, lease, expires_us: u64::MAX, change }),
        );
        self.held_at(ms)
    }

    fn held_at(&mut self, ms: u64) -> Hold {
        self.0.before_cycle(&mut &mut self.1, bica::Instant::from_millis(ms));
        self.1.status(CART).unwrap().held
    }
}

#[test]
fn silence_of_the_operator_ends_its_holds() {
    let mut served = Served(MonitorServer::new(), CartTree::new());
    served.receive(0, 7, &FromMonitor::Lease(LeaseAction::Acquire));
    served.request(0, 1000, 7, Hold::Latent);
    assert_eq!([3999, 4001].map(|ms| served.held_at(ms)), [Hold::Latent, Hold::Tree]);
}

#[test]
fn two_lines_have_one_lease() {
    let mut served = Served(MonitorServer::new(), CartTree::new());
    served.receive(0, 7, &FromMonitor::Lease(LeaseAction::Acquire));
    served.receive(1, 8, &FromMonitor::Lease(LeaseAction::Acquire));
    assert_eq!(served.request(1, 8, 7, Hold::Latent), Hold::Tree, "it is the lease of the other line");
    assert_eq!(served.request(0, 8, 7, Hold::Latent), Hold::Latent);
    served.receive(1, 9, &FromMonitor::Lease(LeaseAction::Take));
    assert_eq!(served.request(0, 9, 7, Hold::Active), Hold::Latent, "the lease was taken; its hold stays");
    assert_eq!(served.request(1, 9, 9, Hold::Tree), Hold::Tree);
}
