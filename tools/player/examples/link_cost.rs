//! Cost of monitors for the loop, and delay of requests.
//!
//! `cargo run --release -p bica-player-program --example link_cost -- [SECONDS]`: the forward at 100 Hz in real time, with no
//! monitor, with one that watches the states of all components in each cycle, with one and with 20 that watch all
//! information too, in one run. One more sets a parameter ten times a second. The printed time is what the link's two
//! halves take in a cycle.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant as Clock};

use bica::runner::{Cycle, Observer, Request, Requests, Runner};
use bica::{Instant, Probe, Refusal, Tree};
use bica_app::STACK_BYTES;
use bica_evaluation::statistics::percentile;
use bica_link::{Address, Client, ClientOptions, LinkObserver, LinkRequests, LinkServer, ServerOptions};
use bica_motion::robot::Sensors;
use bica_player::Model;
use bica_player::input::RobotProfile;
use bica_player::tunable::Forward;
use bica_player_program::game::WorldKind;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Frame, Setup};
use bica_wire::message::{Setting, Value};

/// Time of a cycle.
const CYCLE: Duration = Duration::from_millis(10);

fn main() {
    thread::Builder::new().stack_size(STACK_BYTES).spawn(run).expect("a thread").join().expect("no panic");
}

fn run() {
    let seconds = std::env::args().nth(1).and_then(|text| text.parse().ok()).unwrap_or(10_u64);
    let cases: [(usize, Action, &str); 4] =
        [(0, watch, ""), (1, states, " of states"), (1, watch, " of everything"), (20, watch, " of everything")];
    for (monitors, action, of) in cases {
        measure(monitors, action, of, seconds);
    }
}

fn measure(monitors: usize, action: Action, of: &str, seconds: u64) {
    let world = KinematicWorld::<Model>::new(&Setup { frame: Frame::Small, ..Setup::default() }).expect("valid");
    let mut robot = Box::new(Forward::new());
    robot.get_mut::<RobotProfile>().set(WorldKind::BuiltIn.profile());
    let address: Address = "127.0.0.1:0".parse().expect("an address");
    let (server, requests, observer) =
        LinkServer::start::<Forward>(&address, ServerOptions::default()).expect("the server starts");
    let address: Address = server.address().parse().expect("an address");
    let mut runner = Runner::new(robot, world)
        .with_requests(TimedRequests { inner: requests, spent: Duration::ZERO })
        .with_observer(TimedObserver { inner: observer, spent: Duration::ZERO });
    let stop = Arc::new(AtomicBool::new(false));
    let watchers: Vec<_> = (0..monitors).map(|_| spawn(&address, &stop, action)).collect();
    let operator = (monitors > 0).then(|| spawn(&address, &stop, operate));
    let (mut spent, began) = (Vec::new(), Clock::now());
    for cycle in 0..seconds as u32 * 100 {
        thread::sleep((began + CYCLE * cycle).saturating_duration_since(Clock::now()));
        runner.cycle().expect("the image fits");
        let requests = std::mem::take(&mut runner.requests_mut().spent);
        let observer = std::mem::take(&mut runner.observer_mut().spent);
        spent.push((requests + observer).as_secs_f64() * 1e6);
    }
    stop.store(true, Ordering::Relaxed);
    // The loop still answers, so that all monitors end.
    while watchers.iter().chain(&operator).any(|thread| !thread.is_finished()) {
        runner.cycle().expect("the image fits");
        thread::sleep(CYCLE);
    }
    let received: usize = watchers.into_iter().map(|thread| thread.join().expect("no panic").len()).sum();
    let delays = operator.map(|thread| thread.join().expect("no panic")).unwrap_or_default();
    spent.sort_by(f64::total_cmp);
    let mean = spent.iter().sum::<f64>() / spent.len() as f64;
    let [p50, p99, max] = [0.5, 0.99, 1.0].map(|part| percentile(&spent, part).unwrap_or_default());
    println!(
        "{monitors} monitors{of}: mean {mean:.1} µs, p50 {p50:.1} µs, p99 {p99:.1} µs, max {max:.1} µs a cycle; {received} messages received"
    );
    if let Some(most) = delays.iter().max() {
        println!(
            "  {} parameters set; in force at most {most} cycles after the next one at their arrival",
            delays.len()
        );
    }
}

type Action = fn(&mut Client, &AtomicBool) -> Vec<u64>;

fn spawn(address: &Address, stop: &Arc<AtomicBool>, action: Action) -> thread::JoinHandle<Vec<u64>> {
    let (address, stop) = (address.clone(), Arc::clone(stop));
    thread::spawn(move || {
        let options = ClientOptions { timeout: Duration::from_mins(1), ..ClientOptions::default() };
        action(&mut Client::connect(&address, options).expect("a robot answers"), &stop)
    })
}

/// Watches states; returns one entry for each event.
fn states(client: &mut Client, stop: &AtomicBool) -> Vec<u64> {
    client.watch(1).expect("connected");
    receive(client, stop)
}

/// Watches states and information; returns one entry for each event.
fn watch(client: &mut Client, stop: &AtomicBool) -> Vec<u64> {
    client.watch(1).expect("connected");
    let counts: Vec<_> = client.description().components.iter().map(|component| component.info.len()).collect();
    for (component, count) in counts.into_iter().enumerate() {
        (0..count).for_each(|info| client.watch_info(component, info, 1).expect("connected"));
    }
    receive(client, stop)
}

fn receive(client: &mut Client, stop: &AtomicBool) -> Vec<u64> {
    let mut events = Vec::new();
    while !stop.load(Ordering::Relaxed) {
        events.extend(client.poll(Duration::from_millis(50)).expect("connected").map(|_| 0));
    }
    events
}

/// Sets a parameter; returns the delay of each request, cycles.
fn operate(client: &mut Client, stop: &AtomicBool) -> Vec<u64> {
    client.acquire(false).expect("nobody else operates");
    let (component, index) = client.description().param("FaceBall.gain").expect("the forward has it");
    let mut delays = Vec::new();
    while !stop.load(Ordering::Relaxed) {
        let value = Value::F32(0.5 + 0.001 * (delays.len() % 100) as f32);
        let setting = Setting::new(bica::ComponentId::new(component), index as u16, value);
        let answer = client.request(Request::Params(&[setting])).expect("accepted");
        delays.push(answer.cycle - answer.arrived);
        thread::sleep(Duration::from_millis(100));
    }
    delays
}

struct TimedRequests {
    inner: LinkRequests,
    spent: Duration,
}

impl Requests for TimedRequests {
    fn next(&mut self, now: Instant) -> Option<Request<'_>> {
        let began = Clock::now();
        let request = self.inner.next(now);
        self.spent += began.elapsed();
        request
    }

    fn answered(&mut self, now: Instant, result: Result<(), Refusal>) {
        let began = Clock::now();
        self.inner.answered(now, result);
        self.spent += began.elapsed();
    }
}

struct TimedObserver {
    inner: LinkObserver<Forward>,
    spent: Duration,
}

impl Probe for TimedObserver {}

impl Observer<Forward> for TimedObserver {
    fn sensing(&mut self, now: Instant, sensors: &Sensors<'_>) {
        let began = Clock::now();
        self.inner.sensing(now, sensors);
        self.spent += began.elapsed();
    }

    fn acted(&mut self, cycle: &Cycle<'_, Forward>) {
        let began = Clock::now();
        self.inner.acted(cycle);
        self.spent += began.elapsed();
    }
}
