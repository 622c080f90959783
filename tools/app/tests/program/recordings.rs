//! Recordings of a robot, and their replay.

use std::path::Path;
use std::process::Command;

use crate::process::{Folder, Served, example, link, refused, run};

#[test]
fn recording_replays_with_other_parameters() {
    let folder = Folder::new("recorded");
    let (all, none) = (folder.file("all.mcap"), folder.file("none.mcap"));
    for (file, images) in [(&all, "all"), (&none, "none")] {
        let ran = run(&["--seconds", "12", "--set", "Explorer.gain=2", "--record", file, "--images", images]);
        assert!(ran.stdout.contains("600 cycles"), "{}{}", ran.stdout, ran.stderr);
        let replayed = run(&["replay", file, "--json"]);
        let report = replayed.json();
        assert_eq!((replayed.code, &report["equal"], &report["cycles"]), (Some(0), &true.into(), &600.into()));
    }
    let open = run(&["replay", &all, "--set", "Explorer.gain=3", "--json"]);
    let report = open.json();
    assert_eq!((open.code, &report["equal"], &report["set"][0]), (Some(1), &false.into(), &"Explorer.gain=3".into()));
    assert!(report["first_difference"]["field"].as_str().is_some_and(|one| one.starts_with("command")), "{report}");
    assert!(open.stderr.contains("other parameters: Explorer.gain=3"), "{}", open.stderr);
    let closed = run(&["replay", &all, "--closed-loop", "--set", "Explorer.speed=0.6", "--json"]);
    let report = closed.json();
    assert_eq!((closed.code, &report["equal"], &report["loop"]), (Some(1), &false.into(), &"closed".into()));
    assert_ne!(report["total_decisions"], 0, "{report}");
    assert!(run(&["replay", &all, "--against", &none]).stdout.contains("equal, bit for bit"));
}

#[test]
fn recording_has_figures_and_program_version() {
    let folder = Folder::new("figures");
    let file = folder.file("run.mcap");
    let ran = run(&["--seconds", "2.5", "--record", &file, "--json"]).json();
    assert_eq!((&ran["figures"][0]["name"], &ran["figures"][0]["unit"]), (&"travelled".into(), &"m".into()), "{ran}");
    assert!(ran["figures"][0]["value"].as_f64().is_some_and(|metres| metres > 0.1), "{ran}");
    let info = run(&["record", "info", &file, "--json"]).json();
    assert_eq!(info["ending"]["figures"], ran["figures"]);
    let program = &info["header"]["program"];
    // The commit of BICA is not the commit of the robot's sources.
    assert_eq!((&program["version"], &program["git_hash"]), (&env!("CARGO_PKG_VERSION").into(), &"".into()));
    assert!(program["bica"].as_str().is_some_and(|bica| bica.starts_with(env!("CARGO_PKG_VERSION"))), "{program}");
    assert_eq!(program["processor"], ran["wall_processor"]);
}

#[test]
fn recording_names_its_world_and_replaces_no_file() {
    let folder = Folder::new("named");
    let file = folder.file("run.mcap");
    run(&["--seconds", "1", "--seed", "7", "--record", &file]);
    let set_up = &run(&["record", "info", &file, "--json"]).json()["header"]["set_up"];
    assert_eq!((&set_up["world"], &set_up["seed"]), (&"room".into(), &7.into()));
    refused(&["--seconds", "1", "--record", &file], &[&file, "--force"]);
    refused(&["replay", &file, "--set", "Explorer.gain=9"], &["Explorer.gain", "0.5 to 5.0"]);
    let twice = ["replay", &file, "--set", "Explorer.gain=3", "--set", "Explorer.gain=3"];
    refused(&twice, &["--set sets one parameter twice"]);
    refused(&["replay", &file, "--set", "Explorer.gian=3"], &["did you mean `gain`?"]);
    refused(&["replay", &file, "--set", "Explorer.gain=3", "--against", &file], &["--set", "--against"]);
    refused(&["replay", &folder.file("none.mcap")], &["none.mcap", "help: "]);
}

#[test]
fn split_run_is_joined_and_replayed() {
    let folder = Folder::new("split");
    let [file, first, second, third, fourth, whole] =
        ["run", "run-001", "run-002", "run-003", "run-004", "whole"].map(|name| folder.file(&format!("{name}.mcap")));
    let split = ["--seconds", "5", "--record", &file, "--split", "2s", "--images", "none"];
    let ran = run(&split);
    assert!(ran.stdout.contains(&format!("{first} and 2 more parts")), "{}{}", ran.stdout, ran.stderr);
    assert!(!Path::new(&file).exists() && !Path::new(&fourth).exists());
    let part = &run(&["record", "info", &second, "--json"]).json()["header"]["part"];
    assert_eq!((&part["number"], part["run"].as_str().map(str::len)), (&2.into(), Some(16)), "{part}");
    refused(&["replay", &second], &["run-002.mcap` is part 2 of a run", "run-001.mcap", "record merge"]);
    refused(&["record", "merge", &whole, &first, &third], &["part 2 of the run", "is missing"]);
    assert!(!Path::new(&whole).exists(), "nothing is written");
    refused(&["record", "merge", &first, &first, &second, &third, "--force"], &["the same file"]);
    let merged = run(&["record", "merge", &whole, &first, &second, &third, "--json"]).json();
    assert_eq!(merged["cycles"], 250);
    let replayed = run(&["replay", &whole, "--json"]);
    assert_eq!((replayed.code, &replayed.json()["cycles"]), (Some(0), &250.into()), "{}", replayed.stderr);
    std::fs::remove_file(&first).expect("a part");
    refused(&split, &["run-00", "exists already", "--force"]);
    assert!(!Path::new(&first).exists(), "nothing is written");
    let forced = run(&[&split[..], &["--force"]].concat());
    assert!(forced.stdout.contains("and 2 more parts"), "{}", forced.stderr);
    for (limit, words) in [("5", "`5` has no unit"), ("10m", "no unit of time or size"), ("1KB", "10min")] {
        refused(&["--record", &file, "--split", limit], &[words]);
    }
    refused(&["--split", "10min"], &["--record"]);
}

#[test]
fn robots_are_merged_for_viewers() {
    let folder = Folder::new("merged");
    let [alice, bob, out] = ["alice.mcap", "bob.mcap", "match.mcap"].map(|name| folder.file(name));
    run(&["--seconds", "1", "--record", &alice]);
    run(&["--seconds", "1", "--seed", "2", "--record", &bob]);
    refused(&["record", "merge", &out, &alice, &alice], &["is given twice"]);
    let other = folder.file("other/alice.mcap");
    std::fs::create_dir(folder.file("other")).and_then(|()| std::fs::copy(&bob, &other)).expect("room");
    refused(&["record", "merge", &out, &alice, &other], &[&alice, &other, "rename one of the two"]);
    assert!(!Path::new(&out).exists(), "nothing is written");
    let merged = run(&["record", "merge", &out, &alice, &bob, "--json"]);
    assert_eq!((merged.code, &merged.json()["cycles"]), (Some(0), &100.into()), "{}", merged.stderr);
    refused(&["record", "info", &out], &["not a recording of a robot"]);
}

#[cfg(unix)]
#[test]
fn played_recording_is_watched_until_ctrl_c() {
    let folder = Folder::new("played");
    let file = folder.file("run.mcap");
    run(&["--seconds", "4", "--set", "Explorer.speed=0.3", "--record", &file]);
    let mut program = example("wall_follower");
    program.args(["record", "play", &file, "--serve", "127.0.0.1:0", "--loop", "--speed", "2"]);
    let mut served = Served::start(program);
    let watched = link(&served, &["watch", "WallDetector.distance", "--count", "150"]);
    let of = |schema: &'static str| watched.iter().filter(move |line| line["schema"] == schema);
    let [snapshots, distances] = ["bica/link-snapshot/1", "bica/link-info/1"].map(|schema| of(schema).count());
    assert!(snapshots > 1 && distances > 10, "{snapshots} snapshots, {distances} distances");
    let explorer = &link(&served, &["describe", "Explorer"])[0]["components"][0];
    let speed = explorer["params"].as_array().and_then(|list| list.iter().find(|one| one["name"] == "speed"));
    assert_eq!(speed.map(|one| &one["value"]), Some(&0.3.into()), "the recorded one");
    refused(&["link", &served.address, "set", "Explorer.speed=0.5"], &["does not offer to be operated"]);
    let id = served.child.id().to_string();
    assert!(Command::new("kill").args(["-INT", &id]).status().expect("kill runs").success());
    assert_eq!(served.child.wait().expect("it ends").code(), Some(130));
    for (args, words) in [
        (&["--speed", "0"][..], "from 0.01 to 100"),
        (&["--from", "2", "--until", "1"], "--until is before --from"),
        (&["--from", "9"], "has no cycle in the span"),
    ] {
        run(&[&["record", "play", &file, "--serve", "127.0.0.1:0"], args].concat()).refused(&[words]);
    }
    refused(&["record", "play", &file], &["--serve"]);
    refused(&["record", "play", &file, "--serve", "0.0.0.0:0"], &["--listen-anywhere"]);
}
