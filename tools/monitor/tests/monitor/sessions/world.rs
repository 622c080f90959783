//! A simulated world, live.

use std::collections::BTreeMap;
use std::sync::Arc;

use bica::Hold;
use bica_link::{NamedRequest, NamedSetting, Plain};
use bica_monitor::protocol::{Open, Request};
use serde_json::Value;

use crate::page::{Bench, Folder, Got, Page};

/// The world of the lamp.
pub(crate) fn room() -> Open {
    Open::World { world: "room".to_owned(), seed: 1, options: BTreeMap::new() }
}

/// A value for the gain of the lamp.
pub(crate) fn set_gain(value: Plain) -> Request {
    let (component, param) = ("Lamp".to_owned(), "gain".to_owned());
    Request::Operate { request: NamedRequest::Set { settings: vec![NamedSetting { component, param, value }] } }
}

/// A place for the lamp, m.
pub(crate) fn place(x: f32) -> Request {
    let (action, arguments) = ("place_lamp".to_owned(), vec![Plain::Number(x.into())]);
    Request::Operate { request: NamedRequest::World { action, arguments } }
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

/// Place of the lamp in a true state, m.
pub(crate) fn place_in(truth: &Value) -> Value {
    let one = truth.as_array().into_iter().flatten().find(|one| one["name"] == "lamp");
    one.map_or(Value::Null, |one| one["value"]["x"].clone())
}

/// Opens the world of the lamp with one page, and waits until it runs.
pub(crate) fn running() -> (Page, Value) {
    running_on(&Bench::new())
}

pub(crate) fn running_on(bench: &Arc<Bench>) -> (Page, Value) {
    let page = Page::new(bench);
    page.open(room());
    let described = page.message("described", |message| Some(message.clone()));
    let kinds = described["kinds"].as_array().unwrap().len();
    assert_eq!(kinds, described["description"]["components"].as_array().unwrap().len());
    page.cycle(6);
    (page, described["description"].clone())
}

#[test]
fn unknown_world_is_refused() {
    let world = Open::World { world: "hall".to_owned(), seed: 1, options: BTreeMap::new() };
    let failed = Bench::new().manager.open(world).unwrap_err();
    assert!(failed.help.contains("room"), "{failed:?}");
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
fn restart_keeps_parameters_and_operator() {
    let (page, description) = running();
    let (component, param) = find(&description, "Lamp", "params", "gain");
    page.ask(Request::Acquire {}).unwrap();
    for value in [0.9, 0.5] {
        page.cycle(100);
        page.ask(set_gain(Plain::Number(value))).unwrap();
        page.ask(Request::Restart { seed: Some(5) }).unwrap();
        let described = page.message("described", |message| Some(message["description"].clone()));
        assert_eq!(described["components"][component]["params"][param]["value"], value);
        let first = page.message("update", |update| update["cycle"].as_u64());
        assert!(first < 100, "it begins with the first cycle: {first}");
        page.ask(Request::Keep {}).expect("the page still operates");
    }
}

#[test]
fn note_after_restart_belongs_to_the_new_run() {
    let (page, _) = running();
    page.send(Request::Restart { seed: Some(5) });
    page.ask(Request::Note { text: "lamp moved by hand".to_owned() }).unwrap();
    let until = page.message("update", |update| (update["cycle"].as_u64()? > 30).then(|| update["time_us"].as_u64()));
    let lines = page.lines();
    let is_note = |line: &Value| line["source"] == "note" && line["text"] == "lamp moved by hand";
    assert!(lines.iter().any(is_note), "{lines:?}");
    page.message("update", |update| (update["time_us"].as_u64() > until).then_some(()));
    let path = page.ask(Request::KeepRecording { name: "new".to_owned() }).unwrap()["path"].clone();
    let file = std::fs::read(path.as_str().unwrap()).unwrap();
    assert!(file.windows(18).any(|bytes| bytes == b"lamp moved by hand"), "the recording has no note");
}

#[test]
fn the_past_agrees_with_what_was_live() {
    let (page, description) = running();
    let (component, info) = find(&description, "Eye", "info", "count");
    // Only a cycle in which nothing changes: the time of a change belongs both to the bar that ends and to the state after it.
    let live = page.message("update", |update| {
        let is_constant =
            update["components"].as_array()?.iter().all(|now| now[4].as_u64() < update["time_us"].as_u64());
        (update["cycle"].as_u64()? > 150 && is_constant).then(|| update.clone())
    });
    let time_us = live["time_us"].as_u64().unwrap();
    let id = page.send(Request::At { time_us, outputs: vec![(component, info)], image: true });
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
    assert_eq!(place_in(&moment["truth"]), 1.0, "{moment}");

    let rows = page.ask(Request::Timeline { from_us: 0, until_us: time_us, resolution_us: 0 }).unwrap();
    for (row, now) in rows.as_array().unwrap().iter().zip(live["components"].as_array().unwrap()) {
        let reaches = row["bars"].as_array().unwrap().last().is_some_and(|bar| bar[1] == time_us && bar[2] == now[2]);
        assert_eq!(reaches, now[0] == true, "{row} {now}");
    }
    let request = Request::Series { component, output: info, from_us: 0, until_us: time_us, points: 10 };
    let series = page.ask(request).unwrap();
    let counts: Vec<u64> = series.as_array().unwrap().iter().map(|one| one[1].as_u64().unwrap()).collect();
    assert!(counts.len() > 2 && counts.is_sorted(), "{counts:?}");
}

#[test]
fn a_full_disk_is_reported_and_the_world_goes_on() {
    let folder = Folder::new("sessions");
    // Every write to this device fails, as on a full disk.
    std::fs::create_dir_all(folder.0.join("spool")).unwrap();
    std::os::unix::fs::symlink("/dev/full", folder.0.join("spool/session-1.mcap")).unwrap();
    let (page, _) = running_on(&Bench::with(folder, |options| options));
    page.session(|session| !session["recording"]["note"].as_str().unwrap().is_empty());
    let cycle = page.message("update", |update| update["cycle"].as_u64());
    page.cycle(cycle + 21);
    assert!(page.ask(Request::KeepRecording { name: "mine".to_owned() }).is_err());
}
