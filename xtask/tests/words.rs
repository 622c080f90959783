//! What the program says before it does any chore.

use std::process::Command;

/// The exit code, and what was said on both streams.
struct Said {
    code: Option<i32>,
    stdout: String,
    stderr: String,
}

fn xtask(words: &[&str]) -> Said {
    let done = Command::new(env!("CARGO_BIN_EXE_xtask")).args(words).output().expect("the program starts");
    let text = |bytes| String::from_utf8(bytes).expect("text");
    Said { code: done.status.code(), stdout: text(done.stdout), stderr: text(done.stderr) }
}

const CHORES: [&str; 10] =
    ["no-std", "firmware", "mujoco", "budget", "buildtime", "fuzz", "opencv", "miri", "peers", "ci"];

#[test]
fn without_a_word_and_when_asked_it_lists_the_chores() {
    for words in [&[][..], &["help"], &["--help"], &["-h"]] {
        let said = xtask(words);
        assert_eq!((said.code, said.stderr.as_str()), (Some(0), ""), "{words:?}");
        let lines: Vec<&str> = said.stdout.lines().map(str::trim).collect();
        assert!(
            CHORES.iter().all(|chore| lines.iter().any(|line| line.starts_with(&format!("{chore} ")))),
            "{lines:?}"
        );
        assert!(lines.contains(&"Usage: cargo xtask [CHORE]"), "{lines:?}");
    }
}

#[test]
fn every_chore_can_be_asked_about() {
    for chore in CHORES {
        for words in [[chore, "--help"], ["help", chore]] {
            let said = xtask(&words);
            assert_eq!(said.code, Some(0), "{words:?}");
            assert!(said.stdout.contains(&format!("Usage: cargo xtask {chore}")), "{}", said.stdout);
        }
    }
}

#[test]
fn what_is_no_chore_fails_with_2_and_prints_no_result() {
    let said = xtask(&["frob"]);
    assert_eq!((said.code, said.stdout.as_str()), (Some(2), ""));
    assert!(said.stderr.contains("'frob'") && said.stderr.contains("Usage: cargo xtask [CHORE]"), "{}", said.stderr);
}
