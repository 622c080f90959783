//! What is said to words. They are only read here: a word that should be refused must not start a chore.

use clap::CommandFactory;

use super::*;

fn read(words: &str) -> Result<Cli, clap::Error> {
    Cli::try_parse_from(["xtask"].into_iter().chain(words.split_whitespace()))
}

/// The words are refused, and what is said holds all of this.
fn is_refused(words: &str, parts: &[&str]) {
    let error = read(words).expect_err(words);
    assert_eq!(error.exit_code(), 2, "{words}");
    let said = error.to_string();
    for part in parts {
        assert!(said.contains(part), "`{words}` does not say `{part}`:\n{said}");
    }
}

#[test]
fn the_command_line_is_sound() {
    Cli::command().debug_assert();
}

#[test]
fn a_limit_is_a_time() {
    let asked = read("buildtime --limit 0.5").map(|cli| cli.chore);
    let Ok(Some(Chore::Buildtime(Buildtime { limit }))) = asked else { panic!("{asked:?}") };
    assert_eq!(limit, Some(Duration::from_millis(500)));
    is_refused("buildtime --limit never", &["'never'", "--limit <SECONDS>", "such as 0.1"]);
    for wrong in ["", "-1", "NaN", "inf"] {
        is_refused(&format!("buildtime --limit={wrong}"), &["--limit <SECONDS>"]);
    }
}

#[test]
fn each_target_is_fed_for_a_minute_unless_said() {
    let seconds = |words: &str| match read(words).map(|cli| cli.chore) {
        Ok(Some(Chore::Fuzz(asked))) => Some(asked.seconds),
        _ => None,
    };
    assert_eq!([seconds("fuzz"), seconds("fuzz --seconds 20")], [Some(60), Some(20)]);
    is_refused("fuzz --seconds 0", &["0 is not in 1..", "--seconds <N>"]);
    for wrong in ["-1", "1.5", "soon"] {
        is_refused(&format!("fuzz --seconds={wrong}"), &[&format!("'{wrong}'"), "--seconds <N>"]);
    }
}

#[test]
fn a_missing_value_is_asked_for() {
    is_refused("fuzz --seconds", &["--seconds <N>", "none was supplied"]);
    is_refused("buildtime --limit", &["--limit <SECONDS>", "none was supplied"]);
}

#[test]
fn a_wrong_chore_is_named_with_the_one_that_may_be_meant() {
    is_refused("budgt", &["'budgt'", "'budget'", "--help"]);
    is_refused("no_std", &["'no_std'", "'no-std'"]);
    is_refused("ci ci", &["'ci'", "Usage: cargo xtask ci"]);
}

#[test]
fn a_wrong_option_is_named_with_the_one_that_may_be_meant() {
    is_refused("budget --bles", &["'--bles'", "'--bless'", "Usage: cargo xtask budget"]);
    is_refused("opencv --quick", &["'--quick'", "Usage: cargo xtask opencv"]);
}

#[test]
fn what_cannot_be_done_at_once_is_refused() {
    is_refused("firmware --build --fuzz", &["'--build'", "'--fuzz'"]);
    is_refused("budget --bless --slow", &["'--bless'", "'--slow'"]);
    is_refused("peers --quick --slow", &["'--quick'", "'--slow'"]);
}
