//! The built-in world, live.

use std::collections::BTreeMap;
use std::sync::Arc;

use bica::Hold;
use bica_link::{NamedRequest, NamedSetting, Plain};
use bica_monitor::protocol::{Open, Request};
use jmanager::ROBOTS;
use serde_json::{Value, json};

use crate::sessions::page::{Bench, Folder, Got, Page};

fn built_in() -> Open {
    Open::World {
        world: "built-in".to_owned(),
        seed: 1,
        options: BTreeMap::from([(ROBOTS.to_owned(), "1".to_owned())]),
    }
}

/// A value for the gain of the forward's component `FaceBall`.
pub(crate) fn set_gain(value: Plain) -> Request {
    let (component, param) = ("FaceBall".to_owned(), "gain".to_owned());
    Request::Operate { request: NamedRequest::Set { settings: vec![NamedSetting { component, param, value }] } }
}

/// A hold of a component.
pub(crate) fn hold(component: &str, hold: Hold) -> Request {
    Request::Operate { request: NamedRequest::Hold { component: component.to_owned(), hold } }
}

/// Index of a component and of one of its members.
pub(crate) fn find(description: &Value, component: &str, list: &str, name: &str) -> (usize, usize) {
    let components = description["components"].as_array().unwrap();
    let component = components.iter().position(|one| one["name"] == component).unwrap();
    let members = components[component][list].as_array().unwrap();
    (component, members.iter().position(|one| one["name"] == name).unwrap())
}

#[cfg(feature = "mujoco")]
#[test]
fn a_game_in_mujoco_is_shown_with_its_images() {
    use bica_monitor::protocol::{Watch, WatchImages};

    let page = Page::new(&Bench::new());
    page.open(Open::World { world: "mujoco".to_owned(), seed: 1, options: BTreeMap::new() });
    page.message("described", |_| Some(()));
    let watch = Watch { images: Some(WatchImages { max_hz: 30.0 }), truth: true, ..Watch::default() };
    page.ask(Request::Watch { watch }).unwrap();
    page.message("update", |update| (update["cycle"].as_u64()? > 20).then_some(()));
    let truth = page.message("truth", |truth| Some(truth["truth"].clone()));
    assert!(pose_of(&truth, "robot").iter().all(|number| number.is_finite()), "{truth}");
    page.wait("an image", |got| matches!(got, Got::Binary(_)).then_some(()));
}

/// Numbers `x`, `y` and `heading` of something in a true state; those that it lacks are NaN.
pub(crate) fn pose_of(truth: &Value, name: &str) -> [f32; 3] {
    let one = truth.as_array().into_iter().flatten().find(|one| one["name"] == name);
    ["x", "y", "heading"]
        .map(|key| one.and_then(|one| one["value"][key].as_f64()).map_or(f32::NAN, |number| number as f32))
}

/// Opens the built-in world with one page, and waits until it runs.
pub(crate) fn running() -> (Page, Value) {
    running_on(&Bench::new())
}

pub(crate) fn running_on(bench: &Arc<Bench>) -> (Page, Value) {
    let page = Page::new(bench);
    page.open(built_in());
    let described = page.message("described", |message| Some(message.clone()));
    let kinds = described["kinds"].as_array().unwrap().len();
    assert_eq!(kinds, described["description"]["components"].as_array().unwrap().len());
    page.cycle(6);
    (page, described["description"].clone())
}

#[test]
fn unknown_worlds_and_options_are_refused() {
    let bench = Bench::new();
    for (world, name, value) in [("hall", ROBOTS, "1"), ("built-in", "walls", "1"), ("built-in", ROBOTS, "99")] {
        let options = BTreeMap::from([(name.to_owned(), value.to_owned())]);
        let failed = bench.manager.open(Open::World { world: world.to_owned(), seed: 1, options }).unwrap_err();
        assert!(!failed.help.is_empty(), "{failed:?}");
    }
}

/// Attack 4: files of a running world in the folder of temporary files.
#[test]
fn other_users_cannot_read_what_is_recorded() {
    use std::os::unix::fs::PermissionsExt;
    let (page, _) = running();
    let mode = std::fs::metadata(page.bench.folder.0.join("spool")).unwrap().permissions().mode();
    assert_eq!(mode & 0o777, 0o700);
}

#[test]
fn one_page_operates_and_values_are_answered_as_they_are_in_force() {
    let (page, description) = running();
    let (component, param) = find(&description, "FaceBall", "params", "gain");
    let error = page.ask(set_gain(Plain::Number(0.9))).unwrap_err();
    assert!(error["text"].as_str().unwrap().contains("does not control"), "{error}");
    page.ask(Request::Acquire {}).unwrap();
    let answer = page.ask(set_gain(Plain::Number(0.9))).unwrap();
    assert_eq!(answer["values"], json!([0.9]));
    let error = page.ask(set_gain(Plain::Number(1000.0))).unwrap_err();
    assert_eq!(error["entry"], 0, "{error}");
    let error = page.ask(set_gain(Plain::Name("text".to_owned()))).unwrap_err();
    assert_eq!(error["entry"], 0, "{error}");
    for hz in [-1e30, 0.0, 1e6, f32::NAN, f32::INFINITY] {
        let error = page
            .ask(Request::Operate { request: NamedRequest::Rate { component: "FaceBall".to_owned(), hz: Some(hz) } })
            .unwrap_err();
        assert!(error["help"].as_str().unwrap().contains("at most"), "{hz}: {error}");
    }

    let other = Page::new(&page.bench);
    let gain = other.message("described", |message| {
        Some(message["description"]["components"][component]["params"][param]["value"].clone())
    });
    assert_eq!(gain, json!(0.9), "a page that comes later gets the values in force");
    assert_eq!(other.ask(Request::Acquire {}).unwrap_err()["text"], "another page controls the robot");
    other.ask(Request::Take {}).unwrap();
    page.session(|session| session["control"] == "other_page");
    assert!(page.ask(set_gain(Plain::Number(0.8))).is_err());
    assert_eq!(other.ask(set_gain(Plain::Number(0.8))).unwrap()["values"], json!([0.8]));
    drop(other);
    page.message("log", |log| {
        log["lines"][0]["text"].as_str()?.contains("was closed: control has ended").then_some(())
    });
    page.session(|session| session["control"] == "free");
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_a_hold_ends_when_the_page_is_silent() {
    let (page, description) = running();
    let component = description["root"].as_u64().unwrap() as usize;
    page.ask(Request::Acquire {}).unwrap();
    page.ask(hold(description["components"][component]["name"].as_str().unwrap(), Hold::Latent)).unwrap();
    let is = |hold: &'static str| move |update: &Value| (update["components"][component][1] == hold).then_some(());
    page.message("update", is("latent"));
    page.message("update", is("tree"));
    page.session(|session| session["control"] == "free");
}

#[test]
fn a_world_is_paused_stepped_and_begun_again() {
    let (page, _) = running();
    let before = page.paused()["cycle"].as_u64().unwrap();
    page.ask(Request::Step { cycles: 3 }).unwrap();
    page.cycle(before + 3);
    assert_eq!(page.stands()["cycle"], before + 3);
    page.ask(Request::Resume {}).unwrap();
    page.cycle(before + 200);
    page.ask(Request::Restart { seed: Some(5) }).unwrap();
    page.message("described", |_| Some(()));
    let first = page.message("update", |update| update["cycle"].as_u64());
    assert!(first < before + 200, "it begins with the first cycle");
}

#[test]
fn a_world_begins_again_with_its_parameters_and_its_operator() {
    let (page, description) = running();
    let (component, _) = find(&description, "FaceBall", "params", "gain");
    page.ask(Request::Acquire {}).unwrap();
    let gain = |value: f64| {
        let setting = json!({"component": "FaceBall", "param": "gain", "value": value});
        serde_json::from_value(json!({"type": "operate", "request": {"type": "set", "settings": [setting]}})).unwrap()
    };
    for value in [0.9, 0.5] {
        page.ask(gain(value)).unwrap();
        page.ask(Request::Restart { seed: Some(5) }).unwrap();
        let described = page.message("described", |message| Some(message["description"].clone()));
        let params = described["components"][component]["params"].as_array().unwrap();
        let param = params.iter().find(|param| param["name"] == "gain").unwrap();
        assert_eq!(param["value"], value);
        page.message("update", |update| (update["cycle"].as_u64()? > 3).then_some(()));
        page.ask(Request::Keep {}).expect("the page still operates");
    }
}

#[test]
fn a_note_after_the_request_to_begin_again_is_in_the_log_and_the_recording_of_the_new_game() {
    let (page, _) = running();
    page.send(Request::Restart { seed: Some(5) });
    page.ask(Request::Note { text: "ball moved by hand".to_owned() }).unwrap();
    let until = page.message("update", |update| (update["cycle"].as_u64()? > 30).then(|| update["time_us"].as_u64()));
    let lines = page.lines();
    let is_note = |line: &Value| line["source"] == "note" && line["text"] == "ball moved by hand";
    assert!(lines.iter().any(is_note), "{lines:?}");
    page.message("update", |update| (update["time_us"].as_u64() > until).then_some(()));
    let path = page.ask(Request::KeepRecording { name: "new".to_owned() }).unwrap()["path"].clone();
    let file = std::fs::read(path.as_str().unwrap()).unwrap();
    assert!(file.windows(18).any(|bytes| bytes == b"ball moved by hand"), "the recording has no note");
}

#[test]
fn the_past_can_be_read_and_agrees_with_what_was_live() {
    let (page, description) = running();
    let (component, info) = find(&description, "CameraInput", "info", "count");
    let live = page.message("update", |update| (update["cycle"].as_u64()? > 150).then(|| update.clone()));
    let time_us = live["time_us"].as_u64().unwrap();
    let id = page.send(Request::At { time_us, info: vec![(component, info)], image: true });
    let frame = page.wait("the image", |got| match got {
        Got::Binary(frame) => Some(frame.clone()),
        Got::Message(message) => {
            assert!(message["type"] != "answer", "the image comes before the answer");
            None
        }
    });
    assert_eq!(frame[24..28], id.to_le_bytes());
    let moment = page.message("answer", |answer| Some(answer["result"].clone()));
    assert_eq!((&moment["cycle"], &moment["components"]), (&live["cycle"], &live["components"]));
    assert_eq!(moment["image"], u32::from_le_bytes(frame[8..12].try_into().unwrap()));
    assert_eq!(moment["info"][0][0], component);
    assert!(pose_of(&moment["truth"], "ball")[0].is_finite(), "{moment}");

    let rows = page.ask(Request::Timeline { from_us: 0, until_us: time_us, resolution_us: 0 }).unwrap();
    for (row, now) in rows.as_array().unwrap().iter().zip(live["components"].as_array().unwrap()) {
        let reaches = row["bars"].as_array().unwrap().last().is_some_and(|bar| bar[1] == time_us && bar[2] == now[2]);
        let since = now[4].as_u64().unwrap();
        assert_eq!(reaches, now[0] == true && since < time_us, "{row} {now}");
    }
    let request = Request::Series { component, info, from_us: 0, until_us: time_us, points: 10 };
    let series = page.ask(request).unwrap();
    let counts: Vec<u64> = series.as_array().unwrap().iter().map(|one| one[1].as_u64().unwrap()).collect();
    assert!(counts.len() > 2 && counts.is_sorted(), "{counts:?}");
}

#[test]
fn a_full_disk_is_reported_and_the_world_goes_on() {
    let folder = Folder::new("sessions");
    // Whatever is written to this device fails as on a full disk.
    std::fs::create_dir_all(folder.0.join("spool")).unwrap();
    std::os::unix::fs::symlink("/dev/full", folder.0.join("spool/session-1.mcap")).unwrap();
    let (page, _) = running_on(&Bench::with(folder, |options| options));
    page.session(|session| !session["recording"]["note"].as_str().unwrap().is_empty());
    let cycle = page.message("update", |update| update["cycle"].as_u64());
    page.cycle(cycle + 21);
    assert!(page.ask(Request::KeepRecording { name: "mine".to_owned() }).is_err());
}
