//! The ball of a simulated world, which the operator places.

use std::path::PathBuf;

use bica_link::{NamedRequest, Plain};
use bica_monitor::protocol::{Open, Request, Watch};
use bica_player_program::game::{ReplayOptions, replay};

use crate::sessions::page::Page;
use crate::sessions::recorded::opened;
use crate::sessions::world::{pose_of, running, set_gain};

fn ball(x: f32, y: f32) -> Request {
    let arguments = [x, y].map(|number| Plain::Number(number.into())).to_vec();
    Request::Operate { request: NamedRequest::World { action: "place_ball".to_owned(), arguments } }
}

/// Waits until the true state has the ball at a position.
fn lies_at(page: &Page, x: f32, y: f32) {
    page.state("truth", |message| (pose_of(&message["truth"], "ball")[..2] == [x, y]).then_some(()));
}

#[test]
fn the_operator_places_the_ball_of_a_running_and_of_a_paused_world() {
    let (page, _) = running();
    page.ask(Request::Watch { watch: Watch { truth: true, ..Watch::default() } }).unwrap();
    let error = page.ask(ball(1.0, 0.5)).unwrap_err();
    assert!(error["text"].as_str().unwrap().contains("does not control"), "{error}");
    page.ask(Request::Acquire {}).unwrap();
    page.ask(ball(-2.5, 1.75)).unwrap();
    lies_at(&page, -2.5, 1.75);
    for (x, y, reason) in [(3.25, 0.0, "3.25 is outside -3..=3"), (3.0, 0.7, "a goal post is there")] {
        let error = page.ask(ball(x, y)).unwrap_err();
        assert!(error["text"].as_str().unwrap().contains(reason), "{error}");
    }

    page.paused();
    let answer = page.ask(ball(2.5, -1.75)).unwrap();
    lies_at(&page, 2.5, -1.75);
    assert_eq!(pose_of(&page.now()["truth"], "ball")[..2], [2.5, -1.75], "it lies there before time goes on");
    page.ask(Request::Step { cycles: 1 }).unwrap();
    page.message("update", |update| (update["cycle"] == answer["cycle"]).then_some(()));
    page.ask(Request::Release {}).unwrap();
    page.session(|session| session["control"] == "free");
    assert!(page.ask(ball(1.0, 0.5)).is_err());
}

#[test]
fn a_kept_recording_of_a_world_with_requests_replays() {
    let (page, _) = running();
    page.ask(Request::Acquire {}).unwrap();
    page.ask(set_gain(Plain::Number(0.9))).unwrap();
    page.ask(Request::Note { text: "before the kick".to_owned() }).unwrap();
    let mut placed = 0;
    for step in 0..20_u8 {
        // A robot may stand at one of these places.
        placed += usize::from(page.ask(ball(f32::from(step) * 0.125, 0.5)).is_ok());
    }
    assert!(placed > 10, "{placed} placements");
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
    let replayed = replay(&options).unwrap();
    assert!(replayed.equal && replayed.damage.is_none(), "{:?}", replayed.first_difference);

    let recording = page.open(Open::Recording { name: "placed.mcap".to_owned() });
    let info = page.session(|one| one["id"] == recording && one["connection"] == "connected");
    assert_eq!(info["can"]["operate"], false);
    let error = page.ask(ball(1.0, 0.5)).unwrap_err();
    assert!(error["text"].as_str().unwrap().contains("a recording cannot be operated"), "{error}");
    let lines = page.lines();
    let is_placement = |line: &&serde_json::Value| line["text"].as_str().unwrap().starts_with("act place_ball(");
    assert_eq!(lines.iter().filter(is_placement).count(), placed);
}

#[test]
fn a_span_of_a_running_world_and_of_a_recording_is_kept() {
    let (page, _) = running();
    page.cycle(250);
    let keep = |name: &str, from_us, until_us| page.ask(Request::KeepSpan { name: name.to_owned(), from_us, until_us });
    keep("part", 500_000, 1_500_000).unwrap();
    let span = |name: &str| {
        let (_, info) = opened(&page, name);
        (info["from_us"].as_u64().unwrap(), info["until_us"].as_u64().unwrap())
    };
    // A recording begins at zero, and the second span is one of the first.
    assert_eq!(span("part.mcap"), (0, 1_000_000));
    keep("less", 600_000, 700_000).unwrap();
    assert_eq!(span("less.mcap"), (0, 100_000));
    let error = keep("none", 2_600_000, 2_700_000).unwrap_err();
    assert!(error["text"].as_str().unwrap().contains("no such span: it ends at 0.10 s"), "{error}");
    let files = std::fs::read_dir(page.bench.folder.0.join("recordings")).unwrap();
    assert_eq!(files.count(), 2, "what was not kept is removed");
}
