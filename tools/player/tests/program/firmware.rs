//! Games controlled by firmware on an emulated microcontroller.
//!
//! Tests that need a firmware image run if `BICA_IMAGE` names one at build time. `cargo xtask firmware` builds the
//! image from these sources and sets the variable.

use std::env;
use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};

use serde_json::Value;

use crate::link::{finish, monitor, serve};
use crate::process::{Folder, Ran, player, run, without_wall};

/// Returns the arguments of a game with the firmware image.
fn with_image<'a>(image: &'a mut String, more: &[&'a str]) -> Vec<&'a str> {
    *image = env::var("BICA_IMAGE").expect("the tests were built with a firmware image: set BICA_IMAGE again");
    [&["play", "--world", "firmware", "--image", image], more].concat()
}

/// Removes all values that depend on the computer.
fn story(mut printed: Value) -> Value {
    without_wall(&mut printed);
    printed
}

#[test]
#[cfg_attr(not(firmware_image), ignore = "needs a firmware image: run `cargo xtask firmware`")]
fn firmware_plays_the_same_game() {
    let mut image = String::new();
    let game = ["--seed", "3", "--seconds", "3", "--json"];
    let args = with_image(&mut image, &game);
    let ran = run(&args);
    let mut printed = story(ran.json());
    let spent = printed.as_object_mut().and_then(|printed| printed.remove("firmware")).expect("instruction counts");
    let alone = run(&[&game[..], &["--size", "160x120"]].concat());
    assert_eq!(ran.code, alone.code);
    assert_eq!(printed, story(alone.json()), "the same game, bit for bit");
    assert_eq!(spent["chain"]["runs"], printed["cycles"]);
    assert!(
        spent["chain"]["max"].as_u64().is_some_and(|max| max > 100_000),
        "a cycle with an image takes more: {spent}"
    );
    let runs = |list: &Value| -> Vec<Value> {
        list.as_array().unwrap().iter().map(|component| component["name"].clone()).collect()
    };
    assert_eq!(runs(&spent["components"]), runs(&printed["components"]));
}

#[test]
#[cfg_attr(not(firmware_image), ignore = "needs a firmware image: run `cargo xtask firmware`")]
fn each_firmware_image_plays_sizes_that_fit() {
    let mut image = String::new();
    with_image(&mut image, &[]);
    let medium = format!("{image}-medium");
    let game = ["--seed", "3", "--seconds", "1", "--json", "--size"];
    for size in ["160x120", "320x240"] {
        let play = ["play", "--world", "firmware", "--image", &medium];
        let mut printed = story(run(&[&play[..], &game, &[size]].concat()).json());
        assert!(printed.as_object_mut().and_then(|printed| printed.remove("firmware")).is_some(), "instruction counts");
        assert_eq!(printed, story(run(&[&game[..], &[size]].concat()).json()), "{size}: the same game, bit for bit");
    }
    let Ran { code, stderr, .. } = run(&with_image(&mut String::new(), &["--seconds", "1", "--size", "320x240"]));
    assert_eq!(code, Some(2), "{stderr}");
    for word in [&*image, "19200 pixels, not 320x240", "forward-an500-medium", "--size 160x120"] {
        assert!(stderr.contains(word), "`{word}` is missing in:\n{stderr}");
    }
}

/// The microcontroller computed the commands. From the recording, the code on the host must compute the same ones.
#[test]
#[cfg_attr(not(firmware_image), ignore = "needs a firmware image: run `cargo xtask firmware`")]
fn a_recorded_firmware_game_replays_on_the_host() {
    let folder = Folder::new("recorded-firmware");
    for (images, source) in [("all", "stored"), ("none", "rules")] {
        let file = folder.path().join(format!("{images}.mcap"));
        let file = file.to_str().expect("UTF-8");
        let mut image = String::new();
        let args = with_image(&mut image, &["--seed", "3", "--seconds", "2", "--record", file, "--images", images]);
        let played = run(&args);
        assert_eq!(played.code, Some(1), "no goal in two seconds: {}", played.stderr);
        let info = run(&["record", "info", file, "--json"]).json();
        assert_eq!(info["header"]["set_up"]["world"], "firmware");
        let replayed = run(&["replay", file, "--json"]).json();
        assert_eq!((&replayed["equal"], &replayed["cycles"]), (&true.into(), &200.into()), "{replayed}");
        assert_eq!(replayed["source"], source);
    }
}

/// A request that did not reach both sides would make their commands differ, which ends the game with code 2.
#[test]
#[cfg_attr(not(firmware_image), ignore = "needs a firmware image: run `cargo xtask firmware`")]
fn operated_firmware_game_replays() {
    let folder = Folder::new("operated-firmware");
    let file = folder.path().join("game.mcap");
    let file = file.to_str().expect("UTF-8");
    let image = env::var("BICA_IMAGE").expect("the tests were built with a firmware image: set BICA_IMAGE again");
    let image = format!("{image}-monitor");
    let game = ["--world", "firmware", "--image", &image, "--seed", "3", "--seconds", "12", "--record", file];
    let served = serve(&game);
    for (args, kind) in [
        // A paused game does not end, however slow these programs are.
        (&["pause"][..], "world"),
        (&["set", "FaceBall.gain=0.875"], "set"),
        (&["modulate", "Body.go", "0.1", "-0.5"], "done"),
        (&["step", "30"], "world"),
        (&["act", "place_ball", "1.5", "-0.5"], "done"),
        (&["rate", "FaceBall", "5", "--seconds", "0.1"], "done"),
        (&["step", "30"], "world"),
        (&["resume"], "world"),
        (&["hold", "FaceBall", "latent", "--seconds", "0.3"], "done"),
    ] {
        let (code, lines, errors) = monitor(&served, args);
        assert_eq!(code, Some(0), "{args:?}: {errors}");
        assert_eq!(lines[0]["schema"], *format!("bica/link-{kind}/1"), "{args:?}");
    }
    let text = finish(served);
    assert!(text.contains("no goal"), "{text}");
    let info = run(&["record", "info", file, "--json"]).json();
    assert_eq!(info["header"]["set_up"]["world"], "firmware");
    let replayed = run(&["replay", file, "--json"]).json();
    assert_eq!((&replayed["equal"], &replayed["cycles"]), (&true.into(), &1200.into()), "{replayed}");
}

#[test]
#[cfg_attr(not(firmware_image), ignore = "needs a firmware image: run `cargo xtask firmware`")]
fn summary_gives_instructions() {
    let mut image = String::new();
    let args = with_image(&mut image, &["--seconds", "1"]);
    let Ran { code, stdout, stderr } = run(&args);
    assert_eq!((code, stderr.as_str()), (Some(1), ""), "no goal in a second");
    for word in ["look_for_ball", "no goal", "sense-think-act median", "instructions", "BallDetector"] {
        assert!(stdout.contains(word), "`{word}` is missing in:\n{stdout}");
    }
    assert!(!stdout.contains("µs") && !stdout.contains("p99"), "{stdout}");
}

#[test]
#[cfg_attr(not(firmware_image), ignore = "needs a firmware image: run `cargo xtask firmware`")]
fn firmware_games_are_equal_on_any_threads() {
    let mut image = String::new();
    let games = ["--games", "3", "--seconds", "1", "--json", "--threads"];
    let args = with_image(&mut image, &games);
    let printed = |threads| story(run(&[&args[..], &[threads]].concat()).json());
    assert_eq!(printed("1"), printed("3"));
}

#[cfg(unix)]
#[test]
#[cfg_attr(not(firmware_image), ignore = "needs a firmware image: run `cargo xtask firmware`")]
fn ctrl_c_ends_a_firmware_game_with_its_summary() {
    use std::os::unix::process::CommandExt;

    let mut image = String::new();
    let args = with_image(&mut image, &["--seed", "0"]);
    let mut program = player(&args);
    // A terminal sends Ctrl-C to the whole process group of the program.
    let mut child = program.process_group(0).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut reader = BufReader::new(child.stdout.take().unwrap());
    // In the middle of the game the program waits most of the time for the emulator.
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
fn errors_name_what_is_missing_and_how_to_install_it() {
    let output = |program: &mut Command| {
        let ended = program.output().unwrap();
        (ended.status.code(), String::from_utf8(ended.stderr).unwrap())
    };
    let play = ["play", "--world", "firmware", "--image"];
    let (code, error) = output(&mut player(&[&play[..], &["no/such/image"]].concat()));
    assert_eq!(code, Some(2), "{error}");
    assert!(error.contains("no/such/image") && error.contains("cargo xtask firmware"), "{error}");

    let no_program = player(&[&play[..], &["Cargo.toml"]].concat()).env("PATH", "").output().unwrap();
    let error = String::from_utf8(no_program.stderr).unwrap();
    assert_eq!(no_program.status.code(), Some(2), "{error}");
    assert!(error.contains("qemu-system-arm") && error.contains("cargo xtask firmware"), "{error}");

    let (code, error) = output(&mut player(&[&play[..], &["Cargo.toml", "--size", "640x480"]].concat()));
    assert_eq!(code, Some(2), "{error}");
    assert!(error.contains("--size 160x120") && error.contains("--size 320x240"), "{error}");
}
