//! A robot with another tree than the forward's.

use std::convert::Infallible;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::JoinHandle;
use std::time::Duration;

use bica::Hold;
use bica::prelude::*;
use bica::runner::{Runner, World};
use bica_link::{Address, LinkServer, NamedRequest, ServerOptions};
use bica_monitor::protocol::{Breakpoint, Open, Request};
use bica_monitor::sessions::Options;
use serde_json::json;

use crate::sessions::page::{Bench, Folder, Page};
use crate::sessions::robot::{Robot, attached};
use crate::sessions::world::{find, hold};

/// A lamp, with two transitions between the same states and one from a state to itself.
struct Lamp {
    cycles: u32,
    stands: bool,
}

/// Shines.
#[component]
impl Lamp {
    const fn new() -> Self {
        Self { cycles: 0, stands: false }
    }

    /// Is on.
    #[state(initial)]
    fn on(&mut self) {
        self.cycles += u32::from(!self.stands);
    }

    /// Is off.
    #[state]
    fn off(&mut self) {
        self.cycles += u32::from(!self.stands);
    }

    /// Stays on.
    #[transition(on -> on)]
    const fn is_kept(&self) -> bool {
        self.cycles % 8 == 3
    }

    /// Is put out.
    #[transition(on -> off)]
    const fn is_put_out(&self) -> bool {
        self.cycles % 16 == 5
    }

    /// Breaks.
    #[transition(on -> off)]
    const fn is_broken(&self) -> bool {
        self.cycles % 16 == 13
    }

    /// Is lit.
    #[transition(off -> on)]
    const fn is_lit(&self) -> bool {
        self.cycles % 8 == 7
    }

    /// Changes no more.
    #[modulation(stop)]
    fn stop(&mut self) {
        self.stands = true;
    }

    /// Goes on.
    #[modulation]
    fn start(&mut self) {
        self.stands = false;
    }
}

activation_tree! {
    /// A lamp.
    struct LampTree { root: Lamp, cycle_hz: 50, components: [Lamp] }
}

impl bica::runner::Robot for LampTree {
    type Sensors<'a> = ();
    type Command = ();
    type Error = Infallible;

    fn sense(&mut self, (): &()) -> Result<(), Infallible> {
        Ok(())
    }

    fn act(&mut self) {}
}

pub(crate) struct Room(pub(crate) u64);

impl World<LampTree> for Room {
    fn now(&self) -> bica::Instant {
        bica::Instant::from_millis(20 * self.0)
    }

    fn sensors(&mut self) {}

    fn act(&mut self, (): &()) {
        self.0 += 1;
    }
}

/// A lamp that is served until this is dropped.
pub(crate) struct Served {
    pub(crate) address: String,
    end: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Served {
    /// Serves a lamp in a room, with a time between two cycles.
    pub(crate) fn new(room: Room, between: Duration, address: &str) -> Self {
        let address = Address::Tcp(address.to_owned());
        let (server, requests, observer) = LinkServer::start::<LampTree>(&address, ServerOptions::default()).unwrap();
        let address = server.address().to_owned();
        let end = Arc::<AtomicBool>::default();
        let ended = Arc::clone(&end);
        let thread = std::thread::spawn(move || {
            let runner = Runner::new(Box::new(LampTree::new()), room);
            let mut runner = runner.with_requests(requests).with_observer(observer);
            while !ended.load(Ordering::Relaxed) {
                runner.cycle().unwrap();
                std::thread::sleep(between);
            }
            drop(server);
        });
        Self { address, end, thread: Some(thread) }
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        self.end.store(true, Ordering::Relaxed);
        let _ = self.thread.take().unwrap().join();
    }
}

/// In each cycle of 20 ms one is added to what the conditions look at.
#[test]
fn a_breakpoint_behind_a_link_is_reached_by_its_transition_only() {
    let lamp = Served::new(Room(0), Duration::from_millis(5), "127.0.0.1:0");
    let (page, description) = attached(&lamp.address);
    page.session(|one| one["connection"] == "connected");
    for (name, period, rest) in [("is_broken", 16, 13), ("is_kept", 8, 3)] {
        let (component, transition) = find(&description, "Lamp", "transitions", name);
        let place = Breakpoint { component, state: None, transition: Some(transition) };
        page.ask(Request::Breakpoints { list: vec![place] }).unwrap();
        let hit = || {
            let time =
                |hit: &serde_json::Value| (hit["transition"] == transition).then(|| hit["time_us"].as_u64().unwrap());
            page.message("hit", time)
        };
        let times = [hit(), hit(), hit()];
        assert!(times.iter().all(|time| time / 20_000 % period == rest), "{name}: {times:?}");
        let next = page.ask(Request::NextHit { from_us: times[0] }).unwrap()["time_us"].as_u64().unwrap();
        assert_eq!(next, times[1]);
    }
}

#[test]
fn each_page_stops_and_none_starts_without_control() {
    let lamp = Served::new(Room(0), Duration::from_millis(5), "127.0.0.1:0");
    let (operator, _) = attached(&lamp.address);
    let beside = Page::new(&operator.bench);
    beside.session.set(operator.session.get());
    let of_reader = Bench::with(Folder::new("sessions"), |options| Options { read_only: true, ..options });
    let reader = Page::new(&of_reader);
    reader.open(Open::Robot { address: lamp.address.clone() });
    reader.message("described", |_| Some(()));
    let (component, modulation, arguments) = ("Lamp".to_owned(), "start".to_owned(), vec![]);
    let start = Request::Operate { request: NamedRequest::Modulate { component, modulation, arguments } };
    operator.session(|session| session["connection"] == "connected");
    for other in [&beside, &reader] {
        operator.ask(Request::Acquire {}).unwrap();
        operator.ask(hold("Lamp", Hold::Latent)).unwrap();
        assert!(other.ask(start.clone()).is_err());
        other.ask(Request::Stop {}).unwrap();
        operator.session(|session| session["control"] == "free");
        operator.message("update", |update| (update["components"][0][1] == "tree").then_some(()));
        assert!([other, &operator].iter().all(|page| page.ask(start.clone()).is_err()));
    }
}

/// Attack 15.
#[test]
fn another_robot_at_the_address_is_shown_as_such_and_nothing_of_the_first_is_in_force() {
    let robot = Robot::start("127.0.0.1:0");
    let address = robot.address.clone();
    let (page, description) = attached(&address);
    page.session(|one| one["connection"] == "connected");
    page.ask(Request::Acquire {}).unwrap();
    page.ask(hold("LookAround", Hold::Latent)).unwrap();
    let place = Breakpoint { component: 0, state: Some(0), transition: None };
    page.ask(Request::Breakpoints { list: vec![place] }).unwrap();
    drop(robot);
    page.session(|one| one["connection"] == "lost");
    let _lamp = Served::new(Room(0), Duration::from_millis(5), &address);
    let other = page.message("described", |message| Some(message["description"].clone()));
    assert_eq!(other["name"], "LampTree");
    assert_ne!((&other["name"], &other["hash"]), (&description["name"], &description["hash"]));
    page.message("breakpoints", |message| (message["list"] == json!([])).then_some(()));
    page.session(|one| one["connection"] == "connected" && one["control"] == "free");
    let held = page.message("update", |update| Some(update["components"].clone()));
    assert_eq!((held.as_array().unwrap().len(), &held[0][1]), (1, &json!("tree")));
    let error = page.ask(hold("Lamp", Hold::Latent)).unwrap_err();
    assert!(error["text"].as_str().unwrap().contains("does not control"), "{error}");
    let request = Request::Timeline { from_us: 0, until_us: u64::MAX, resolution_us: 0 };
    assert_eq!(page.ask(request).unwrap().as_array().unwrap().len(), 1, "rows of the new tree only");
}
