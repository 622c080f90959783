//! Runs and parameters.

use std::fs;

use serde_json::json;

use crate::process::{Folder, Ran, example, refused, run};

#[test]
fn run_ends_at_its_aim_with_equal_results_each_time() {
    let ran = run(&["run", "--json"]);
    let report = ran.json();
    assert_eq!((ran.code, &report["result"]), (Some(0), &"done".into()), "{}", ran.stderr);
    let last = report["story"].as_array().and_then(|story| story.last()).expect("a change of state");
    assert_eq!((&last["component"], &last["state"]), (&"Explorer".into(), &"arrive".into()));
    assert!(ran.stderr.contains("Explorer:round_end") && ran.stderr.contains("The lap is complete."), "{}", ran.stderr);
    // Without a command the program runs the robot, too.
    assert_eq!(run(&["--json"]).stdout, ran.stdout);
}

#[test]
fn run_that_ends_before_its_aim_is_unsuccessful() {
    let ran = run(&["--seconds", "3", "--json"]);
    let report = ran.json();
    assert_eq!((ran.code, &report["result"], &report["cycles"]), (Some(1), &"limit".into(), &150.into()));
}

#[test]
#[cfg(all(target_arch = "x86_64", target_env = "gnu"))]
fn processor_is_another_kind_without_fma() {
    let mut program = example("wall_follower");
    program.args(["--seconds", "0.1", "--json"]).env("GLIBC_TUNABLES", "glibc.cpu.hwcaps=-FMA,-AVX2");
    let (without, here) = (Ran::of(program).json(), run(&["--seconds", "0.1", "--json"]).json());
    let differs = without["wall_processor"] != here["wall_processor"];
    assert_eq!(differs, std::arch::is_x86_feature_detected!("fma"), "{without} {here}");
}

#[test]
fn tune_file_and_assignment_change_the_run_alike() {
    let (folder, set) = (Folder::new("tune"), ["--set", "Explorer.speed=0.3"]);
    let (file, seconds) = (folder.file("slow.toml"), ["--seconds", "9", "--json"]);
    let written = run(&[&["params", "--write", &file][..], &set].concat());
    assert_eq!(written.code, Some(0), "{}", written.stderr);
    assert!(written.stdout.contains("1 value"), "{}", written.stdout);
    assert!(fs::read_to_string(&file).expect("the file").contains("[Explorer]\n"));
    refused(&[&["params", "--write", &file][..], &set].concat(), &[&file, "exists", "--force"]);
    assert_eq!(run(&[&["params", "--force", "--write", &file][..], &set].concat()).code, Some(0));
    let tuned = run(&[&seconds[..], &["--tune", &file]].concat());
    assert!(tuned.stderr.contains(&format!("{file}: Explorer.speed=0.3")), "{}", tuned.stderr);
    let [tuned, set, default] = [tuned, run(&[&seconds[..], &set].concat()), run(&seconds)].map(|ran| {
        let mut report = ran.json();
        let layers = report["layers"].take();
        (report, layers)
    });
    assert_eq!(tuned.0, set.0);
    assert_ne!(tuned.0, default.0);
    let speed = |source: &str| json!([{ "source": source, "values": ["Explorer.speed=0.3"] }]);
    assert_eq!([tuned.1, set.1, default.1], [speed(&file), speed("--set"), json!([])]);
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
