//! A loop with a server, in a thread of its own.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use bica::action::Actions;
use bica::runner::{Cycle, Observer, Request, Runner};
use bica::{Probe, Value};
use bica_link::{
    Address, Answered, Client, ClientOptions, Error, Event, LinkServer, LinkStats, Memory, ServerOptions, Snapshot,
};
use bica_wire::message::{Offers, RefusalCode, Stop, WorldChange};

use crate::robot::CartTree;
use crate::wall::Wall;

/// Longest wait of a test that fails.
pub(crate) const LIMIT: Duration = Duration::from_mins(1);
/// Time longer than any test.
pub(crate) const LONG: Duration = Duration::from_secs(1_000_000);

/// Any port of this computer.
pub(crate) fn anywhere() -> Address {
    "127.0.0.1:0".parse().unwrap()
}

/// How monitors reach the server.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Way {
    /// In the same process.
    Memory,
    Tcp,
    /// A serial line, which has one monitor.
    #[cfg(target_os = "linux")]
    Serial,
}

impl Way {
    /// Addresses of the server and of its monitors. Those of a TCP server depend on its port.
    fn ends(self) -> (Address, Option<Address>) {
        match self {
            Self::Tcp => (anywhere(), None),
            Self::Memory => {
                let place = Address::Memory(Memory::default());
                (place.clone(), Some(place))
            }
            #[cfg(target_os = "linux")]
            Self::Serial => {
                let [server, monitor] = crate::serial::line();
                (server, Some(monitor))
            }
        }
    }
}

/// Makes a test of each function for each way.
macro_rules! over_ways {
    ($($way:ident)+: $($name:ident),+) => { over_ways!(@all [$($way)+] $($name)+); };
    (@all $ways:tt $($name:ident)+) => { $(over_ways!(@each $name $ways);)+ };
    (@each $name:ident [$($way:ident)+]) => { mod $name { $(crate::session::over_ways!(@one $name $way);)+ } };
    (@one $name:ident memory) => { #[test] fn memory() { super::$name(crate::session::Way::Memory) } };
    (@one $name:ident tcp) => { #[test] fn tcp() { super::$name(crate::session::Way::Tcp) } };
    (@one $name:ident serial) => {
        #[cfg(target_os = "linux")] #[test] fn serial() { super::$name(crate::session::Way::Serial) }
    };
}
pub(crate) use over_ways;

/// Robot's time of a cycle.
pub(crate) const CYCLE_US: u64 = 10_000;

/// Data that all threads of a session share.
#[derive(Default)]
pub(crate) struct Shared {
    stop: AtomicBool,
    paused: AtomicBool,
    is_paused: AtomicBool,
    cycles: AtomicU64,
    /// Requests applied since the start, and the largest number before one cycle.
    requests: AtomicUsize,
    most_requests: AtomicUsize,
}

struct Counter {
    shared: Arc<Shared>,
    this_cycle: usize,
}

impl Probe for Counter {}

impl Observer<CartTree> for Counter {
    fn requested(&mut self, _now: bica::Instant, _request: &Request<'_>) {
        self.this_cycle += 1;
        self.shared.requests.fetch_add(1, Ordering::SeqCst);
    }

    fn acted(&mut self, _cycle: &Cycle<'_, CartTree>) {
        self.shared.most_requests.fetch_max(self.this_cycle, Ordering::SeqCst);
        self.this_cycle = 0;
    }
}

/// A loop with a server.
pub(crate) struct Session {
    shared: Arc<Shared>,
    pub(crate) server: LinkServer,
    /// Address for clients.
    monitors: Address,
    thread: Option<JoinHandle<Vec<u32>>>,
}

impl Session {
    /// Starts a loop whose operator may be silent for long.
    pub(crate) fn start(way: Way) -> Self {
        Self::start_with(way, LONG)
    }

    /// Starts a simulated world, which can be paused, with images in every cycle.
    pub(crate) fn start_world(way: Way) -> Self {
        Self::start_with_breakpoints(way, Vec::new())
    }

    pub(crate) fn start_with(way: Way, silence: Duration) -> Self {
        Self::serve(way, ServerOptions { silence, ..ServerOptions::default() })
    }

    /// Starts a simulated world whose program has breakpoints.
    pub(crate) fn start_with_breakpoints(way: Way, stops: Vec<Stop>) -> Self {
        let (offers, actions) = (Offers::PAUSE, Wall::new().list());
        Self::serve_with(way, ServerOptions { silence: LONG, offers, actions, ..ServerOptions::default() }, stops)
    }

    pub(crate) fn serve(way: Way, options: ServerOptions) -> Self {
        Self::serve_with(way, options, Vec::new())
    }

    fn serve_with(way: Way, options: ServerOptions, stops: Vec<Stop>) -> Self {
        let (address, monitors) = way.ends();
        let is_world = options.offers.contains(Offers::PAUSE);
        let started = if is_world {
            LinkServer::start_in_world::<CartTree>(&address, options, &Wall::new())
        } else {
            LinkServer::start::<CartTree>(&address, options)
        };
        let (server, mut requests, observer) = started.expect("the server starts");
        requests.break_at(stops);
        let monitors = monitors.unwrap_or_else(|| server.address().parse().unwrap());
        let shared = Arc::<Shared>::default();
        let counter = Counter { shared: Arc::clone(&shared), this_cycle: 0 };
        let runner = Runner::new(Box::new(CartTree::new()), Wall::new());
        let mut runner = runner.with_requests(requests).with_observer((counter, observer));
        let in_loop = Arc::clone(&shared);
        let thread = thread::spawn(move || {
            let mut commands = Vec::new();
            while !in_loop.stop.load(Ordering::SeqCst) {
                if in_loop.paused.load(Ordering::SeqCst) {
                    in_loop.is_paused.store(true, Ordering::SeqCst);
                    thread::sleep(Duration::from_millis(1));
                    continue;
                }
                in_loop.is_paused.store(false, Ordering::SeqCst);
                if !runner.requests_mut().begins_cycle() {
                    runner.apply_requests();
                    runner.observer().1.show_truth(runner.world());
                    thread::sleep(Duration::from_millis(1));
                    continue;
                }
                commands.push(runner.cycle().expect("no sensor value is rejected").to_bits());
                runner.observer().1.show_truth(runner.world());
                in_loop.cycles.fetch_add(1, Ordering::SeqCst);
                thread::sleep(Duration::from_micros(500));
            }
            commands
        });
        let session = Self { shared, server, monitors, thread: Some(thread) };
        if way == Way::Memory && is_world {
            session.begin();
        }
        session
    }

    /// Continues a world in this process, which begins paused.
    fn begin(&self) {
        let mut client = self.client();
        client.acquire(false).unwrap();
        assert_eq!(self.cycles(), 0, "no monitor misses a cycle");
        client.change_world(WorldChange::Resume).unwrap();
        client.release().unwrap();
    }

    pub(crate) fn client(&self) -> Client {
        connect(&self.monitors)
    }

    /// Number of cycles so far.
    pub(crate) fn cycles(&self) -> u64 {
        self.shared.cycles.load(Ordering::SeqCst)
    }

    /// Waits for some more cycles.
    pub(crate) fn run(&self, cycles: u64) {
        let end = self.cycles() + cycles;
        self.until("the loop keeps going", || self.cycles() >= end);
    }

    pub(crate) fn requests(&self) -> usize {
        self.shared.requests.load(Ordering::SeqCst)
    }

    pub(crate) fn most_requests(&self) -> usize {
        self.shared.most_requests.load(Ordering::SeqCst)
    }

    /// Stops the loop between two cycles, or continues it.
    pub(crate) fn pause(&self, paused: bool) {
        self.shared.paused.store(paused, Ordering::SeqCst);
        self.until("the loop pauses or continues", || self.shared.is_paused.load(Ordering::SeqCst) == paused);
    }

    /// Waits until the counts of the server meet a condition.
    pub(crate) fn until_stats(&self, expected: &str, condition: impl Fn(&LinkStats) -> bool) {
        self.until(expected, || condition(&self.server.stats()));
    }

    #[track_caller]
    fn until(&self, expected: &str, condition: impl Fn() -> bool) {
        let began = Instant::now();
        while !condition() {
            assert!(
                began.elapsed() < LIMIT,
                "{expected}: not yet at cycle {}, {:?}",
                self.cycles(),
                self.server.stats()
            );
            thread::sleep(Duration::from_millis(1));
        }
    }

    /// Ends the loop and returns the bits of all commands.
    pub(crate) fn finish(mut self) -> Vec<u32> {
        self.shared.stop.store(true, Ordering::SeqCst);
        self.thread.take().expect("it runs").join().expect("the loop does not panic")
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        self.shared.stop.store(true, Ordering::SeqCst);
    }
}

/// A client of a session, also through a proxy or a line.
pub(crate) fn connect(address: &Address) -> Client {
    // The robot's time is faster than the clock, from which a client computes an expiry: the usual one would pass in a few milliseconds.
    let options = ClientOptions { timeout: LIMIT, expiry: LONG };
    Client::connect(address, options).expect("a robot answers")
}

/// Waits for an event.
#[track_caller]
pub(crate) fn event<T>(client: &mut Client, expected: &str, mut select: impl FnMut(Event) -> Option<T>) -> T {
    let began = Instant::now();
    while began.elapsed() < LIMIT {
        let received = client.poll(Duration::from_millis(100)).expect("the link is not cut");
        if let Some(found) = received.and_then(&mut select) {
            return found;
        }
    }
    panic!("{expected}: no such event");
}

/// Waits for an event of a pattern; returns a value of it.
macro_rules! next {
    ($client:expr, $expected:expr, $pattern:pat $(if $condition:expr)? => $value:expr) => {
        $crate::session::event($client, $expected, |event| match event {
            $pattern $(if $condition)? => Some($value),
            _ => None,
        })
    };
}
pub(crate) use next;

/// Waits for a line of the log that contains a text.
#[track_caller]
pub(crate) fn logged(client: &mut Client, text: &str) {
    let tree = client.description().clone();
    event(client, text, |event| event.line(&tree).filter(|line| line.text.contains(text)));
}

/// Waits for a snapshot that meets a condition.
#[track_caller]
pub(crate) fn snapshot(client: &mut Client, expected: &str, condition: impl Fn(&Snapshot) -> bool) -> Snapshot {
    next!(client, expected, Event::Snapshot(snapshot) if condition(&snapshot) => snapshot)
}

/// Code, entry and text of a refusal.
#[track_caller]
pub(crate) fn refusal(result: Result<Answered, Error>) -> (RefusalCode, usize, String) {
    match result {
        Err(Error::Refused { code, entry, text }) => (code, entry, text),
        other => panic!("{other:?}"),
    }
}

/// Requests a place of the wall.
pub(crate) const fn placed(x: &[Value; 1]) -> Request<'_> {
    Request::World { action: 0, arguments: x }
}
