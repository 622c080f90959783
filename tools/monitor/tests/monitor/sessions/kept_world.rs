//! Recordings of a simulated world.

use std::path::PathBuf;
use std::sync::Arc;

use bica_link::Plain;
use bica_monitor::protocol::{Open, Request};
use bica_recording::ReplayOptions;

use crate::lamp::app;
use crate::page::{Bench, Page};
use crate::sessions::recorded::opened;
use crate::sessions::world::{place, room, running, set_gain};

#[test]
fn kept_recording_with_requests_replays() {
    let (page, _) = running();
    page.ask(Request::Acquire {}).unwrap();
    page.ask(set_gain(Plain::Number(0.9))).unwrap();
    page.ask(Request::Note { text: "before the end".to_owned() }).unwrap();
    for step in 0..20_u8 {
        page.ask(place(f32::from(step) * 0.125)).unwrap();
    }
    let cycle = page.message("update", |update| update["cycle"].as_u64());
    page.message("update", |update| (update["cycle"].as_u64()? > cycle + 100).then_some(()));
    let keep = |name: &str| page.ask(Request::KeepRecording { name: name.to_owned() });
    assert!(keep("../outside").is_err());
    let path = PathBuf::from(keep("placed").unwrap()["path"].as_str().unwrap());
    assert_eq!(path, page.bench.folder.0.join("recordings/placed.mcap"));
    let again = keep("placed").unwrap_err();
    assert!(again["text"].as_str().unwrap().contains("exists"), "{again}");
    assert_eq!(page.ask(Request::Recordings {}).unwrap()[0]["name"], "placed.mcap");
    let options = ReplayOptions::whole(&path);
    let replayed = app().repeat(&options).unwrap();
    assert!(replayed.equal && replayed.damage.is_none(), "{:?}", replayed.first_difference);

    let recording = page.open(Open::Recording { name: "placed.mcap".to_owned() });
    let info = page.session(|one| one["id"] == recording && one["connection"] == "connected");
    assert_eq!(info["can"]["operate"], false);
    let error = page.ask(place(1.0)).unwrap_err();
    assert!(error["text"].as_str().unwrap().contains("a recording cannot be operated"), "{error}");
    let lines = page.lines();
    let is_placement = |line: &&serde_json::Value| line["text"].as_str().unwrap().starts_with("act place_lamp(");
    assert_eq!(lines.iter().filter(is_placement).count(), 20);
}

#[test]
fn span_of_a_world_and_of_a_recording_is_kept() {
    let (page, _) = running();
    page.cycle(350);
    let keep = |name: &str, from_us, until_us| page.ask(Request::KeepSpan { name: name.to_owned(), from_us, until_us });
    keep("part", 500_000, 1_500_000).unwrap();
    let span = |name: &str| {
        let (_, info) = opened(&page, name);
        (info["from_us"].as_u64().unwrap(), info["until_us"].as_u64().unwrap())
    };
    // A kept span begins at zero, and the second span is cut from the first one.
    assert_eq!(span("part.mcap"), (0, 1_000_000));
    keep("less", 600_000, 700_000).unwrap();
    assert_eq!(span("less.mcap"), (0, 100_000));
    let error = keep("none", 2_600_000, 2_700_000).unwrap_err();
    assert!(error["text"].as_str().unwrap().contains("no such span: it ends at 0.10 s"), "{error}");
    let files = std::fs::read_dir(page.bench.folder.0.join("recordings")).unwrap();
    assert_eq!(files.count(), 2, "an incomplete file is removed");
}

#[test]
fn world_is_recorded_in_a_file_that_stays() {
    let bench = Bench::new();
    let folder = Arc::clone(&bench.folder);
    let (file, next) = (folder.0.join("game.mcap"), folder.0.join("game-2.mcap"));
    bench.manager.open_recorded(room(), &file).unwrap();
    let page = Page::new(&bench);
    page.cycle(51);
    page.session(|one| one["recording"]["on"] == true && one["recording"]["file"] == file.to_str().unwrap());
    page.ask(Request::KeepRecording { name: "copy".to_owned() }).unwrap();
    page.ask(Request::Restart { seed: Some(2) }).unwrap();
    page.session(|one| one["recording"]["file"] == next.to_str().unwrap());
    page.cycle(21);
    drop(page);
    drop(bench);
    for path in [&file, &next, &folder.0.join("recordings/copy.mcap")] {
        let options = ReplayOptions::whole(path);
        let replayed = app().repeat(&options).unwrap();
        assert!(
            replayed.equal && replayed.damage.is_none() && replayed.cycles > 10,
            "{}: {replayed:?}",
            path.display()
        );
    }
}
