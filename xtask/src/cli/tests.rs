//! Tests of the parser. Command lines are only parsed, so a wrong one that is accepted starts no task.

use clap::CommandFactory;

use super::*;

fn parse(words: &str) -> Result<Cli, clap::Error> {
    Cli::try_parse_from(["xtask"].into_iter().chain(words.split_whitespace()))
}

/// Asserts that a command line is refused with a message that contains all of these parts.
fn assert_refused(words: &str, parts: &[&str]) {
    let error = parse(words).expect_err(words);
    assert_eq!(error.exit_code(), 2, "{words}");
    let message = error.to_string();
    for part in parts {
        assert!(message.contains(part), "the message for `{words}` lacks `{part}`:\n{message}");
    }
}

#[test]
fn the_command_line_is_consistent() {
    Cli::command().debug_assert();
}

#[test]
fn each_fuzz_target_runs_for_a_minute_by_default() {
    let seconds = |words: &str| match parse(words).map(|cli| cli.task) {
        Ok(Some(Task::Fuzz(options))) => Some(options.seconds),
        _ => None,
    };
    assert_eq!([seconds("fuzz"), seconds("fuzz --seconds 20")], [Some(60), Some(20)]);
    assert_refused("fuzz --seconds 0", &["0 is not in 1..", "--seconds <N>"]);
    for wrong in ["-1", "1.5", "soon"] {
        assert_refused(&format!("fuzz --seconds={wrong}"), &[&format!("'{wrong}'"), "--seconds <N>"]);
    }
}

#[test]
fn a_missing_value_is_reported() {
    assert_refused("fuzz --seconds", &["--seconds <N>", "none was supplied"]);
}

#[test]
fn a_wrong_task_is_reported_with_the_nearest_one() {
    assert_refused("firmwre", &["'firmwre'", "'firmware'", "--help"]);
    assert_refused("ci ci", &["'ci'", "Usage: cargo xtask ci"]);
    assert_refused("ci --without no_std", &["'no_std'", "'no-std'"]);
    assert_refused("ci --without miri --only deny", &["'--without", "'--only"]);
}

#[test]
fn a_wrong_option_is_reported_with_the_nearest_one() {
    assert_refused("firmware --bles", &["'--bles'", "'--bless'", "Usage: cargo xtask firmware"]);
    assert_refused("mujoco --quick", &["'--quick'", "Usage: cargo xtask mujoco"]);
}

#[test]
fn options_that_exclude_each_other_are_refused() {
    assert_refused("firmware --build --fuzz", &["'--build'", "'--fuzz'"]);
    assert_refused("firmware --bless --size", &["'--bless'", "'--size'"]);
    assert_refused("peers --quick --slow", &["'--quick'", "'--slow'"]);
}
