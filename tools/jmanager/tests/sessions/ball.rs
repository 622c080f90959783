//! The ball of a simulated world, which the operator places.

use std::path::PathBuf;
use std::time::Duration;

use bica_game::{ReplayOptions, replay};
use jmanager::protocol::{Open, Request, Watch};
use jmanager::sessions::Manager;
use serde_json::json;

use crate::page::{Folder, Page};
use crate::robot::{Robot, attached};
use crate::world::running;

fn ball(session: u32, x: f32, y: f32) -> Request {
    Request::PlaceBall { session, x, y }
}

/// Waits until the true state has the ball at a position.
fn lies_at(page: &Page<'_>, x: f32, y: f32) {
    page.state("truth", |message| (message["truth"]["ball"] == json!([x, y])).then_some(()));
}

#[test]
fn the_operator_places_the_ball_of_a_running_and_of_a_paused_world() {
    let folder = Folder::new();
    let manager = Manager::new(folder.options());
    let (page, session, _) = running(&manager);
    page.ask(Request::Watch { session, watch: Watch { truth: true, ..Watch::default() } }).unwrap();
    let error = page.ask(ball(session, 1.0, 0.5)).unwrap_err();
    assert!(error["text"].as_str().unwrap().contains("does not control"), "{error}");
    page.ask(Request::Acquire { session }).unwrap();
    page.ask(ball(session, -2.5, 1.75)).unwrap();
    lies_at(&page, -2.5, 1.75);
    for (x, y) in [(3.25, 0.0), (0.0, -2.5)] {
        let error = page.ask(ball(session, x, y)).unwrap_err();
        assert!(error["text"].as_str().unwrap().contains("x must be from -3 to 3 m, y from -2 to 2 m"), "{error}");
        assert!(error["help"].as_str().unwrap().contains("in play"), "{error}");
    }

    page.ask(Request::Pause { session }).unwrap();
    // The last cycles before the pause are still under way.
    std::thread::sleep(Duration::from_millis(300));
    let answer = page.ask(ball(session, 2.5, -1.75)).unwrap();
    lies_at(&page, 2.5, -1.75);
    let now = page.ask(Request::At { session, time_us: u64::MAX, info: vec![], image: false }).unwrap();
    assert_eq!(now["truth"]["ball"], json!([2.5, -1.75]), "it lies there before time goes on");
    page.ask(Request::Step { session, cycles: 1 }).unwrap();
    page.message("update", |update| (update["cycle"] == answer["cycle"]).then_some(()));
    page.ask(Request::Release { session }).unwrap();
    page.session(|session| session["control"] == "free");
    assert!(page.ask(ball(session, 1.0, 0.5)).is_err());
}

#[test]
fn a_kept_recording_of_a_world_with_placements_replays() {
    let folder = Folder::new();
    let manager = Manager::new(folder.options());
    let (page, session, _) = running(&manager);
    page.ask(Request::Acquire { session }).unwrap();
    let mut placed = 0;
    for step in 0..20_u8 {
        // A robot may stand at one of these places.
        placed += usize::from(page.ask(ball(session, f32::from(step) * 0.125, 0.5)).is_ok());
    }
    assert!(placed > 10, "{placed} placements");
    let cycle = page.message("update", |update| update["cycle"].as_u64());
    page.message("update", |update| (update["cycle"].as_u64()? > cycle + 100).then_some(()));
    let kept = page.ask(Request::KeepRecording { session, name: "placed".to_owned() }).unwrap();
    let path = PathBuf::from(kept["path"].as_str().unwrap());
    let options = ReplayOptions::whole(&path);
    let replayed = replay(&options).unwrap();
    assert!(replayed.equal, "{:?}", replayed.first_difference);

    let recording = manager.open(Open::Recording { name: "placed.mcap".to_owned() }).unwrap();
    let info = page.session(|one| one["id"] == recording && one["connection"] == "connected");
    assert_eq!(info["can"]["ball"], false);
    let error = page.ask(ball(recording, 1.0, 0.5)).unwrap_err();
    assert!(error["text"].as_str().unwrap().contains("a recording cannot be operated"), "{error}");
    let lines = page.ask(Request::Lines { session: recording, from_us: 0, until_us: u64::MAX, limit: 1000 }).unwrap();
    let is_placement = |line: &&serde_json::Value| line["text"].as_str().unwrap().starts_with("ball at ");
    assert_eq!(lines.as_array().unwrap().iter().filter(is_placement).count(), placed);
}

#[test]
fn the_ball_of_a_world_behind_a_link_is_placed() {
    let folder = Folder::new();
    let manager = Manager::new(folder.options());
    let robot = Robot::start("127.0.0.1:0");
    let (page, session, _) = attached(&manager, &robot.address);
    let info = page.session(|one| one["connection"] == "connected");
    assert_eq!(info["can"]["ball"], true);
    page.message("update", |update| (update["cycle"].as_u64()? > 5).then_some(()));
    page.ask(Request::Watch { session, watch: Watch { truth: true, ..Watch::default() } }).unwrap();
    assert!(page.ask(ball(session, 1.0, 0.5)).is_err());
    page.ask(Request::Acquire { session }).unwrap();
    page.ask(ball(session, -2.5, 1.75)).unwrap();
    lies_at(&page, -2.5, 1.75);
    page.ask(Request::Pause { session }).unwrap();
    page.session(|one| one["paused"] == true);
    page.ask(ball(session, 2.5, -1.75)).unwrap();
    lies_at(&page, 2.5, -1.75);
}
