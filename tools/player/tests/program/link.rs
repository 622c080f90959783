//! `player play --serve` and `player link`, as processes.

use std::io::Read;
use std::time::Duration;

use bica_link::{Client, ClientOptions, Event};
use bica_wire::message::WorldChange;
use serde_json::Value;

use crate::process::{Served, player, run};

/// Starts a game with these arguments and a server for monitors.
pub(crate) fn serve(args: &[&str]) -> Served {
    Served::start(player(&[&["play", "--serve", "127.0.0.1:0"][..], args].concat()))
}

fn small_game(more: &[&str]) -> Served {
    serve(&[&["--seed", "3", "--size", "160x120"][..], more].concat())
}

/// Runs a monitor and returns its exit code, the lines of its output, and its messages.
pub(crate) fn monitor(served: &Served, args: &[&str]) -> (Option<i32>, Vec<Value>, String) {
    let ran = run(&[&["link", &served.address, "--json"][..], args].concat());
    (ran.code, ran.lines(), ran.stderr)
}

/// Waits for the end of the game; returns its output.
pub(crate) fn finish(mut served: Served) -> String {
    let mut text = String::new();
    served.stdout.read_to_string(&mut text).expect("UTF-8");
    served.child.wait().expect("it ends");
    text
}

#[test]
fn a_served_world_is_shown() {
    let (game, folder) = (small_game(&[]), crate::process::Folder::new("link-images"));
    let args = ["watch", "--conditions", "Player", "--costs", "--truth", "--images", folder.text(), "--count", "130"];
    let (code, lines, errors) = monitor(&game, &args);
    assert_eq!(code, Some(0), "{errors}");
    for kind in ["snapshot/1", "conditions/1", "costs/1", "truth/2", "image/2"] {
        let schema = format!("bica/link-{kind}");
        assert!(lines.iter().any(|line| line["schema"] == *schema), "{kind}");
    }
    let image = lines.iter().find(|line| line["schema"] == "bica/link-image/2").expect("an image");
    let pixels = std::fs::read(image["path"].as_str().expect("a path")).expect("a file");
    assert_eq!(pixels.len(), 160 * 120 * 2);
}

#[test]
fn a_game_begins_paused_and_pauses_at_breakpoints() {
    let folder = crate::process::Folder::new("link-breakpoints");
    let file = folder.file("stops.txt");
    std::fs::write(&file, "# The first approach\nPlayer.ball_seen # a transition\n").expect("a file");
    let mut game = small_game(&["--paused", "--breakpoints", &file, "--seconds", "60"]);
    let (_, stepped, errors) = monitor(&game, &["step", "1"]);
    assert_eq!(stepped[0]["cycle"].as_u64(), Some(1), "no cycle ran before: {errors}");
    let mut client =
        Client::connect(&game.address.parse().expect("an address"), ClientOptions::default()).expect("a link");
    client.acquire(false).expect("the lease");
    client.change_world(WorldChange::Resume).expect("it goes on");
    client.release().expect("the lease is given back");
    let expected = "breakpoint: Player takes `ball_seen` from `look_for_ball` to `approach`";
    let mut next = || client.poll(Duration::from_mins(1)).expect("a link").expect("the breakpoint is reached");
    while !matches!(next(), Event::Log(line) if line.text == expected) {}
    let cycle = || monitor(&game, &["step", "1"]).1[0]["cycle"].as_u64().expect("a number");
    assert_eq!(cycle() + 1, cycle(), "the world is paused");
    game.child.kill().expect("a process");
    game.child.wait().expect("it ends");
    let ran = run(&["play", "--paused"]);
    assert!(ran.code == Some(2) && ran.stderr.contains("--serve"), "{}", ran.stderr);
}

#[test]
fn game_with_a_placed_ball_replays() {
    let folder = crate::process::Folder::new("link-ball");
    let file = &folder.file("run.mcap");
    let game = small_game(&["--seconds", "6", "--record", file, "--images", "none"]);
    let (code, _, errors) = monitor(&game, &["pause"]);
    assert_eq!(code, Some(0), "{errors}");
    for at in [["2.5", "-1.5"], ["-2.875", "1.5"]] {
        let (code, lines, errors) = monitor(&game, &["act", "place_ball", at[0], at[1]]);
        assert_eq!(code, Some(0), "{errors}");
        assert_eq!(lines[0]["schema"], "bica/link-done/1");
        let (_, stepped, errors) = monitor(&game, &["step", "10"]);
        let cycle = lines[0]["cycle"].as_u64().expect("a number");
        assert_eq!(stepped[0]["cycle"].as_u64(), Some(cycle + 10), "{errors}");
    }
    for (args, error) in [
        (&["act", "place_ball", "3.5", "0"][..], "3.5 is outside -3..=3"),
        (&["act", "place_ball", "3", "0.7"], "a goal post is there"),
        (&["act", "place_ball", "NaN", "0"], "the value is not finite"),
        (&["act", "place_ball", "1"], "give these: x, y"),
        (&["act", "place_bal", "1", "0"], "did you mean `place_ball`?"),
    ] {
        let (code, _, errors) = monitor(&game, args);
        assert_eq!(code, Some(2), "{args:?}");
        assert!(errors.contains(error), "{args:?}: {errors}");
    }
    let (_, lines, errors) = monitor(&game, &["act"]);
    assert_eq!(
        (&lines[0]["schema"], &lines[0]["actions"][0]["name"]),
        (&"bica/link-actions/1".into(), &"place_ball".into()),
        "{errors}"
    );
    assert_eq!(monitor(&game, &["resume"]).0, Some(0));
    let (code, lines, errors) = monitor(&game, &["watch", "--truth", "--count", "20"]);
    assert_eq!(code, Some(0), "{errors}");
    let truth = lines.iter().find(|line| line["schema"] == "bica/link-truth/2").expect("the true state");
    let ball = truth["items"].as_array().expect("items").iter().find(|item| item["name"] == "ball").expect("the ball");
    assert_eq!((&ball["value"]["x"], &ball["value"]["y"]), (&(-2.875).into(), &1.5.into()));
    finish(game);
    let info = run(&["record", "info", file, "--json"]).json();
    let requests: Vec<_> = info["requests"].as_array().expect("a list").iter().map(|one| &one["request"]).collect();
    assert_eq!(requests, ["act place_ball(2.5, -1.5)", "act place_ball(-2.875, 1.5)"]);
    let replayed = run(&["replay", file, "--json"]);
    assert_eq!(replayed.code, Some(0), "{}", replayed.stdout);
}
