//! Recordings of a robot behind a link.

use std::fs::{self, File};
use std::path::Path;
use std::sync::Arc;

use bica::Hold;
use bica_app::Failure;
use bica_link::Plain;
use bica_monitor::protocol::{Open, Request, Watch, WatchImages};
use bica_recording::{Info, LogLine, LogSource, Recording, ReplayOptions};
use serde_json::{Value, json};

use crate::lamp::{CYCLE_US, app};
use crate::page::{Bench, Folder, Got, Page};
use crate::served::{Served, attached};
use crate::sessions::recorded::{opened, record};
use crate::sessions::world::{find, hold, set_gain};

/// Opens a robot with one page, and waits until it has sent some cycles.
fn running(robot: &Served) -> (Page, Value) {
    let (page, description) = attached(&format!("tcp://{}", robot.address));
    page.cycle(6);
    (page, description)
}

fn keep(page: &Page, name: &str) -> Value {
    page.ask(Request::KeepRecording { name: name.to_owned() }).unwrap()
}

/// Returns the state at a time, and the number of the image in its frame.
fn at(page: &Page, session: u32, time_us: u64, info: (usize, usize)) -> (Value, u32) {
    page.session.set(Some(session));
    let id = page.send(Request::At { time_us, outputs: vec![info], image: true });
    let number = page.wait("the image", |got| match got {
        Got::Binary(frame) if frame[24..28] == id.to_le_bytes() => {
            Some(u32::from_le_bytes(frame[8..12].try_into().unwrap()))
        }
        _ => None,
    });
    (page.message("answer", |answer| (answer["id"] == id).then(|| answer["result"].clone())), number)
}

fn info(path: &Path) -> Info {
    Info::read(File::open(path).unwrap()).unwrap()
}

#[test]
fn kept_recording_equals_received() {
    let robot = Served::world();
    let (page, description) = running(&robot);
    let session = page.session.get().unwrap();
    let watch = Watch { images: Some(WatchImages { max_hz: 30.0 }), ..Watch::default() };
    page.ask(Request::Watch { watch }).unwrap();
    page.wait("the first image", |got| matches!(got, Got::Binary(_)).then_some(()));
    // From this time on each moment that is compared has an image.
    let with_images = page.message("update", |update| update["time_us"].as_u64());
    page.ask(Request::Acquire {}).unwrap();
    let (component, param) = find(&description, "Lamp", "params", "gain");
    page.ask(set_gain(Plain::Number(0.9))).unwrap();
    page.ask(hold("Lamp", Hold::Active)).unwrap();
    page.ask(Request::Note { text: "before the end".to_owned() }).unwrap();
    let until = page.message("update", |update| {
        let held = update["components"][component][1] == "active";
        (held && update["time_us"].as_u64()? > with_images + 750_000).then(|| update["time_us"].as_u64()).flatten()
    });
    page.message("update", |update| (update["time_us"].as_u64()? > until + 200_000).then_some(()));
    let kept = keep(&page, "mine");
    let path = page.bench.folder.0.join("recordings/mine.mcap");
    assert_eq!(kept["path"], path.to_str().unwrap());
    let again = page.ask(Request::KeepRecording { name: "mine".to_owned() }).unwrap_err();
    assert!(again["text"].as_str().unwrap().contains("exists"), "{again}");

    let listed = info(&path);
    assert_eq!((Some(listed.cycles), listed.damage), (kept["cycles"].as_u64(), None));
    assert_eq!(listed.header.monitor.unwrap().address, format!("tcp://{}", robot.address));
    let requests: Vec<_> = listed.requests.iter().map(|one| one.request.as_str()).collect();
    assert!(requests.iter().any(|one| one.starts_with("set Lamp.gain=0.9")), "{requests:?}");
    assert!(requests.contains(&"hold Lamp active"), "{requests:?}");

    let (copy, shown) = opened(&page, "mine");
    assert_eq!(shown["can"]["run_again"], false);
    assert!(shown["note"].as_str().unwrap().contains("monitor"), "{shown}");
    let late = Page::new(&page.bench);
    let described =
        late.message("described", |message| (message["session"] == copy).then(|| message["description"].clone()));
    assert_eq!(described["components"][component]["links"], description["components"][component]["links"]);
    assert_eq!(described["components"][component]["params"][param]["value"], json!(0.9));
    drop(late);
    let count = find(&description, "Eye", "info", "count");
    // The copy begins at zero, the robot's clock does not.
    let start = CYCLE_US * at(&page, copy, 500_000, count).0["cycle"].as_u64().unwrap() - 500_000;
    for time_us in [until, until - 300_000, until - 700_000] {
        let ((live, live_image), (recorded, image)) =
            (at(&page, session, time_us, count), at(&page, copy, time_us - start, count));
        assert_eq!(live["time_us"].as_u64().unwrap(), recorded["time_us"].as_u64().unwrap() + start);
        for field in ["cycle", "image"] {
            assert_eq!(live[field], recorded[field], "{field} at {time_us}");
        }
        assert_eq!((live_image, &live["info"][0][3]), (image, &recorded["info"][0][3]), "at {time_us}");
        for (live, recorded) in
            live["components"].as_array().unwrap().iter().zip(recorded["components"].as_array().unwrap())
        {
            // The time of the last change is not compared: it is unknown before the first cycle in memory.
            assert_eq!(live.as_array().unwrap()[..4], recorded.as_array().unwrap()[..4], "at {time_us}");
        }
    }
    let lines = |session, start| {
        page.session.set(Some(session));
        let lines = page.ask(Request::Lines { from_us: 0, until_us: until - start, limit: 1000 }).unwrap();
        let pair = |line: &Value| (line["source"].clone(), line["text"].clone());
        lines.as_array().unwrap().iter().map(pair).collect::<Vec<_>>()
    };
    let (live, recorded) = (lines(session, 0), lines(copy, start));
    assert!(live.contains(&(json!("note"), json!("before the end"))), "{live:?}");
    let mut sorted = [live, recorded];
    for lines in &mut sorted {
        lines.sort_by_key(|(kind, text)| format!("{kind} {text}"));
    }
    assert_eq!(sorted[0], sorted[1]);
    let bars = |session, start| {
        page.session.set(Some(session));
        let (from_us, until_us) = (until - 500_000 - start, until - start);
        let rows = page.ask(Request::Timeline { from_us, until_us, resolution_us: 0 }).unwrap();
        let bar = |bar: &Value| (bar[0].as_u64().unwrap() + start, bar[1].as_u64().unwrap() + start, bar[2].clone());
        let of_row = |row: &Value| row["bars"].as_array().unwrap().iter().map(bar).collect::<Vec<_>>();
        rows.as_array().unwrap().iter().map(of_row).collect::<Vec<_>>()
    };
    assert_eq!(bars(session, 0), bars(copy, start));

    let error = page.ask(Request::RunAgain { settings: Vec::new() }).unwrap_err();
    assert!(error["text"].as_str().unwrap().contains("cannot be run again"), "{error}");
    let copies = page.ask(Request::Compare { other: copy }).unwrap();
    assert_eq!(copies, json!({ "equal": true, "copies": true }));
    let options = ReplayOptions::whole(&path);
    match app().repeat(&options) {
        Err(Failure::Error { what, help }) => {
            assert!(what.contains("without sensor values") && help.contains("--serve"), "{what}; {help}");
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn received_data_is_kept_after_the_robot_has_gone() {
    let robot = Served::world();
    let (page, _) = running(&robot);
    let on = page.session(|one| one["recording"]["on"] == true);
    assert_eq!(on["recording"]["file"], "");
    let last =
        page.message("update", |update| (update["cycle"].as_u64()? > 60).then(|| update["cycle"].as_u64()).flatten());
    drop(robot);
    page.session(|one| one["connection"] == "lost");
    keep(&page, "last");
    let path = page.bench.folder.0.join("recordings/last.mcap");
    let mut recording = Recording::open(&path).unwrap();
    let (mut newest, mut lost) = (0, false);
    while let Some(cycle) = recording.next_cycle().unwrap() {
        newest = cycle.tick.cycle;
        let is_lost =
            |line: &LogLine| line.source == LogSource::Monitor && line.text.starts_with("the connection was lost");
        lost |= cycle.log.iter().any(is_lost);
    }
    assert!(newest >= last && lost, "{newest} {last} {lost}");
}

#[test]
fn silent_robot_and_recording_are_not_kept() {
    let folder = Folder::new("sessions");
    record(&folder, "one.mcap");
    let page = Page::new(&Bench::with(folder, |options| options));
    let robot = Served::world();
    let address = robot.address.clone();
    drop(robot);
    let silent = page.open(Open::Robot { address });
    let (copy, _) = opened(&page, "one");
    for session in [silent, copy] {
        page.session.set(Some(session));
        let error = page.ask(Request::KeepRecording { name: "a".to_owned() }).unwrap_err();
        assert!(!error["help"].as_str().unwrap().is_empty(), "{error}");
    }
    assert!(!page.bench.folder.0.join("recordings/a.mcap").exists());
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_robot_is_recorded_while_it_is_received() {
    let bench = Bench::new();
    let folder = Arc::clone(&bench.folder);
    let robot = Served::world();
    let address = robot.address.clone();
    let (file, next) = (folder.0.join("day.mcap"), folder.0.join("day-2.mcap"));
    let source = Open::Robot { address: address.clone() };
    bench.manager.open_recorded(source, &file).unwrap();
    let page = Page::new(&bench);
    page.message("described", |_| Some(()));
    // Images are recorded although no page watches them.
    page.session(|one| {
        one["recording"]["file"] == file.to_str().unwrap() && one["recording"]["bytes"].as_u64() > Some(1_000_000)
    });
    // The file that a server leaves if it is killed now.
    let killed = folder.0.join("killed.mcap");
    fs::copy(&file, &killed).unwrap();
    let left = info(&killed);
    assert!(left.cycles > 20 && left.damage.is_some() && left.ending.is_none(), "{} {:?}", left.cycles, left.damage);
    assert!(left.channels.iter().any(|channel| channel.topic == "blobs" && channel.messages > 5));
    let cycle = page.message("update", |update| update["cycle"].as_u64());
    drop(robot);
    page.session(|one| one["connection"] == "lost");
    let robot = Served::world_at(&address);
    page.session(|one| one["recording"]["file"] == next.to_str().unwrap());
    let first = info(&file);
    assert!(first.cycles >= cycle / 2 && first.damage.is_none() && first.ending.is_some(), "{}", first.cycles);
    page.ask(Request::Note { text: "again".to_owned() }).unwrap();
    page.cycle(61);
    drop(page);
    drop(bench);
    let second = info(&next);
    assert!(second.cycles > 30 && second.damage.is_none() && second.ending.is_some(), "{}", second.cycles);
    drop(robot);
}

#[test]
fn unwritable_file_is_reported_and_session_goes_on() {
    let bench = Bench::new();
    let folder = Arc::clone(&bench.folder);
    let robot = Served::world();
    let source = Open::Robot { address: robot.address.clone() };
    bench.manager.open_recorded(source, &folder.0.join("missing/day.mcap")).unwrap();
    let page = Page::new(&bench);
    page.message("log", |log| {
        log["lines"].as_array()?.iter().any(|line| line["text"].as_str().unwrap().contains("has ended")).then_some(())
    });
    let info = page.session(|one| !one["recording"]["note"].as_str().unwrap().is_empty());
    assert!(info["recording"]["note"].as_str().unwrap().contains("cannot make the file"), "{info}");
    let cycle = page.message("update", |update| update["cycle"].as_u64());
    page.cycle(cycle + 21);
    keep(&page, "mine");
}
