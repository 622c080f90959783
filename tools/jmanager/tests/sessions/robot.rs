//! A robot behind a link.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::channel;
use std::thread::JoinHandle;
use std::time::Duration;

use bica::Hold;
use bica_link::{Address, Client, ClientOptions, Plain};
use bica_monitor::protocol::{Breakpoint, Open, Request, Watch, WatchImages};
use bica_monitor::sessions::Options;
use bica_player_program::game::{GameControl, NextStep, Rules, ServeOptions, WorldKind, play_controlled};
use bica_sim::setup::Frame;
use serde_json::{Value, json};

use crate::sessions::page::{Bench, Folder, Got, Page};
use crate::sessions::world::{find, hold, pose_of, set_gain};

/// A robot: a game that is served by a thread.
pub(crate) struct Robot {
    pub(crate) address: String,
    end: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

/// The end of a game, and whether operators may pause it: a robot's time goes on.
struct Until(Arc<AtomicBool>, bool);

impl GameControl for Until {
    fn next(&mut self, _is_over: bool) -> NextStep {
        if self.0.load(Ordering::Relaxed) { NextStep::End } else { NextStep::Cycle }
    }

    fn lets_operators_pause(&self) -> bool {
        self.1
    }
}

impl Robot {
    /// A world that can be paused.
    pub(crate) fn start(address: &str) -> Self {
        Self::serve(address, true)
    }

    pub(crate) fn serve(address: &str, pauses: bool) -> Self {
        let (end, (ready, started)) = (Arc::new(AtomicBool::new(false)), channel());
        let (mut until, address) = (Until(Arc::clone(&end), pauses), Address::Tcp(address.to_owned()));
        let thread = std::thread::spawn(move || {
            let rules = Rules {
                world: WorldKind::BuiltIn,
                seed: 1,
                size: Frame::Small,
                robots: 1,
                limit: Duration::MAX,
                realtime: true,
                firmware: None,
                settings: &[],
                options: &[],
            };
            let started = |address: &str| {
                ready.send(address.to_owned()).unwrap();
                Ok(())
            };
            let serve = ServeOptions { address: &address, anywhere: false, started: &started };
            play_controlled(&rules, &mut (), &mut until, None, Some(serve)).map(drop).unwrap();
        });
        Self { address: started.recv().unwrap(), end, thread: Some(thread) }
    }
}

impl Drop for Robot {
    fn drop(&mut self) {
        self.end.store(true, Ordering::Relaxed);
        let _ = self.thread.take().unwrap().join();
    }
}

/// Opens a robot on a new page, and waits for its description.
pub(crate) fn attached(address: &str) -> (Page, Value) {
    let page = Page::new(&Bench::new());
    page.open(Open::Robot { address: address.to_owned() });
    let description = page.message("described", |message| Some(message["description"].clone()));
    (page, description)
}

#[test]
fn a_lost_robot_is_found_again_and_nothing_old_is_executed() {
    let robot = Robot::start("127.0.0.1:0");
    let address = robot.address.clone();
    let (page, description) = attached(&format!("tcp://{address}"));
    page.session(|one| one["connection"] == "connected");
    page.ask(Request::Acquire {}).unwrap();
    let (component, param) = find(&description, "FaceBall", "params", "gain");
    page.ask(hold("FaceBall", Hold::Active)).unwrap();
    drop(robot);
    page.session(|one| one["connection"] == "lost");
    let error = page.ask(set_gain(Plain::Number(0.9))).unwrap_err();
    assert!(!error["text"].as_str().unwrap().is_empty(), "{error}");

    let robot = Robot::start(&address);
    let description = page.message("described", |message| Some(message["description"].clone()));
    page.session(|one| one["connection"] == "connected" && one["control"] == "free");
    assert_eq!(description["components"][component]["params"][param]["value"], json!(0.7), "nothing was kept");
    let held = page.message("update", |update| Some(update["components"][component][1].clone()));
    assert_eq!(held, "tree");
    let error = page.ask(hold("FaceBall", Hold::Active)).unwrap_err();
    assert!(error["text"].as_str().unwrap().contains("does not control"), "{error}");
    drop(robot);
}

#[test]
fn a_world_behind_a_link_shows_all_that_a_world_of_this_process_shows() {
    let robot = Robot::start("127.0.0.1:0");
    let (page, description) = attached(&robot.address);
    let info = page.session(|one| one["connection"] == "connected");
    for capability in ["operate", "pause", "truth", "images", "costs", "conditions"] {
        assert_eq!(info["can"][capability], true, "{capability}");
    }
    let components = description["components"].as_array().unwrap();
    let root = description["root"].as_u64().unwrap() as usize;
    let images = Some(WatchImages { max_hz: 30.0 });
    let watch = Watch { conditions: vec![root], costs: true, truth: true, images, ..Watch::default() };
    page.ask(Request::Watch { watch }).unwrap();
    let frame = page.wait("an image", |got| match got {
        Got::Binary(frame) => Some(frame.clone()),
        Got::Message(_) => None,
    });
    assert_eq!((frame[0], frame.len()), (1, 32 + usize::from(frame[1]) + 160 * 120 * 2));
    let conditions = page.message("conditions", |message| {
        let conditions = message["conditions"].as_array()?;
        let is_known = conditions.iter().any(|one| one["holds"].is_boolean());
        is_known.then_some(conditions.len())
    });
    assert_eq!(conditions, components[root]["transitions"].as_array().unwrap().len());
    let truth = page.message("truth", |truth| Some(truth["truth"].clone()));
    assert!(pose_of(&truth, "robot").iter().all(|number| number.is_finite()), "{truth}");
    assert_ne!(pose_of(&truth, "ball")[..2], [0.0, 0.0]);
    let costs = page.message("costs", |costs| (costs["window_us"] == 500_000).then(|| costs.clone()));
    let costs = costs["components"].as_array().unwrap();
    assert_eq!(costs.len(), components.len());
    assert!(costs.iter().any(|one| one[0] == 50 && one[1].as_f64().unwrap() > 0.0));
}

#[test]
fn a_world_behind_a_link_is_paused_stepped_and_continued() {
    let robot = Robot::start("127.0.0.1:0");
    let (page, _) = attached(&robot.address);
    page.cycle(6);
    page.send(Request::Pause {});
    page.session(|one| one["paused"] == true && one["control"] == "free");
    page.ask(Request::Acquire {}).unwrap();
    let next = page.ask(set_gain(Plain::Number(0.9))).unwrap()["cycle"].as_u64().unwrap();
    page.ask(Request::Step { cycles: 3 }).unwrap();
    let last = page.message("update", |update| update["cycle"].as_u64().filter(|&cycle| cycle >= next + 2));
    assert_eq!(last, next + 2, "three cycles");
    page.ask(Request::Step { cycles: 2 }).unwrap();
    let last = page.message("update", |update| update["cycle"].as_u64().filter(|&cycle| cycle > next + 3));
    assert_eq!(last, next + 4, "two more");
    page.ask(Request::Release {}).unwrap();
    let mut other = Client::connect(&robot.address.parse().unwrap(), ClientOptions::default()).unwrap();
    other.acquire(true).unwrap();
    let error = page.ask(Request::Resume {}).unwrap_err();
    assert!(error["text"].as_str().unwrap().contains("another monitor"), "{error}");
    other.release().unwrap();
    page.send(Request::Resume {});
    page.session(|one| one["paused"] == false);
    page.cycle(next + 21);
}

#[test]
fn an_address_without_a_robot_is_tried_until_there_is_one() {
    let page = Page::new(&Bench::new());
    let first = Robot::start("127.0.0.1:0");
    let address = first.address.clone();
    drop(first);
    page.open(Open::Robot { address: address.clone() });
    let info = page.session(|one| !one["note"].as_str().unwrap().is_empty());
    assert_eq!(info["connection"], "connecting");
    assert!(page.ask(Request::Acquire {}).is_err());
    let _robot = Robot::start(&address);
    page.session(|one| one["connection"] == "connected");
    assert!(page.bench.manager.open(Open::Robot { address: "nowhere".to_owned() }).is_err());
}

#[test]
fn a_read_only_server_refuses_every_change() {
    let bench = Bench::with(Folder::new("sessions"), |options| Options { read_only: true, ..options });
    let (page, description) = crate::sessions::world::running_on(&bench);
    let address = "tcp://127.0.0.1:1".to_owned();
    for request in [
        Request::Open { source: Open::Robot { address } },
        Request::Note { text: "a".to_owned() },
        Request::Acquire {},
        Request::Pause {},
        Request::Restart { seed: None },
        Request::KeepRecording { name: "a".to_owned() },
        Request::SaveTune { params: vec![(0, 0)], name: "a".to_owned() },
        Request::SaveLayout { name: "a".to_owned(), layout: json!({}) },
        Request::Close {},
    ] {
        let error = page.ask(request.clone()).unwrap_err();
        assert!(error["text"].as_str().unwrap().contains("only watch"), "{request:?}: {error}");
    }
    let component = description["root"].as_u64().unwrap() as usize;
    let states = description["components"][component]["states"].as_array().unwrap().len();
    let list = (0..states).map(|state| Breakpoint { component, state: Some(state), transition: None }).collect();
    page.ask(Request::Breakpoints { list }).unwrap();
    assert_eq!(page.message("hit", |hit| Some(hit["paused"].clone())), false);
}

#[test]
fn changed_values_are_saved_to_a_tune_file_and_are_in_force_in_the_next_world() {
    let (page, description) = crate::sessions::world::running();
    let (component, param) = find(&description, "FaceBall", "params", "gain");
    page.ask(Request::Acquire {}).unwrap();
    page.ask(set_gain(Plain::Number(0.9))).unwrap();
    let save = |name: &str| Request::SaveTune { params: vec![(component, param)], name: name.to_owned() };
    assert!(page.ask(save("../built-in")).is_err());
    let saved = page.ask(save("built-in")).unwrap();
    let text = std::fs::read_to_string(saved["path"].as_str().unwrap()).unwrap();
    assert!(text.contains("[FaceBall]\ngain = 0.9"), "{text}");
    page.ask(Request::Restart { seed: None }).unwrap();
    let gain = page.message("described", |message| {
        Some(message["description"]["components"][component]["params"][param]["value"].clone())
    });
    assert_eq!(gain, json!(0.9));
}

#[test]
fn layouts_are_kept() {
    let page = Page::new(&Bench::new());
    let save = |layout| Request::SaveLayout { name: "mine".to_owned(), layout };
    assert_eq!(page.ask(Request::Layouts {}).unwrap(), json!({}));
    page.ask(save(json!({ "panels": [1, 2] }))).unwrap();
    assert_eq!(page.ask(Request::Layouts {}).unwrap(), json!({ "mine": { "panels": [1, 2] } }));
    page.ask(save(json!(null))).unwrap();
    assert_eq!(page.ask(Request::Layouts {}).unwrap(), json!({}));
}
