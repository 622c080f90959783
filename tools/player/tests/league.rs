//! Games in the league's server; `cargo xtask ci --only league` runs them.

use std::path::Path;
use std::process::{Command, Output};

use bica_test_data::process::Folder;

fn player(arguments: &[&str]) -> Output {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    Command::new(env!("CARGO_BIN_EXE_player")).args(arguments).current_dir(workspace).output().expect("the program")
}

fn game(seconds: &str, more: &[&str]) -> Output {
    let game = ["play", "--world", "league", "--robot", "t1", "--seed", "3", "--seconds", seconds];
    player(&[&game[..], more].concat())
}

/// The recording holds the robot's perception but not the true pose, so the commands of the replay cannot depend on it.
#[test]
#[ignore = "needs the league's server: cargo xtask ci --only league"]
fn recorded_game_replays_bit_for_bit() {
    let folder = Folder::new("league");
    let file = folder.file("game.mcap");
    let played = game("25", &["--record", &file]);
    assert_eq!(played.status.code(), Some(1), "no goal in 25 s: {played:?}");
    let states = String::from_utf8_lossy(&played.stdout);
    assert!(states.contains("approach") && !states.contains("blind"), "a sense has a fault: {played:?}");
    let replayed = player(&["replay", &file]);
    let text = String::from_utf8_lossy(&replayed.stdout);
    assert!(replayed.status.success() && text.contains("equal, bit for bit"), "{replayed:?}");
    let other = player(&["replay", &file, "--set", "FaceBall.gain=0.5"]);
    assert_eq!(other.status.code(), Some(1), "another gain moves the head in another way: {other:?}");
}

#[test]
#[ignore = "needs the league's server: cargo xtask ci --only league"]
fn second_team_plays_in_the_same_server() {
    let played = game("5", &["--against"]);
    let text = String::from_utf8_lossy(&played.stdout);
    assert!(played.status.code() == Some(1) && text.contains("no goal in 5 s"), "{played:?}");
}

#[test]
#[cfg(feature = "mujoco")]
#[ignore = "needs the league's server: cargo xtask ci --only league"]
fn film_has_a_picture_for_each_moment() {
    let folder = Folder::new("league");
    let file = folder.file("game.gif");
    let played = game("3", &["--film", &file]);
    let text = String::from_utf8_lossy(&played.stdout);
    let count = text.lines().find_map(|line| line.strip_prefix("film")?.trim().split(' ').next()?.parse::<u32>().ok());
    // A film of 3 s with one picture each 70 ms.
    assert!(played.status.code() == Some(1) && count.is_some_and(|count| (41..46).contains(&count)), "{played:?}");
    assert!(std::fs::read(&file).expect("the film").starts_with(b"GIF89a"));
}

#[test]
fn wrong_arguments_are_named() {
    for (arguments, expected) in [
        (&["--server", "nowhere"][..], "HOST:PORT"),
        (&["--server", "127.0.0.1:1"], "--server"),
        (&["--server", "127.0.0.1:1", "--against"], "--against"),
        (&["--number", "100"], "0 to 99"),
        (&["--team", "two words"], "--team"),
        (&["--film", "game.gif", "--record", "game.mcap"], "leave out --film"),
    ] {
        let refused = game("5", arguments);
        let text = String::from_utf8_lossy(&refused.stderr);
        assert!(refused.status.code() == Some(2) && text.contains(expected), "{arguments:?}: {text}");
    }
}
