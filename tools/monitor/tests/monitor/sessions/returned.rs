//! A robot whose link returns after a short cut.

use std::io::copy;
use std::net::{Shutdown, TcpListener, TcpStream};
use std::sync::{Arc, Mutex};
use std::thread;

use bica_monitor::protocol::{Open, Request};
use bica_recording::Recording;
use serde_json::Value;

use crate::lamp::{CYCLE, CYCLE_US};
use crate::page::{Bench, Page};
use crate::served::Served;

/// Number of the first cycle of a lamp that has shone for a thousand seconds, and its time, µs.
const LONG_LIT: (u64, u64) = (1_000_000_000 / CYCLE_US, 1_000_000_000);

/// The robot to which a cable leads, none while it is cut; and its connections.
#[derive(Default)]
struct Ends {
    robot: Option<String>,
    streams: Vec<TcpStream>,
}

/// A cable to a robot that can be cut.
struct Cable {
    address: String,
    ends: Arc<Mutex<Ends>>,
}

impl Cable {
    fn to(robot: &str) -> Self {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let address = listener.local_addr().unwrap().to_string();
        let ends = Arc::new(Mutex::new(Ends { robot: Some(robot.to_owned()), ..Ends::default() }));
        let own = Arc::clone(&ends);
        thread::spawn(move || {
            for near in listener.incoming().map_while(Result::ok) {
                let mut ends = own.lock().unwrap();
                let Some(far) = ends.robot.as_ref().and_then(|robot| TcpStream::connect(robot).ok()) else { continue };
                for (mut from, mut to) in [
                    (near.try_clone().unwrap(), far.try_clone().unwrap()),
                    (far.try_clone().unwrap(), near.try_clone().unwrap()),
                ] {
                    thread::spawn(move || copy(&mut from, &mut to));
                }
                ends.streams.extend([near, far]);
            }
        });
        Self { address, ends }
    }

    fn cut(&self) {
        let mut ends = self.ends.lock().unwrap();
        ends.robot = None;
        for stream in ends.streams.drain(..) {
            let _ = stream.shutdown(Shutdown::Both);
        }
    }

    fn mend(&self, robot: &str) {
        self.ends.lock().unwrap().robot = Some(robot.to_owned());
    }
}

/// Waits for a state after a time, µs; returns its time.
fn later(page: &Page, than: u64) -> u64 {
    page.message("update", |update| update["time_us"].as_u64().filter(|time| *time > than))
}

/// Opens a lamp that has shone for long, watches it for a while, and cuts its cable. Returns the last time that a page received, µs.
fn watched_and_cut(page: &Page, cable: &Cable) -> u64 {
    page.open(Open::Robot { address: cable.address.clone() });
    page.session(|one| one["connection"] == "connected");
    let begin = later(page, LONG_LIT.1 - 1);
    page.ask(Request::Note { text: "before".to_owned() }).unwrap();
    let last = later(page, begin + 400_000);
    cable.cut();
    page.session(|one| one["connection"] == "lost");
    last
}

fn bars(page: &Page) -> Vec<(u64, u64)> {
    let rows = page.ask(Request::Timeline { from_us: 0, until_us: u64::MAX, resolution_us: 0 }).unwrap();
    let bar = |bar: &Value| (bar[0].as_u64().unwrap(), bar[1].as_u64().unwrap());
    rows[0]["bars"].as_array().unwrap().iter().map(bar).collect()
}

#[test]
fn returned_link_continues_the_history_after_a_gap() {
    let lamp = Served::device_at(LONG_LIT.0);
    let (page, cable) = (Page::new(&Bench::new()), Cable::to(&lamp.address));
    let last = watched_and_cut(&page, &cable);
    thread::sleep(40 * CYCLE);
    cable.mend(&lamp.address);
    let returned = page.session(|one| one["connection"] == "connected" && one["gaps"] != serde_json::json!([]));
    let gap = [0, 1].map(|end| returned["gaps"][0][end].as_u64().unwrap());
    assert!(last <= gap[0] && gap[0] + 100_000 < gap[1], "{last} {gap:?}");
    let end = later(&page, gap[1] + 400_000);

    let bars = bars(&page);
    assert!(bars.iter().all(|bar| bar.1 <= gap[0] || bar.0 >= gap[1]), "{bars:?} {gap:?}");
    assert!(bars.iter().any(|bar| bar.1 == gap[0]) && bars.iter().any(|bar| bar.0 == gap[1]), "{bars:?} {gap:?}");
    let time_us = gap[0].midpoint(gap[1]);
    let moment = page.ask(Request::At { time_us, outputs: vec![], image: false }).unwrap();
    assert_eq!(moment["time_us"], gap[0]);
    let lines = page.lines();
    for text in ["before", "the connection was lost", "the connection is restored"] {
        assert!(lines.iter().any(|line| line["text"].as_str().unwrap().starts_with(text)), "{lines:?}");
    }
    page.ask(Request::KeepRecording { name: "both".to_owned() }).unwrap();
    let mut recording = Recording::open(&page.bench.folder.0.join("recordings/both.mcap")).unwrap();
    let mut times = Vec::new();
    while let Some(cycle) = recording.next_cycle().unwrap() {
        times.push(cycle.tick.instant);
    }
    assert!(times[0] <= last && times.last() >= Some(&end), "{times:?}");
    assert!(times.windows(2).any(|pair| pair == gap), "{times:?} {gap:?}");
}

#[test]
fn restarted_or_other_robot_has_an_empty_history() {
    for first in [0, 10 * LONG_LIT.0] {
        let lamp = Served::device_at(LONG_LIT.0);
        let (page, cable) = (Page::new(&Bench::new()), Cable::to(&lamp.address));
        let last = watched_and_cut(&page, &cable);
        let other = Served::device_at(first);
        cable.mend(&other.address);
        page.message("described", |_| Some(()));
        let shown = page.message("update", |update| update["time_us"].as_u64());
        assert!(shown < LONG_LIT.1 || shown > last + LONG_LIT.1, "no cycle of the first robot is shown: {shown}");
        let bars = bars(&page);
        assert!(bars.iter().all(|bar| bar.1 < LONG_LIT.1 || bar.0 > last), "{first}: {bars:?}");
        // A new page receives the current state of the session.
        let late = Page::new(&page.bench);
        let sessions = late.message("hello", |hello| Some(hello["sessions"].clone()));
        assert_eq!(sessions[0]["gaps"], serde_json::json!([]), "{first}");
    }
}
