//! Runs and parameters.

use std::fs;

use crate::process::{Folder, refused, run};

#[test]
fn run_ends_at_its_aim_with_equal_results_each_time() {
    let ran = run(&["run", "--json"]);
    let report = ran.json();
    assert_eq!((ran.code, &report["result"]), (Some(0), &"done".into()), "{}", ran.stderr);
    let last = report["story"].as_array().and_then(|story| story.last()).expect("a change of state");
    assert_eq!((&last["component"], &last["state"]), (&"Explorer".into(), &"arrive".into()));
    assert!(ran.stderr.contains("Explorer:round_end") && ran.stderr.contains("The lap is complete."), "{}", ran.stderr);
    // Without a command the program runs, too.
    assert_eq!(run(&["--json"]).stdout, ran.stdout);
}

#[test]
fn run_that_ends_before_its_aim_is_unsuccessful() {
    let ran = run(&["--seconds", "3", "--json"]);
    let report = ran.json();
    assert_eq!((ran.code, &report["result"], &report["cycles"]), (Some(1), &"limit".into(), &150.into()));
}

#[test]
fn tune_file_and_assignment_change_the_run_alike() {
    let (folder, set) = (Folder::new("tune"), ["--set", "Explorer.speed=0.3"]);
    let (file, seconds) = (folder.file("slow.toml"), ["--seconds", "9", "--json"]);
    let written = run(&[&["params", "--write", &file][..], &set].concat());
    assert_eq!(written.code, Some(0), "{}", written.stderr);
    assert!(fs::read_to_string(&file).expect("the file").contains("[Explorer]\n"));
    let tuned = run(&[&seconds[..], &["--tune", &file]].concat());
    assert_eq!(tuned.stdout, run(&[&seconds[..], &set].concat()).stdout);
    assert_ne!(tuned.stdout, run(&seconds).stdout);
}

#[test]
fn wrong_arguments_are_refused_with_a_remedy() {
    refused(&["run", "--world", "moon"], &["moon", "room"]);
    refused(&["run", "--option", "size=3"], &["`room` has no option `size`", "help: "]);
    refused(&["run", "--option", "size"], &["`size`", "NAME=VALUE"]);
    refused(&["run", "--set", "Explorer.sped=0.3"], &["did you mean `speed`?"]);
    refused(&["run", "--set", "Explorer.speed=9"], &["Explorer.speed", "0.1 to 0.6"]);
    refused(&["run", "--tune", "none.toml"], &["none.toml", "help: "]);
    refused(&["graph", "--format", "bmp"], &["bmp", "svg, dot, mermaid, json"]);
}

#[test]
fn help_describes_the_robot_and_its_commands() {
    for (args, first) in [
        (&["--help"][..], "A two-wheeled robot that follows walls."),
        (&["run", "--help"], "Run the robot in a world (the default command)"),
        (&["params", "--help"], "List the parameters of the components and their values; write a tune file"),
    ] {
        let help = run(args);
        assert_eq!((help.code, help.stdout.lines().next()), (Some(0), Some(first)), "{args:?}");
    }
}

#[test]
fn tree_is_drawn() {
    assert!(run(&["graph"]).stdout.starts_with("<svg"));
    assert_eq!(run(&["graph", "--json"]).json()["name"], "WallFollower");
}
