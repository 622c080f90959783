//! Games: reproducible, and printed as text and as JSON.

use bica_recording::Recording;
use serde_json::Value;

use crate::process::{Folder, Ran, run, without_wall};

fn game(args: &[&str]) -> Value {
    let mut printed = run(args).json();
    without_wall(&mut printed);
    printed
}

fn code_of(printed: &Value) -> i32 {
    i32::from(printed["result"] != "goal")
}

#[test]
fn options_set_up_the_start_and_faults_that_are_told() {
    let start = ["--option", "robot=0,0,0", "--option", "ball=1,0.5", "--option", "image=drop", "--option", "from=1"];
    let args = [&["--seconds", "4", "--size", "160x120", "--json"], &start[..]].concat();
    let (told, printed) = (run(&args).stderr, game(&args));
    assert_eq!(printed["faults"].as_array().unwrap().len(), 1, "{printed}");
    let (t, fault) = (printed["faults"][0]["t"].as_f64().unwrap(), &printed["fault"]);
    assert!((2.0..3.0).contains(&t) && *fault == "the camera sends no images", "{printed}");
    assert!(told.contains("* fault: the camera sends no images") && told.contains("blind"), "{told}");
    let ball = |story: &Value| {
        story["story"].as_array().unwrap().iter().find_map(|change| change["ball"].as_object().cloned())
    };
    assert!(ball(&printed).is_some_and(|ball| (ball["distance"].as_f64().unwrap() - 1.1).abs() < 0.2), "{printed}");
}

#[test]
fn two_faults_at_once_are_both_reported() {
    let faults = ["--option", "image=drop", "--option", "hot=LKneePitch", "--option", "from=1"];
    let ran = run(&[&["--seconds", "5", "--size", "160x120", "--json"], &faults[..]].concat());
    let both = "LKneePitch is too hot; the camera sends no images";
    assert_eq!(ran.json()["fault"], both);
    assert!(ran.stderr.contains(&format!("* fault: {both}")), "{}", ran.stderr);
}

/// Faults of senses and joints, as options of the world, and what the robot says.
const FAULTS: [(&str, &str); 13] = [
    ("image=freeze", "the camera repeats the same image"),
    ("image=dark", "the camera's images are black"),
    ("image=bright", "the camera's images are white"),
    ("image=drop", "the camera sends no images"),
    ("gyro=0.2", "the gyroscope measures a turn that the robot does not make"),
    ("gyro=0.1", "the gyroscope measures a turn that the robot does not make"),
    ("gyro=-0.1", "the gyroscope measures a turn that the robot does not make"),
    ("stuck=HeadYaw", "HeadYaw does not follow its target"),
    ("stuck=HeadPitch", "HeadPitch does not follow its target"),
    ("stuck=LHipRoll", "LHipRoll does not follow its target"),
    ("stuck=RAnklePitch", "RAnklePitch does not follow its target"),
    ("stuck=LKneePitch", "LKneePitch does not follow its target"),
    ("hot=LKneePitch", "LKneePitch is too hot"),
];

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_each_fault_is_named_within_5_s() {
    for (option, fault) in FAULTS {
        let faulty = ["--option", option, "--option", "from=8", "--games", "10", "--seconds", "13"];
        let series = run(&[&faulty[..], &["--size", "160x120", "--json"]].concat()).json();
        let games = series["games"].as_array().expect("games");
        let whole = games.iter().filter(|game| game["simulated_s"].as_f64().is_some_and(|seconds| seconds >= 13.0));
        assert!(whole.clone().count() >= 9, "{option}");
        for game in whole {
            assert_eq!(game["faults"][0]["fault"], fault, "{option}, seed {}", game["seed"]);
        }
    }
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_each_fault_has_its_line_entry_and_message() {
    let folder = Folder::new("faults");
    for (option, fault) in FAULTS {
        let file = folder.file("fault.mcap");
        let faulty = ["--option", option, "--option", "from=8", "--option", "until=13", "--seconds", "15"];
        let kept = ["--size", "160x120", "--json", "--record", &file, "--force", "--images", "none"];
        let ran = run(&[faulty, kept].concat());
        assert!(ran.stderr.contains(&format!("* fault: {fault}")), "{option}: {}", ran.stderr);
        assert_eq!(ran.json()["faults"][0]["fault"], fault, "{option}");
        let mut recording = Recording::open(file.as_ref()).expect("a recording");
        let next = || recording.next_cycle().expect("a whole recording");
        let texts: Vec<String> = std::iter::from_fn(next).flat_map(|cycle| cycle.log).map(|line| line.text).collect();
        assert_eq!(texts.first(), Some(&format!("fault: {fault}")), "{option}: {texts:?}");
    }
}

#[test]
fn json_goes_to_stdout_and_text_to_stderr() {
    let Ran { code, stderr, .. } = &run(&["--seconds", "3", "--json"]);
    assert!(stderr.contains("look_for_ball") && stderr.contains("latency") && stderr.contains("declared"), "{stderr}");
    let printed = run(&["--seconds", "3", "--json"]).json();
    assert_eq!(printed["schema"], "bica-player/game/1");
    assert_eq!(*code, Some(code_of(&printed)));
    assert_eq!((&printed["cycles"], &printed["simulated_s"]), (&300.into(), &3.0.into()));
    assert_eq!(printed["story"].as_array().unwrap().len() as u64, printed["tree_changes"].as_u64().unwrap());
    assert_eq!(printed["story"][0]["state"], "look_for_ball");
    assert!(
        printed["wall"]["latency_ms"]["p50"].as_f64().unwrap()
            <= printed["wall"]["latency_ms"]["max"].as_f64().unwrap()
    );
}

#[test]
fn components_reach_their_declared_rates() {
    let printed = run(&["--seconds", "5", "--json"]).json();
    let components = printed["components"].as_array().unwrap();
    assert!(components.iter().any(|component| component["runs"] == 0), "every component is active at some time");
    for component in components.iter().filter(|component| component["active_s"].as_f64().expect("a duration") > 0.0) {
        let number = |name: &str| component[name].as_f64().unwrap();
        let (runs, starts) = (number("runs"), number("activations"));
        let due = number("declared_hz") * number("active_s");
        assert!((runs - due).abs() <= starts + 1.0, "{component}");
    }
}

#[test]
fn without_json_text_goes_to_stdout() {
    let ran = run(&["--seconds", "2"]);
    assert_eq!(ran.stderr, "");
    for word in ["active components", "look_for_ball", "BallDetector", "result", "share", "p99"] {
        assert!(ran.stdout.contains(word), "`{word}` is missing in:\n{}", ran.stdout);
    }
    assert!(!ran.stdout.contains('\x1b'), "colours without a terminal");
}

#[test]
fn a_series_ends_with_a_summary_and_an_exit_code() {
    let args = ["play", "--games", "3", "--seconds", "1", "--threads", "2"];
    let ran = run(&args);
    assert_eq!((ran.code, ran.stderr.as_str()), (Some(1), ""), "a goal within a second");
    for word in ["goals", "0 of 3", "time to goal", "falls", "latency", "no goal", "0 1 2"] {
        assert!(ran.stdout.contains(word), "`{word}` is missing in:\n{}", ran.stdout);
    }
    let accepted = run(&[&args[..], &["--at-least", "0"]].concat());
    assert_eq!(accepted.code, Some(0));
}

#[test]
fn robots_and_image_size_change_the_game() {
    let print = |args: &[&str]| game(&[&["--seconds", "2", "--json"], args].concat())["fingerprint"].clone();
    let plain = print(&[]);
    assert_ne!(plain, print(&["--size", "160x120"]));
    assert_ne!(plain, Value::Null);
    let crowded = run(&["--seconds", "0.5", "--robots", "8", "--size", "640x480", "--json"]).json();
    assert_eq!(crowded["cycles"], 50);
}
