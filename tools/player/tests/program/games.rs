//! Games: the same seed gives the same game, told to people and to machines.

use serde_json::{Value, json};

use crate::run::{Ran, run, without_wall};

fn story(args: &[&str]) -> Value {
    let mut told = run(args).json();
    without_wall(&mut told);
    told
}

fn code_of(told: &Value) -> i32 {
    i32::from(told["result"] != "goal")
}

#[test]
fn the_same_seed_gives_the_same_game_and_another_seed_another() {
    let game = |seed| story(&["--seed", seed, "--seconds", "4", "--json"]);
    let (first, again, other) = (game("3"), game("3"), game("4"));
    assert_eq!(first, again);
    assert_ne!(first["fingerprint"], other["fingerprint"]);
}

#[test]
fn any_number_of_threads_plays_the_same_games() {
    let games =
        |threads| story(&["play", "--seed", "5", "--games", "5", "--seconds", "3", "--json", "--threads", threads]);
    let one = games("1");
    assert_eq!(one, games("2"));
    assert_eq!(one, games("7"));
    let seeds: Vec<&Value> = one["games"].as_array().unwrap().iter().map(|game| &game["seed"]).collect();
    assert_eq!(json!(seeds), json!([5, 6, 7, 8, 9]));
    let alone = story(&["--seed", "7", "--seconds", "3", "--json"]);
    assert_eq!(one["games"][2]["fingerprint"], alone["fingerprint"]);
}

#[test]
fn a_game_is_told_to_machines_on_stdout_and_to_people_on_stderr() {
    let Ran { code, stderr, .. } = &run(&["--seconds", "3", "--json"]);
    assert!(stderr.contains("look_for_ball") && stderr.contains("latency") && stderr.contains("declared"), "{stderr}");
    let told = run(&["--seconds", "3", "--json"]).json();
    assert_eq!(told["schema"], "bica-player/game/1");
    assert_eq!(*code, Some(code_of(&told)));
    assert_eq!((&told["cycles"], &told["simulated_s"]), (&300.into(), &3.0.into()));
    assert_eq!(told["story"].as_array().unwrap().len() as u64, told["tree_changes"].as_u64().unwrap());
    assert_eq!(told["story"][0]["state"], "look_for_ball");
    assert!(told["wall"]["latency_ms"]["p50"].as_f64().unwrap() <= told["wall"]["latency_ms"]["max"].as_f64().unwrap());
}

#[test]
fn rates_that_are_reached_are_those_declared() {
    let told = run(&["--seconds", "5", "--json"]).json();
    let components = told["components"].as_array().unwrap();
    assert!(components.iter().any(|component| component["runs"] == 0), "something is latent all the time");
    for component in components.iter().filter(|component| component["active_s"].as_f64() > Some(0.0)) {
        let number = |name: &str| component[name].as_f64().unwrap();
        let (runs, starts) = (number("runs"), number("activations"));
        let due = number("declared_hz") * number("active_s");
        assert!((runs - due).abs() <= starts + 1.0, "{component}");
    }
}

#[test]
fn without_json_people_are_told_on_stdout() {
    let ran = run(&["--seconds", "2"]);
    assert_eq!(ran.stderr, "");
    for word in ["active components", "look_for_ball", "BallDetector", "result", "share", "p99"] {
        assert!(ran.stdout.contains(word), "`{word}` is missing in:\n{}", ran.stdout);
    }
    assert!(!ran.stdout.contains('\x1b'), "no colours where there is no terminal");
}

#[test]
fn many_games_end_in_a_table_and_an_exit_code() {
    let args = ["play", "--games", "3", "--seconds", "1", "--threads", "2"];
    let ran = run(&args);
    assert_eq!((ran.code, ran.stderr.as_str()), (Some(1), ""), "no game is won in a second");
    for word in ["goals", "0 of 3", "time to goal", "falls", "latency", "no goal", "0 1 2"] {
        assert!(ran.stdout.contains(word), "`{word}` is missing in:\n{}", ran.stdout);
    }
    let contented = run(&[&args[..], &["--at-least", "0"]].concat());
    assert_eq!(contented.code, Some(0));
}

#[test]
fn more_robots_and_other_images_make_other_games() {
    let print = |args: &[&str]| story(&[&["--seconds", "2", "--json"], args].concat())["fingerprint"].clone();
    let plain = print(&[]);
    assert_ne!(plain, print(&["--size", "160x120"]));
    assert_ne!(plain, Value::Null);
    assert!(run(&["--seconds", "1", "--robots", "8", "--size", "640x480", "--json"]).json()["cycles"] == 100);
}
