//! A robot behind a link.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::channel;
use std::thread::JoinHandle;
use std::time::Duration;

use bica_game::{GameControl, NextStep, Rules, ServeOptions, WorldKind, play_controlled};
use bica_link::Address;
use bica_sim::setup::Frame;
use jmanager::protocol::{HoldKind, Open, Request, Setting};
use jmanager::sessions::Manager;
use serde_json::json;

use crate::page::{Folder, Page};
use crate::world::find;

/// A robot: a game that is served by a thread.
pub(crate) struct Robot {
    pub(crate) address: String,
    end: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

struct Until(Arc<AtomicBool>);

impl GameControl for Until {
    fn next(&mut self, _is_over: bool) -> NextStep {
        if self.0.load(Ordering::Relaxed) { NextStep::End } else { NextStep::Cycle }
    }
}

impl Robot {
    pub(crate) fn start(address: &str) -> Self {
        let (end, (ready, started)) = (Arc::new(AtomicBool::new(false)), channel());
        let (mut until, address) = (Until(Arc::clone(&end)), Address::Tcp(address.to_owned()));
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

#[test]
fn a_lost_robot_is_found_again_and_nothing_old_is_executed() {
    let folder = Folder::new();
    let manager = Manager::new(folder.options());
    let page = Page::new(&manager);
    let robot = Robot::start("127.0.0.1:0");
    let address = robot.address.clone();
    let session = manager.open(Open::Robot { address: format!("tcp://{address}") }).unwrap();
    let description = page.message("described", |message| Some(message["description"].clone()));
    page.session(|one| one["connection"] == "connected");
    page.ask(Request::Acquire { session }).unwrap();
    let (component, param) = find(&description, "FaceBall", "params", "gain");
    page.ask(Request::Hold { session, component, hold: HoldKind::Active }).unwrap();
    drop(robot);
    page.session(|one| one["connection"] == "lost");
    let settings = vec![Setting { component, param, value: json!(0.9) }];
    let error = page.ask(Request::Set { session, settings }).unwrap_err();
    assert!(!error["text"].as_str().unwrap().is_empty(), "{error}");

    let robot = Robot::start(&address);
    let description = page.message("described", |message| Some(message["description"].clone()));
    page.session(|one| one["connection"] == "connected" && one["control"] == "free");
    assert_eq!(description["components"][component]["params"][param]["value"], json!(0.7), "nothing was kept");
    let held = page.message("update", |update| Some(update["components"][component][1].clone()));
    assert_eq!(held, "tree");
    let error = page.ask(Request::Hold { session, component, hold: HoldKind::Active }).unwrap_err();
    assert!(error["text"].as_str().unwrap().contains("does not control"), "{error}");
    drop(robot);
}

#[test]
fn an_address_without_a_robot_is_tried_until_there_is_one() {
    let folder = Folder::new();
    let manager = Manager::new(folder.options());
    let page = Page::new(&manager);
    let first = Robot::start("127.0.0.1:0");
    let address = first.address.clone();
    drop(first);
    let session = manager.open(Open::Robot { address: address.clone() }).unwrap();
    let info = page.session(|one| !one["note"].as_str().unwrap().is_empty());
    assert_eq!(info["connection"], "connecting");
    assert!(page.ask(Request::Acquire { session }).is_err());
    let _robot = Robot::start(&address);
    page.session(|one| one["connection"] == "connected");
    assert!(manager.open(Open::Robot { address: "nowhere".to_owned() }).is_err());
}

#[test]
fn a_server_for_watching_refuses_all_that_changes_something() {
    let folder = Folder::new();
    let options = jmanager::sessions::Options { read_only: true, ..folder.options() };
    let manager = Manager::new(options);
    let (page, session, _) = crate::world::running(&manager);
    for request in [
        Request::Acquire { session },
        Request::Pause { session },
        Request::Restart { session, seed: None },
        Request::KeepRecording { session, name: "a".to_owned() },
        Request::SaveTune { session, params: vec![(0, 0)], name: "a".to_owned() },
        Request::SaveLayout { name: "a".to_owned(), layout: json!({}) },
        Request::Close { session },
    ] {
        let error = page.ask(request.clone()).unwrap_err();
        assert!(error["text"].as_str().unwrap().contains("only watch"), "{request:?}: {error}");
    }
}

#[test]
fn changed_values_are_saved_to_a_tune_file_and_are_in_force_in_the_next_world() {
    let folder = Folder::new();
    let manager = Manager::new(folder.options());
    let (page, session, description) = crate::world::running(&manager);
    let (component, param) = find(&description, "FaceBall", "params", "gain");
    page.ask(Request::Acquire { session }).unwrap();
    let settings = vec![Setting { component, param, value: json!(0.9) }];
    page.ask(Request::Set { session, settings }).unwrap();
    let save = |name: &str| Request::SaveTune { session, params: vec![(component, param)], name: name.to_owned() };
    assert!(page.ask(save("../built-in")).is_err());
    let saved = page.ask(save("built-in")).unwrap();
    let text = std::fs::read_to_string(saved["path"].as_str().unwrap()).unwrap();
    assert!(text.contains("[FaceBall]\ngain = 0.9"), "{text}");
    page.ask(Request::Restart { session, seed: None }).unwrap();
    let gain = page.message("described", |message| {
        Some(message["description"]["components"][component]["params"][param]["value"].clone())
    });
    assert_eq!(gain, json!(0.9));
}

#[test]
fn layouts_are_kept() {
    let folder = Folder::new();
    let manager = Manager::new(folder.options());
    let page = Page::new(&manager);
    let save = |layout| Request::SaveLayout { name: "mine".to_owned(), layout };
    assert_eq!(page.ask(Request::Layouts {}).unwrap(), json!({}));
    page.ask(save(json!({ "panels": [1, 2] }))).unwrap();
    assert_eq!(page.ask(Request::Layouts {}).unwrap(), json!({ "mine": { "panels": [1, 2] } }));
    page.ask(save(json!(null))).unwrap();
    assert_eq!(page.ask(Request::Layouts {}).unwrap(), json!({}));
}
