//! Games in which an emulated microcontroller thinks.
//!
//! Those that need its image run if `BICA_IMAGE` names one, as `cargo xtask firmware` does when it has built it: an image
//! of other sources than these would only prove that it is of others.

use std::env;
use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};

use serde_json::Value;

use crate::run::{Ran, player, run, without_wall};

/// The arguments of a game with the image, and what else is asked; none if there is no image.
fn with_image<'a>(image: &'a mut String, more: &[&'a str]) -> Option<Vec<&'a str>> {
    let Ok(named) = env::var("BICA_IMAGE") else {
        eprintln!("skipped: BICA_IMAGE names no firmware image; `cargo xtask firmware` does");
        return None;
    };
    *image = named;
    Some([&["play", "--world", "firmware", "--image", image], more].concat())
}

/// A game's words without those of the clock.
fn story(mut told: Value) -> Value {
    without_wall(&mut told);
    told
}

#[test]
fn the_microcontroller_tells_the_same_story_and_counts_instructions() {
    let mut image = String::new();
    let game = ["--seed", "3", "--seconds", "3", "--json"];
    let Some(args) = with_image(&mut image, &game) else { return };
    let ran = run(&args);
    let mut told = story(ran.json());
    let spent = told.as_object_mut().and_then(|told| told.remove("firmware")).expect("what it spent");
    let alone = run(&[&game[..], &["--size", "160x120"]].concat());
    assert_eq!(ran.code, alone.code);
    assert_eq!(told, story(alone.json()), "the same game, bit for bit");
    assert_eq!(spent["chain"]["runs"], told["cycles"]);
    assert!(spent["chain"]["max"].as_u64() > Some(100_000), "a cycle with an image takes its time: {spent}");
    let runs = |list: &Value| -> Vec<Value> {
        list.as_array().unwrap().iter().map(|component| component["name"].clone()).collect()
    };
    assert_eq!(runs(&spent["components"]), runs(&told["components"]));
}

#[test]
fn people_are_told_instructions_instead_of_microseconds() {
    let mut image = String::new();
    let Some(args) = with_image(&mut image, &["--seconds", "1"]) else { return };
    let Ran { code, stdout, stderr } = run(&args);
    assert_eq!((code, stderr.as_str()), (Some(1), ""), "no goal in a second");
    for word in ["look_for_ball", "no goal", "sense-think-act median", "instructions", "BallDetector"] {
        assert!(stdout.contains(word), "`{word}` is missing in:\n{stdout}");
    }
    assert!(!stdout.contains("µs") && !stdout.contains("p99"), "{stdout}");
}

#[test]
fn games_of_several_microcontrollers_at_once_are_those_of_one() {
    let mut image = String::new();
    let games = ["--games", "3", "--seconds", "1", "--json", "--threads"];
    let Some(args) = with_image(&mut image, &games) else { return };
    let told = |threads| story(run(&[&args[..], &[threads]].concat()).json());
    assert_eq!(told("1"), told("3"));
}

#[cfg(unix)]
#[test]
fn ctrl_c_ends_the_game_with_its_summary_though_the_emulator_hears_it_too() {
    use std::os::unix::process::CommandExt;

    let mut image = String::new();
    let Some(args) = with_image(&mut image, &["--seed", "0"]) else { return };
    let mut program = player(&args);
    // A terminal gives Ctrl-C to the whole group of what it has started.
    let mut child = program.process_group(0).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut reader = BufReader::new(child.stdout.take().unwrap());
    // In the middle of the game the program waits for the emulator most of the time.
    let mut line = String::new();
    while !line.contains("approach") {
        line.clear();
        assert_ne!(reader.read_line(&mut line).unwrap(), 0, "no such state");
    }
    let group = format!("-{}", child.id());
    assert!(Command::new("kill").args(["-INT", "--", &group]).status().unwrap().success());
    let rest: Vec<String> = reader.lines().map(Result::unwrap).collect();
    let ended = child.wait_with_output().unwrap();
    assert_eq!((ended.status.code(), String::from_utf8_lossy(&ended.stderr).as_ref()), (Some(130), ""), "{rest:?}");
    assert!(rest.iter().any(|line| line.contains("stopped before the end")), "{rest:?}");
    assert!(rest.iter().any(|line| line.contains("instructions")), "{rest:?}");
}

#[test]
fn what_is_missing_is_said_and_how_to_get_it() {
    let said = |program: &mut Command| {
        let ended = program.output().unwrap();
        (ended.status.code(), String::from_utf8(ended.stderr).unwrap())
    };
    let play = ["play", "--world", "firmware", "--image"];
    let (code, error) = said(&mut player(&[&play[..], &["no/such/image"]].concat()));
    assert_eq!(code, Some(2), "{error}");
    assert!(error.contains("no/such/image") && error.contains("cargo xtask firmware"), "{error}");

    let no_program = player(&[&play[..], &["Cargo.toml"]].concat()).env("PATH", "").output().unwrap();
    let error = String::from_utf8(no_program.stderr).unwrap();
    assert_eq!(no_program.status.code(), Some(2), "{error}");
    assert!(error.contains("qemu-system-arm") && error.contains("cargo xtask firmware"), "{error}");

    let (code, error) = said(&mut player(&[&play[..], &["Cargo.toml", "--size", "320x240"]].concat()));
    assert_eq!(code, Some(2), "{error}");
    assert!(error.contains("160x120") && error.contains("--size"), "{error}");
}
