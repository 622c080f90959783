//! The built-in world, live.

use std::path::PathBuf;
use std::time::Duration;

use bica_game::{ReplayOptions, replay};
use jmanager::protocol::{HoldKind, Open, Request, Setting, Watch, WatchImages, WatchInfo};
use jmanager::sessions::Manager;
use serde_json::{Value, json};

use crate::page::{Folder, Got, Page};

fn built_in() -> Open {
    Open::World { world: "built-in".to_owned(), seed: 1, robots: 1 }
}

/// Index of a component and of one of its members.
pub(crate) fn find(description: &Value, component: &str, list: &str, name: &str) -> (usize, usize) {
    let components = description["components"].as_array().unwrap();
    let component = components.iter().position(|one| one["name"] == component).unwrap();
    let members = components[component][list].as_array().unwrap();
    (component, members.iter().position(|one| one["name"] == name).unwrap())
}

#[test]
fn a_world_is_described_and_its_state_images_information_costs_and_truth_come() {
    let folder = Folder::new();
    let manager = Manager::new(folder.options());
    let session = manager.open(built_in()).unwrap();
    let page = Page::new(&manager);
    page.message("hello", |hello| (hello["protocol"] == 1).then_some(()));
    let described = page.message("described", |message| Some(message.clone()));
    let components = described["description"]["components"].as_array().unwrap().len();
    assert!(components > 20);
    assert_eq!(described["drawing"]["boxes"].as_array().unwrap().len(), components);
    let count = find(&described["description"], "CameraInput", "info", "count");
    let watch = Watch {
        info: vec![WatchInfo { component: count.0, info: count.1, every: 1 }],
        images: Some(WatchImages { max_hz: 30.0 }),
        costs: true,
        truth: true,
        ..Watch::default()
    };
    page.ask(Request::Watch { session, watch }).unwrap();
    let update = page.message("update", |update| (update["cycle"].as_u64()? > 20).then(|| update.clone()));
    assert_eq!(update["components"].as_array().unwrap().len(), components);
    let sample = page.message("info", |info| Some(info["samples"][0].clone()));
    assert_eq!((sample[0].as_u64(), sample[1].as_u64()), (Some(count.0 as u64), Some(count.1 as u64)));
    let costs = page.message("costs", |costs| Some(costs.clone()));
    assert!(costs["components"].as_array().unwrap().iter().any(|one| one[0].as_u64().unwrap() > 0));
    let truth = page.message("truth", |truth| Some(truth["truth"].clone()));
    assert_eq!(truth["robot"].as_array().unwrap().len(), 3);
    let frame = page.wait("an image", |got| match got {
        Got::Binary(frame) => Some(frame.clone()),
        Got::Message(_) => None,
    });
    assert_eq!((frame[0], frame.len()), (1, 32 + 160 * 120 * 2));
}

#[cfg(feature = "mujoco")]
#[test]
fn a_game_in_mujoco_is_shown_with_its_images() {
    let folder = Folder::new();
    let manager = Manager::new(folder.options());
    let session = manager.open(Open::World { world: "mujoco".to_owned(), seed: 1, robots: 0 }).unwrap();
    let page = Page::new(&manager);
    page.message("described", |_| Some(()));
    let watch = Watch { images: Some(WatchImages { max_hz: 30.0 }), truth: true, ..Watch::default() };
    page.ask(Request::Watch { session, watch }).unwrap();
    page.message("update", |update| (update["cycle"].as_u64()? > 20).then_some(()));
    let truth = page.message("truth", |truth| Some(truth["truth"].clone()));
    assert_eq!(truth["robot"].as_array().unwrap().len(), 3);
    page.wait("an image", |got| matches!(got, Got::Binary(_)).then_some(()));
}

/// Opens the built-in world with one page, and waits until it runs.
pub(crate) fn running(manager: &Manager) -> (Page<'_>, u32, Value) {
    let session = manager.open(built_in()).unwrap();
    let page = Page::new(manager);
    let described = page.message("described", |message| Some(message["description"].clone()));
    page.message("update", |update| (update["cycle"].as_u64()? > 5).then_some(()));
    (page, session, described)
}

/// Attack 4: files of a running world in the folder of temporary files.
#[test]
fn other_users_cannot_read_what_is_recorded() {
    use std::os::unix::fs::PermissionsExt;
    let folder = Folder::new();
    let manager = Manager::new(folder.options());
    let _running = running(&manager);
    let mode = std::fs::metadata(folder.0.join("spool")).unwrap().permissions().mode();
    assert_eq!(mode & 0o777, 0o700);
}

#[test]
fn one_page_operates_and_values_are_answered_as_they_are_in_force() {
    let folder = Folder::new();
    let manager = Manager::new(folder.options());
    let (page, session, description) = running(&manager);
    let (component, param) = find(&description, "FaceBall", "params", "gain");
    let set = |value: Value| Request::Set { session, settings: vec![Setting { component, param, value }] };
    let error = page.ask(set(json!(0.9))).unwrap_err();
    assert!(error["text"].as_str().unwrap().contains("does not control"), "{error}");
    page.ask(Request::Acquire { session }).unwrap();
    let answer = page.ask(set(json!(0.9))).unwrap();
    assert_eq!(answer["values"], json!([0.9]));
    let error = page.ask(set(json!(1000.0))).unwrap_err();
    assert_eq!(error["entry"], 0, "{error}");
    let error = page.ask(set(json!("text"))).unwrap_err();
    assert_eq!(error["entry"], 0, "{error}");

    let other = Page::new(&manager);
    let gain = other.message("described", |message| {
        Some(message["description"]["components"][component]["params"][param]["value"].clone())
    });
    assert_eq!(gain, json!(0.9), "a page that comes later gets the values in force");
    assert_eq!(other.ask(Request::Acquire { session }).unwrap_err()["text"], "another page controls the robot");
    other.ask(Request::Take { session }).unwrap();
    page.session(|session| session["control"] == "other_page");
    assert!(page.ask(set(json!(0.8))).is_err());
    assert_eq!(other.ask(set(json!(0.8))).unwrap()["values"], json!([0.8]));
    drop(other);
    page.message("log", |log| {
        log["lines"][0]["text"].as_str()?.contains("was closed: control has ended").then_some(())
    });
    page.session(|session| session["control"] == "free");
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_a_hold_ends_when_the_page_is_silent() {
    let folder = Folder::new();
    let manager = Manager::new(folder.options());
    let (page, session, description) = running(&manager);
    let component = description["components"].as_array().unwrap().iter().position(|one| one["root"] == true).unwrap();
    page.ask(Request::Acquire { session }).unwrap();
    page.ask(Request::Hold { session, component, hold: HoldKind::Latent }).unwrap();
    let is = |hold: &'static str| move |update: &Value| (update["components"][component][1] == hold).then_some(());
    page.message("update", is("latent"));
    page.message("update", is("tree"));
    page.session(|session| session["control"] == "free");
}

#[test]
fn a_world_is_paused_stepped_and_begun_again() {
    let folder = Folder::new();
    let manager = Manager::new(folder.options());
    let (page, session, _) = running(&manager);
    page.ask(Request::Pause { session }).unwrap();
    // The last cycles before the pause are still under way.
    std::thread::sleep(Duration::from_millis(300));
    let cycle = |page: &Page<'_>| page.message("update", |update| update["cycle"].as_u64());
    let now =
        |page: &Page<'_>| page.ask(Request::At { session, time_us: u64::MAX, info: vec![], image: false }).unwrap();
    let before = now(&page)["cycle"].as_u64().unwrap();
    page.ask(Request::Step { session, cycles: 3 }).unwrap();
    while cycle(&page) < before + 3 {}
    std::thread::sleep(Duration::from_millis(300));
    assert_eq!(now(&page)["cycle"], before + 3);
    page.ask(Request::Resume { session }).unwrap();
    while cycle(&page) < before + 200 {}
    page.ask(Request::Restart { session, seed: Some(5) }).unwrap();
    page.message("described", |_| Some(()));
    assert!(cycle(&page) < before + 200, "it begins with the first cycle");
}

#[test]
fn a_note_after_the_request_to_begin_again_is_in_the_log_and_the_recording_of_the_new_game() {
    let folder = Folder::new();
    let manager = Manager::new(folder.options());
    let (page, session, _) = running(&manager);
    page.send(Request::Restart { session, seed: Some(5) });
    page.ask(Request::Note { session, text: "ball moved by hand".to_owned() }).unwrap();
    let until = page.message("update", |update| (update["cycle"].as_u64()? > 30).then(|| update["time_us"].as_u64()));
    let lines = page.ask(Request::Lines { session, from_us: 0, until_us: u64::MAX, limit: 1000 }).unwrap();
    let is_note = |line: &Value| line["kind"] == "note" && line["text"] == "ball moved by hand";
    assert!(lines.as_array().unwrap().iter().any(is_note), "{lines}");
    page.message("update", |update| (update["time_us"].as_u64() > until).then_some(()));
    let path = page.ask(Request::KeepRecording { session, name: "new".to_owned() }).unwrap()["path"].clone();
    let file = std::fs::read(path.as_str().unwrap()).unwrap();
    assert!(file.windows(18).any(|bytes| bytes == b"ball moved by hand"), "the recording has no note");
}

#[test]
fn a_paused_world_is_operated() {
    let folder = Folder::new();
    let manager = Manager::new(folder.options());
    let (page, session, description) = running(&manager);
    let (component, param) = find(&description, "FaceBall", "params", "gain");
    page.ask(Request::Pause { session }).unwrap();
    // The last cycles before the pause are still under way.
    std::thread::sleep(Duration::from_millis(300));
    page.ask(Request::Acquire { session }).unwrap();
    let settings = vec![Setting { component, param, value: json!(0.9) }];
    let answer = page.ask(Request::Set { session, settings }).unwrap();
    assert_eq!(answer["values"], json!([0.9]));
    page.ask(Request::Step { session, cycles: 1 }).unwrap();
    page.message("update", |update| (update["cycle"] == answer["cycle"]).then_some(()));
}

#[test]
fn the_past_can_be_read_and_agrees_with_what_was_live() {
    let folder = Folder::new();
    let manager = Manager::new(folder.options());
    let (page, session, description) = running(&manager);
    let (component, info) = find(&description, "CameraInput", "info", "count");
    let live = page.message("update", |update| (update["cycle"].as_u64()? > 150).then(|| update.clone()));
    let time_us = live["time_us"].as_u64().unwrap();
    let id = page.send(Request::At { session, time_us, info: vec![(component, info)], image: true });
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
    assert!(moment["truth"]["ball"].is_array());

    let rows = page.ask(Request::Timeline { session, from_us: 0, until_us: time_us, resolution_us: 0 }).unwrap();
    for (row, now) in rows.as_array().unwrap().iter().zip(live["components"].as_array().unwrap()) {
        let reaches = row["bars"].as_array().unwrap().last().is_some_and(|bar| bar[1] == time_us && bar[2] == now[2]);
        let since = now[4].as_u64().unwrap();
        assert_eq!(reaches, now[0] == true && since < time_us, "{row} {now}");
    }
    let request = Request::Series { session, component, info, from_us: 0, until_us: time_us, points: 10 };
    let series = page.ask(request).unwrap();
    let counts: Vec<u64> = series.as_array().unwrap().iter().map(|one| one[1].as_u64().unwrap()).collect();
    assert!(counts.len() > 2 && counts.is_sorted(), "{counts:?}");
}

#[test]
fn a_kept_recording_can_be_replayed_from_its_first_cycle() {
    let folder = Folder::new();
    let manager = Manager::new(folder.options());
    let (page, session, description) = running(&manager);
    let (component, param) = find(&description, "FaceBall", "params", "gain");
    page.ask(Request::Acquire { session }).unwrap();
    let settings = vec![Setting { component, param, value: json!(0.9) }];
    page.ask(Request::Set { session, settings }).unwrap();
    page.ask(Request::Note { session, text: "before the kick".to_owned() }).unwrap();
    page.message("update", |update| (update["cycle"].as_u64()? > 100).then_some(()));
    let bad = page.ask(Request::KeepRecording { session, name: "../outside".to_owned() });
    assert!(bad.is_err());
    let kept = page.ask(Request::KeepRecording { session, name: "mine".to_owned() }).unwrap();
    let path = PathBuf::from(kept["path"].as_str().unwrap());
    assert_eq!(path, folder.0.join("recordings/mine.mcap"));
    let again = page.ask(Request::KeepRecording { session, name: "mine".to_owned() }).unwrap_err();
    assert!(again["text"].as_str().unwrap().contains("exists"), "{again}");
    let list = page.ask(Request::Recordings {}).unwrap();
    assert_eq!(list[0]["name"], "mine.mcap");
    let options = ReplayOptions::whole(&path);
    let replayed = replay(&options).unwrap();
    assert!(replayed.equal, "{:?}", replayed.first_difference);
    assert!(replayed.cycles > 50, "{}", replayed.cycles);
    assert_eq!(replayed.damage, None);
    let text = std::fs::read(&path).unwrap();
    assert!(!text.is_empty());
}

#[test]
fn a_full_disk_is_reported_and_the_world_goes_on() {
    let folder = Folder::new();
    // Whatever is written to this device fails as on a full disk.
    std::fs::create_dir_all(folder.0.join("spool")).unwrap();
    std::os::unix::fs::symlink("/dev/full", folder.0.join("spool/session-1.mcap")).unwrap();
    let manager = Manager::new(folder.options());
    let (page, session, _) = running(&manager);
    page.session(|session| !session["recording"]["note"].as_str().unwrap().is_empty());
    let cycle = page.message("update", |update| update["cycle"].as_u64());
    page.message("update", |update| (update["cycle"].as_u64()? > cycle + 20).then_some(()));
    assert!(page.ask(Request::KeepRecording { session, name: "mine".to_owned() }).is_err());
}

#[test]
fn conditions_tell_why_a_state_is_not_left() {
    let folder = Folder::new();
    let manager = Manager::new(folder.options());
    let (page, session, description) = running(&manager);
    let components = description["components"].as_array().unwrap();
    let root = components.iter().position(|one| one["root"] == true).unwrap();
    let watch = Watch { conditions: vec![root], ..Watch::default() };
    page.ask(Request::Watch { session, watch }).unwrap();
    let conditions = page.message("conditions", |message| {
        assert_eq!(message["component"], root);
        let is_known = message["conditions"].as_array()?.iter().any(|one| one["holds"].is_boolean());
        is_known.then(|| message["conditions"].as_array().unwrap().clone())
    });
    let transitions = components[root]["transitions"].as_array().unwrap();
    assert_eq!(conditions.len(), transitions.len());
    // The transition by which it came into this state held.
    let known = conditions.iter().zip(transitions).filter(|(one, _)| one["holds"] == false);
    let from: Vec<_> = known.map(|(_, transition)| &transition["from"]).collect();
    assert!(from.windows(2).all(|two| two[0] == two[1]), "only conditions of one state are evaluated: {from:?}");
}
