//! Recordings as sessions.

use std::fs;
use std::process::Command;

use bica::Tree;
use bica_app::{App, RunArgs};
use bica_link::{NamedSetting, Plain};
use bica_monitor::protocol::{Open, Request};
use clap::{Args, FromArgMatches};
use serde_json::Value;

use crate::lamp::{CYCLE_US, IMAGE_BYTES, IMAGE_CYCLES, Lamp, LampTree, app};
use crate::page::{Bench, Folder, Got, Page};
use crate::sessions::world::find;

/// Duration of a recorded run, µs.
const DURATION_US: u64 = 5_900_000;

/// Records a run of the lamp.
pub(crate) fn record(folder: &Folder, name: &str) {
    record_with(&app(), folder, name);
}

fn record_with(app: &App<LampTree>, folder: &Folder, name: &str) {
    let path = folder.0.join("recordings").join(name);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    let arguments = ["run", "--world", "room", "--seconds", "5.9", "--json", "--record", path.to_str().unwrap()];
    let matches = RunArgs::<()>::augment_args(clap::Command::new("run")).get_matches_from(arguments);
    app.play(&RunArgs::from_arg_matches(&matches).unwrap()).unwrap();
}

/// Opens a recording and waits until it is read.
pub(crate) fn opened(page: &Page, name: &str) -> (u32, Value) {
    let source = Open::Recording { name: name.to_owned() };
    let session = page.ask(Request::Open { source }).unwrap()["session"].as_u64().unwrap() as u32;
    page.session.set(Some(session));
    (session, read(page, session))
}

/// Waits until a recording is read. The message may come before the answer to the request that opened the recording.
fn read(page: &Page, session: u32) -> Value {
    page.state("session", |message| {
        let one = &message["session"];
        assert!(one["id"] != session || one["connection"] != "ended", "{one}");
        let is_read = one["connection"] == "connected" && one["until_us"].as_u64() > Some(0);
        (one["id"] == session && is_read).then(|| one.clone())
    })
}

#[test]
fn recording_shows_states_images_and_outputs() {
    let folder = Folder::new("sessions");
    record(&folder, "one.mcap");
    let page = Page::new(&Bench::with(folder, |options| options));
    let (_, info) = opened(&page, "one");
    assert_eq!((info["from_us"].as_u64(), info["until_us"].as_u64()), (Some(0), Some(DURATION_US - CYCLE_US)));
    assert_eq!(info["can"]["operate"], false);
    let late = Page::new(&page.bench);
    let described = late.message("described", |message| Some(message["description"].clone()));
    let (component, index) = find(&described, "Eye", "info", "count");
    for time_us in [2_000_000, 500_000, 1_234_567] {
        let id = page.send(Request::At { time_us, outputs: vec![(component, index)], image: true });
        let frame = page.wait("the image", |got| match got {
            Got::Binary(frame) => Some(frame.clone()),
            Got::Message(_) => None,
        });
        let moment = page.message("answer", |answer| (answer["id"] == id).then(|| answer["result"].clone()));
        assert_eq!(moment["time_us"], time_us / CYCLE_US * CYCLE_US);
        assert_eq!(moment["cycle"], time_us / CYCLE_US);
        let taken = u64::from_le_bytes(frame[16..24].try_into().unwrap());
        assert!(taken <= time_us && time_us - taken < IMAGE_CYCLES * CYCLE_US, "{taken} {time_us}");
        let camera = usize::from(frame[1]);
        assert_eq!(&frame[32..32 + camera], b"eye");
        assert_eq!(frame.len(), 32 + camera + IMAGE_BYTES);
        let number = moment["image"].as_u64().unwrap();
        // Outputs are recorded in every tenth cycle, so that the count may be that of an earlier image.
        let count = moment["info"][0][3].as_u64().unwrap();
        assert!(count <= number + 1 && number + 1 - count < 5, "{count} {number}");
    }
    let request = Request::Timeline { from_us: 0, until_us: u64::MAX, resolution_us: 0 };
    let rows = page.ask(request).unwrap();
    let bars: usize = rows.as_array().unwrap().iter().map(|row| row["bars"].as_array().unwrap().len()).sum();
    assert!(bars > 10, "{bars}");
    assert!(page.ask(Request::Acquire {}).is_err());
}

#[test]
fn run_again_finds_the_first_difference() {
    let folder = Folder::new("sessions");
    record(&folder, "one.mcap");
    let page = Page::new(&Bench::with(folder, |options| options));
    opened(&page, "one");
    let late = Page::new(&page.bench);
    late.message("described", |_| Some(()));
    let again = |settings: Vec<NamedSetting>| {
        let answer = page.ask(Request::RunAgain { settings }).unwrap();
        let again = answer["session"].as_u64().unwrap() as u32;
        // The run may have ended already.
        if let Err(error) = page.ask(Request::Compare { other: again }) {
            assert!(error["text"].as_str().unwrap().contains("still being"), "{error}");
        }
        read(&page, again);
        page.ask(Request::Compare { other: again }).unwrap()
    };
    assert_eq!(again(Vec::new())["equal"], true);
    let (component, param) = ("Lamp".to_owned(), "gain".to_owned());
    let settings = vec![NamedSetting { component, param, value: Plain::Number(0.1) }];
    let difference = again(settings);
    assert_eq!(difference["equal"], false, "{difference}");
    assert!(difference["cycle"].as_u64().unwrap() > 0);
    assert!(!difference["text"].as_str().unwrap().is_empty());
}

#[test]
fn cut_recording_is_shown_up_to_the_cut() {
    let folder = Folder::new("sessions");
    record(&folder, "one.mcap");
    let recordings = folder.0.join("recordings");
    let bytes = fs::read(recordings.join("one.mcap")).unwrap();
    fs::write(recordings.join("cut.mcap"), &bytes[..bytes.len() * 3 / 4]).unwrap();
    fs::write(recordings.join("text.mcap"), "no recording").unwrap();
    fs::write(recordings.join("empty.mcap"), "").unwrap();
    assert!(Command::new("mkfifo").arg(recordings.join("pipe.mcap")).status().unwrap().success());
    fs::write(recordings.join("run (1).mcap"), &bytes).unwrap();
    let mut damaged = bytes.clone();
    let middle = bytes.len() / 2;
    damaged[middle..middle + 64].fill(0xFF);
    fs::write(recordings.join("damaged.mcap"), damaged).unwrap();
    let page = Page::new(&Bench::with(folder, |options| options));
    for name in ["cut", "damaged"] {
        let (_, info) = opened(&page, name);
        assert!(!info["note"].as_str().unwrap().is_empty(), "{name}: {info}");
        assert!(info["until_us"].as_u64().unwrap() < DURATION_US - CYCLE_US, "{name}: {info}");
    }
    opened(&page, "run (1).mcap");
    for name in ["text", "empty", "pipe", "missing", "../recordings/one"] {
        let error = page.ask(Request::Open { source: Open::Recording { name: name.to_owned() } }).unwrap_err();
        assert!(!error["help"].as_str().unwrap().is_empty(), "{name}: {error}");
    }
}

#[test]
fn late_page_gets_the_result_of_a_recorded_run() {
    let folder = Folder::new("sessions");
    record_with(&app().until(|tree| tree.get::<Lamp>().cycles > 100), &folder, "done.mcap");
    let page = Page::new(&Bench::with(folder, |options| options));
    let (_, info) = opened(&page, "done");
    let result = info["result"].as_str().unwrap();
    assert!(result.starts_with("done"), "{info}");
    let late = Page::new(&page.bench);
    let sessions = late.message("hello", |hello| Some(hello["sessions"].clone()));
    assert_eq!(sessions[0]["result"], result);
}
