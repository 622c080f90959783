//! Tests of the program as its user runs it.

use std::process::Command;

use bica_test_data::process::{Folder, Ran};

/// Records a session twice with one seed. Both recordings must be equal, and must replay with equal commands, also with
/// the world simulated again.
fn recordings_replay(world: &str) {
    let folder = Folder::new(world);
    let run = |arguments: &[&str]| {
        let mut program = Command::new(env!("CARGO_BIN_EXE_therapy"));
        program.args(arguments).current_dir(folder.path());
        Ran::of(program)
    };
    assert_eq!(run(&["new", "example.session"]).code, Some(0));
    for file in ["a.mcap", "b.mcap"] {
        let play = ["play", "example.session", "--world", world, "--seed", "7", "--seconds", "60"];
        // The session is not finished after this time, so the exit code is 1.
        assert_eq!(run(&[&play[..], &["--record", file]].concat()).code, Some(1));
    }
    for more in [&[][..], &["--against", "b.mcap"], &["--closed-loop"]] {
        let Ran { code, stdout, stderr } = run(&[&["replay", "a.mcap"], more].concat());
        assert!(code == Some(0) && stdout.contains("equal, bit for bit"), "{more:?}: {stdout}{stderr}");
    }
}

#[test]
fn recordings_of_a_session_replay_bit_for_bit() {
    recordings_replay("room");
}

#[cfg(feature = "mujoco")]
#[test]
fn recordings_in_mujoco_replay_bit_for_bit() {
    recordings_replay("mujoco");
}
