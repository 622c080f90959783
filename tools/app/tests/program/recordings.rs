//! Recordings of a robot, and their replay.

use crate::process::{Folder, refused, run};

#[test]
fn recording_replays_bit_for_bit_and_with_other_parameters() {
    let folder = Folder::new("recorded");
    let (all, none) = (folder.file("all.mcap"), folder.file("none.mcap"));
    for (file, images) in [(&all, "all"), (&none, "none")] {
        let ran = run(&["--seconds", "12", "--set", "Explorer.gain=2", "--record", file, "--images", images]);
        assert!(ran.stdout.contains("600 cycles"), "{}{}", ran.stdout, ran.stderr);
        let replayed = run(&["replay", file, "--json"]);
        let report = replayed.json();
        assert_eq!((replayed.code, &report["equal"], &report["cycles"]), (Some(0), &true.into(), &600.into()));
    }
    let closed = run(&["replay", &all, "--closed-loop", "--set", "Explorer.speed=0.6", "--json"]);
    let report = closed.json();
    assert_eq!((closed.code, &report["equal"], &report["loop"]), (Some(1), &false.into(), &"closed".into()));
    assert_ne!(report["total_decisions"], 0, "{report}");
    assert!(run(&["replay", &all, "--against", &none]).stdout.contains("equal, bit for bit"));
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
    refused(&["replay", &folder.file("none.mcap")], &["none.mcap", "help: "]);
}
