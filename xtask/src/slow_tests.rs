//! Tests that take too long for `cargo test`.
//!
//! Such a test has the attribute `#[ignore = "slow: …"]`, and its name begins with `slow_`. CI runs these tests by their
//! prefix, in addition to all others, and compares the names in the sources with those that passed.

use std::fs;
use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};

use crate::process::{output, root};

/// Beginning of the attribute of a slow test.
const ATTRIBUTE: &str = "#[ignore = \"slow: ";
/// Beginning of the name of a slow test.
const PREFIX: &str = "slow_";

/// Runs all slow tests of the workspace.
///
/// # Errors
/// If there is none, if one has a name without the prefix, if one fails, or if one did not run.
pub(crate) fn run() -> Result<(), String> {
    let files = output("git", &["grep", "--files-with-matches", "--fixed-strings", ATTRIBUTE, "--", "*.rs"], &[])?;
    let mut expected = Vec::new();
    for file in files.lines() {
        let text = fs::read_to_string(root().join(file)).map_err(|error| format!("cannot read {file}: {error}"))?;
        expected.extend(names(&text).map_err(|error| format!("{file}: {error}"))?);
    }
    let missing = missing(expected, &test()?);
    if missing.is_empty() { Ok(()) } else { Err(format!("slow tests that did not run: {}", missing.join(", "))) }
}

/// Runs the tests with the prefix, and prints and returns their output.
fn test() -> Result<String, String> {
    let arguments = ["test", "--workspace", "--tests", "--", "--ignored", PREFIX];
    let line = format!("cargo {}", arguments.join(" "));
    eprintln!("xtask: {line}");
    let start = |error| format!("cannot start `{line}`: {error}");
    let mut cargo =
        Command::new("cargo").args(arguments).current_dir(root()).stdout(Stdio::piped()).spawn().map_err(start)?;
    let mut log = String::new();
    for line in cargo.stdout.take().into_iter().flat_map(|out| BufReader::new(out).lines()).map_while(Result::ok) {
        println!("{line}");
        log.push_str(&line);
        log.push('\n');
    }
    let status = cargo.wait().map_err(start)?;
    if status.success() { Ok(log) } else { Err(format!("`{line}` failed: {status}")) }
}

/// Names of the slow tests in a source file.
fn names(source: &str) -> Result<Vec<String>, String> {
    let mut names = Vec::new();
    let mut lines = source.lines();
    while lines.any(|line| line.trim_start().starts_with(ATTRIBUTE)) {
        let function = lines.find_map(|line| line.trim_start().strip_prefix("fn "));
        let name = function.and_then(|rest| rest.split('(').next()).ok_or("a slow test without a function")?;
        if !name.starts_with(PREFIX) {
            return Err(format!("the slow test `{name}` would not run in CI: its name must begin with `{PREFIX}`"));
        }
        names.push(name.to_owned());
    }
    Ok(names)
}

/// Names of tests without a line in the output that says that they passed. A name may occur in several programs.
fn missing(expected: Vec<String>, log: &str) -> Vec<String> {
    let passed = log.lines().filter_map(|line| line.strip_prefix("test ")?.strip_suffix(" ... ok"));
    let mut passed: Vec<&str> = passed.map(|path| path.rsplit("::").next().unwrap_or(path)).collect();
    let mut is_missing = |name: &String| match passed.iter().position(|other| other == name) {
        Some(place) => {
            passed.swap_remove(place);
            false
        }
        None => true,
    };
    expected.into_iter().filter(|name| is_missing(name)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const SOURCE: &str = "#[test]\n#[ignore = \"slow: CI\"]\nfn slow_a() {}\n#[test]\n#[ignore = \"needs images\"]\nfn b() {}\n\
         mod m {\n    #[test]\n    #[ignore = \"slow: CI\"]\n    fn slow_c(seed in 0..9) {}\n}\n";

    #[test]
    fn slow_tests_are_found_and_other_ignored_ones_are_not() {
        assert_eq!(names(SOURCE), Ok(vec!["slow_a".to_owned(), "slow_c".to_owned()]));
    }

    #[test]
    fn a_slow_test_without_the_prefix_is_an_error() {
        assert!(names(&SOURCE.replace("slow_c", "c")).is_err_and(|error| error.contains("`c`")));
    }

    #[test]
    fn a_slow_test_that_did_not_pass_is_missing() {
        let expected = || ["slow_a", "slow_c", "slow_a"].map(str::to_owned).to_vec();
        let log = "test slow_a ... ok\ntest m::slow_c ... ok\ntest slow_b ... ok\n";
        assert_eq!(missing(expected(), log), ["slow_a"]);
        assert_eq!(missing(expected(), &log.replace("c ... ok", "c ... ignored")), ["slow_c", "slow_a"]);
        assert_eq!(missing(expected(), &format!("{log}test n::slow_a ... ok\n")), <[String; 0]>::default());
    }
}
