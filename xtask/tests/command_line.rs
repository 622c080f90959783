//! Output of the program without a task.

use std::process::Command;

/// Exit code, and the text of both streams.
struct Output {
    code: Option<i32>,
    stdout: String,
    stderr: String,
}

fn xtask(words: &[&str]) -> Output {
    let done = Command::new(env!("CARGO_BIN_EXE_xtask")).args(words).output().expect("the program starts");
    let text = |bytes| String::from_utf8(bytes).expect("text");
    Output { code: done.status.code(), stdout: text(done.stdout), stderr: text(done.stderr) }
}

const TASKS: [&str; 7] = ["firmware", "mujoco", "fuzz", "peers", "browser", "long", "ci"];

#[test]
fn without_arguments_and_with_help_it_lists_the_tasks() {
    for words in [&[][..], &["help"], &["--help"], &["-h"]] {
        let output = xtask(words);
        assert_eq!((output.code, output.stderr.as_str()), (Some(0), ""), "{words:?}");
        let lines: Vec<&str> = output.stdout.lines().map(str::trim).collect();
        assert!(TASKS.iter().all(|task| lines.iter().any(|line| line.starts_with(&format!("{task} ")))), "{lines:?}");
        assert!(lines.contains(&"Usage: cargo xtask [TASK]"), "{lines:?}");
    }
}

#[test]
fn every_task_has_a_help_text() {
    for task in TASKS {
        for words in [[task, "--help"], ["help", task]] {
            let output = xtask(&words);
            assert_eq!(output.code, Some(0), "{words:?}");
            assert!(output.stdout.contains(&format!("Usage: cargo xtask {task}")), "{}", output.stdout);
        }
    }
}

#[test]
fn unknown_task_exits_with_2() {
    let output = xtask(&["frob"]);
    assert_eq!((output.code, output.stdout.as_str()), (Some(2), ""));
    assert!(
        output.stderr.contains("'frob'") && output.stderr.contains("Usage: cargo xtask [TASK]"),
        "{}",
        output.stderr
    );
}
