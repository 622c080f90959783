//! `player play --serve` and `player link`, as processes.

use std::io::{BufRead, BufReader, Read};
use std::process::{Child, ChildStdout, Command, Stdio};

use serde_json::Value;

use crate::process::{player, run};

/// A game in a process of its own that serves monitors.
pub(crate) struct Served {
    child: Child,
    stdout: BufReader<ChildStdout>,
    address: String,
}

impl Served {
    fn start(more: &[&str]) -> Self {
        Self::play(&[&["--seed", "3", "--size", "160x120"][..], more].concat())
    }

    /// Starts a game with these arguments.
    pub(crate) fn play(args: &[&str]) -> Self {
        let args = [&["play", "--serve", "127.0.0.1:0"][..], args].concat();
        let mut child = player(&args).stdout(Stdio::piped()).spawn().expect("the program starts");
        let mut stdout = BufReader::new(child.stdout.take().expect("a pipe"));
        let mut line = String::new();
        let address = loop {
            line.clear();
            assert_ne!(stdout.read_line(&mut line).expect("UTF-8"), 0, "the game ended");
            if let Some((_, address)) = line.split_once("monitors attach at ") {
                break address.trim().to_owned();
            }
        };
        Self { child, stdout, address }
    }

    fn link(&self, args: &[&str]) -> Command {
        player(&[&["link", &self.address][..], args].concat())
    }

    /// Runs a monitor and returns its exit code and the lines of its output.
    pub(crate) fn monitor(&self, args: &[&str]) -> (Option<i32>, Vec<Value>, String) {
        let ran = run(&[&["link", &self.address, "--json"][..], args].concat());
        let lines = ran.stdout.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
        (ran.code, lines, ran.stderr)
    }

    /// Waits for the end of the game; returns the lines of its output.
    pub(crate) fn finish(mut self) -> Vec<String> {
        let lines = self.stdout.by_ref().lines().map(Result::unwrap).collect();
        self.child.wait().expect("it ends");
        lines
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Returns the fingerprint in the summary of a game.
fn fingerprint(lines: &[String]) -> &str {
    lines.iter().find_map(|line| line.split_once("fingerprint ")).expect("a fingerprint").1
}

#[test]
fn monitors_change_no_command_of_a_game() {
    let alone = run(&["play", "--seed", "3", "--size", "160x120"]);
    let alone: Vec<_> = alone.stdout.lines().map(str::to_owned).collect();
    let game = Served::start(&["--unpaced"]);
    let mut other = game.link(&["watch"]).stdout(Stdio::null()).spawn().expect("the program starts");
    let (code, lines, errors) = game.monitor(&["watch", "FaceBall.error", "--count", "50"]);
    assert_eq!(code, Some(0), "{errors}");
    let snapshots = lines.iter().filter(|line| line["schema"] == "bica/link-snapshot/1");
    let cycles: Vec<_> = snapshots.map(|line| line["cycle"].as_u64().expect("a number")).collect();
    assert!(cycles.len() == 50 && cycles.is_sorted_by(|a, b| a < b), "{cycles:?}");
    let served = game.finish();
    other.kill().expect("it can be ended");
    other.wait().expect("it ends");
    assert_eq!(fingerprint(&served), fingerprint(&alone));
}

#[test]
fn an_operator_describes_sets_holds_changes_rates_and_calls() {
    let game = Served::start(&["--seconds", "600"]);
    let (code, lines, _) = game.monitor(&["describe", "FaceBall"]);
    assert_eq!(code, Some(0));
    let [component] = &lines[0]["components"].as_array().expect("a list")[..] else { panic!("{lines:?}") };
    let params = component["params"].as_array().expect("a list");
    let gain = params.iter().find(|param| param["name"] == "gain").expect("a gain");
    assert_eq!((&gain["kind"], &gain["value"]), (&Value::from("f32"), &gain["default"]));

    let (code, lines, _) = game.monitor(&["set", "FaceBall.gain=0.875"]);
    assert_eq!((code, &lines[0]["value"]), (Some(0), &Value::from(0.875)));
    let (_, lines, _) = game.monitor(&["describe", "FaceBall"]);
    let params = lines[0]["components"][0]["params"].as_array().expect("a list");
    assert!(params.iter().any(|param| param["value"] == 0.875), "a parameter stays");

    for (args, error) in [
        (&["set", "FaceBall.gain=9"][..], "is outside"),
        (&["set", "FaceBall.gain=high"], "`high` is not a value of `gain`"),
        (&["set", "FaceBall.gian=0.5"], "did you mean `gain`?"),
        (&["set", "FaceBal.gain=0.5"], "did you mean `FaceBall`?"),
        (&["hold", "Playr", "latent"], "did you mean `Player`?"),
        (&["watch", "FaceBall.eror"], "did you mean `error`?"),
        (&["modulate", "Body.go", "1"], "takes 2 arguments, found 1"),
    ] {
        let (code, _, errors) = game.monitor(args);
        assert_eq!(code, Some(2), "{args:?}");
        assert!(errors.contains(error), "{args:?}: {errors}");
    }

    let (code, lines, errors) = game.monitor(&["rate", "FaceBall", "5", "--seconds", "0.05"]);
    assert_eq!((code, &lines[0]["values"][0]), (Some(0), &Value::from(5.0)), "{errors}");
    let (code, ..) = game.monitor(&["hold", "FaceBall", "latent", "--seconds", "0.05"]);
    assert_eq!(code, Some(0));
    let (code, _, errors) = game.monitor(&["modulate", "Body.go", "0.1", "-0.5"]);
    assert_eq!(code, Some(0), "{errors}");
    let (_, lines, _) = game.monitor(&["watch", "--count", "1"]);
    let components = lines[0]["components"].as_array().expect("a list");
    let face = components.iter().find(|component| component["name"] == "FaceBall").expect("FaceBall");
    assert_eq!((&face["held"], &face["hz"]), (&Value::from("tree"), &Value::from(30.0)), "the lease has ended");
}

#[cfg(unix)]
#[test]
fn a_stopped_operator_loses_its_lease_and_its_hold() {
    let game = Served::start(&["--seconds", "600"]);
    let mut operator = game.link(&["hold", "Player", "latent"]).stdout(Stdio::piped()).spawn().expect("it starts");
    let mut told = String::new();
    BufReader::new(operator.stdout.as_mut().expect("a pipe")).read_line(&mut told).expect("UTF-8");
    assert!(told.contains("in force"), "{told}");
    let (_, lines, _) = game.monitor(&["watch", "--count", "1"]);
    assert_eq!(
        (&lines[0]["components"][0]["name"], &lines[0]["components"][0]["held"]),
        (&"Player".into(), &"latent".into())
    );
    let (code, _, errors) = game.monitor(&["set", "FaceBall.gain=0.5"]);
    assert_eq!(code, Some(2));
    assert!(errors.contains("another operator owns the lease"), "{errors}");

    let signal = |name: &str, id: u32| Command::new("kill").args([name, &id.to_string()]).status().expect("kill runs");
    assert!(signal("-STOP", operator.id()).success());
    let (_, lines, _) = game.monitor(&["log", "--count", "1"]);
    assert_eq!(lines[0]["text"], "operator: silent for too long, holds and rates end");
    let (_, lines, _) = game.monitor(&["watch", "--count", "1"]);
    assert_eq!(lines[0]["components"][0]["held"], "tree");
    let (code, ..) = game.monitor(&["set", "FaceBall.gain=0.5"]);
    assert_eq!(code, Some(0), "the lease is free");

    assert!(signal("-CONT", operator.id()).success());
    assert_eq!(operator.wait().expect("it ends").code(), Some(2), "its lease has ended");
}

#[test]
fn a_game_with_an_operator_is_recorded_and_replayed() {
    let folder = crate::process::Folder::new("link");
    let file = folder.path().join("run.mcap");
    let file = file.to_str().expect("UTF-8");
    let game = Served::start(&["--unpaced", "--record", file, "--images", "none"]);
    let mut kept = 0;
    for gain in ["0.5", "0.9", "0.3"] {
        let (code, lines, _) = game.monitor(&["set", &format!("FaceBall.gain={gain}")]);
        kept += usize::from(code == Some(0) && lines.len() == 1);
    }
    assert!(kept > 0, "the game ended before the first request");
    game.finish();
    let replayed = run(&["replay", file, "--json"]);
    assert_eq!(replayed.code, Some(0), "{}", replayed.stdout);
}

#[test]
fn wrong_addresses_are_errors() {
    for (args, error) in [
        (&["play", "--serve", "0.0.0.0:0"][..], "--listen-anywhere"),
        (&["play", "--serve", "nowhere"], "HOST:PORT"),
        (&["play", "--serve", "/dev/no-such-line"], "no link at /dev/no-such-line"),
        (&["link", "127.0.0.1:1", "describe"], "no link at 127.0.0.1:1"),
        (&["play", "--unpaced"], "--serve"),
    ] {
        let ran = run(args);
        assert_eq!(ran.code, Some(2), "{args:?}");
        assert!(ran.stderr.contains(error), "{args:?}: {}", ran.stderr);
    }
}

#[test]
fn a_served_world_is_paused_stepped_continued_and_shown() {
    let game = Served::start(&[]);
    let world = |args: &[&str]| {
        let (code, lines, errors) = game.monitor(args);
        assert_eq!(code, Some(0), "{errors}");
        let line = lines.last().expect("a line");
        assert_eq!(line["schema"], "bica/link-world/1");
        (line["cycle"].as_u64().expect("a number"), line["paused"].as_bool().expect("a truth value"))
    };
    let (last, paused) = world(&["pause"]);
    assert!(paused);
    assert_eq!(world(&["step", "5"]), (last + 6, true), "the next cycle after five");
    assert!(!world(&["resume"]).1);
    let folder = std::env::temp_dir().join(format!("link-images-{}", std::process::id()));
    let path = folder.to_str().expect("UTF-8");
    let args = ["watch", "--conditions", "Player", "--costs", "--truth", "--images", path, "--count", "130"];
    let (code, lines, errors) = game.monitor(&args);
    assert_eq!(code, Some(0), "{errors}");
    for kind in ["snapshot", "conditions", "costs", "truth", "image"] {
        let schema = format!("bica/link-{kind}/1");
        assert!(lines.iter().any(|line| line["schema"] == *schema), "{kind}");
    }
    let image = lines.iter().find(|line| line["schema"] == "bica/link-image/1").expect("an image");
    let pixels = std::fs::read(image["path"].as_str().expect("a path")).expect("a file");
    assert_eq!(pixels.len(), 160 * 120 * 2);
    std::fs::remove_dir_all(folder).expect("it can be removed");
}

#[test]
fn the_ball_of_a_served_world_is_placed_and_the_game_replays() {
    let folder = crate::process::Folder::new("link-ball");
    let file = folder.path().join("run.mcap");
    let file = file.to_str().expect("UTF-8");
    let game = Served::start(&["--seconds", "6", "--record", file, "--images", "none"]);
    let (code, _, errors) = game.monitor(&["pause"]);
    assert_eq!(code, Some(0), "{errors}");
    for at in [["2.5", "-1.5"], ["-2.875", "1.5"]] {
        let (code, lines, errors) = game.monitor(&["act", "place_ball", at[0], at[1]]);
        assert_eq!(code, Some(0), "{errors}");
        assert_eq!(lines[0]["schema"], "bica/link-done/1");
        let (_, stepped, errors) = game.monitor(&["step", "10"]);
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
        let (code, _, errors) = game.monitor(args);
        assert_eq!(code, Some(2), "{args:?}");
        assert!(errors.contains(error), "{args:?}: {errors}");
    }
    let (_, lines, errors) = game.monitor(&["act"]);
    assert_eq!(
        (&lines[0]["schema"], &lines[0]["actions"][0]["name"]),
        (&"bica/link-actions/1".into(), &"place_ball".into()),
        "{errors}"
    );
    assert_eq!(game.monitor(&["resume"]).0, Some(0));
    let (code, lines, errors) = game.monitor(&["watch", "--truth", "--count", "20"]);
    assert_eq!(code, Some(0), "{errors}");
    let truth = lines.iter().find(|line| line["schema"] == "bica/link-truth/1").expect("the true state");
    assert_eq!(truth["ball"], serde_json::json!([-2.875, 1.5]));
    game.finish();
    let info = run(&["record", "info", file, "--json"]).json();
    let requests: Vec<_> = info["requests"].as_array().expect("a list").iter().map(|one| &one["request"]).collect();
    assert_eq!(requests, ["act place_ball(2.5, -1.5)", "act place_ball(-2.875, 1.5)"]);
    let replayed = run(&["replay", file, "--json"]);
    assert_eq!(replayed.code, Some(0), "{}", replayed.stdout);
}
