//! Tests that take too long for `cargo test`: slow tests, which CI runs too, and long tests, which it does not.
//!
//! Such a test has the attribute `#[ignore = "slow: …"]` or `#[ignore = "long: …"]`, and its name begins with `slow_` or `long_`.
//! A task runs these tests by their prefix, and compares the names in the sources with those that passed.

use std::collections::BTreeSet;
use std::fs;
use std::io::{BufRead, BufReader};
use std::num::NonZero;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::available_parallelism;

use crate::build;
use crate::process::{output, root};

/// Kind of tests.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Slow,
    Long,
}

impl Kind {
    /// Beginning of the attribute.
    const fn attribute(self) -> &'static str {
        match self {
            Self::Slow => "#[ignore = \"slow: ",
            Self::Long => "#[ignore = \"long: ",
        }
    }

    /// Beginning of the name.
    const fn prefix(self) -> &'static str {
        match self {
            Self::Slow => "slow_",
            Self::Long => "long_",
        }
    }
}

/// Runs all slow tests of the workspace, with environment variables.
///
/// # Errors
/// If there is none, if one has a name without the prefix, if one fails, or if one did not run.
pub(crate) fn run(variables: &[(&str, &str)]) -> Result<(), String> {
    let (_, expected) = find(Kind::Slow, None)?;
    compare(expected, &test(Kind::Slow, &build::workspace(), variables)?)
}

/// Runs the long tests of one package or of the workspace, in a release build. `features` are those of packages, as
/// `bica-player-program/mujoco`.
///
/// # Errors
/// As [`run`], or if the package has no long test.
pub(crate) fn run_long(only: Option<&str>, features: &[&str]) -> Result<(), String> {
    let (packages, expected) = find(Kind::Long, only)?;
    if packages.is_empty() {
        let packages = find(Kind::Long, None)?.0.into_iter().collect::<Vec<_>>().join(", ");
        return Err(format!("no such package has long tests; these have some: {packages}"));
    }
    let features = features.iter().filter(|feature| packages.iter().any(|package| feature.starts_with(package)));
    let packages = packages.iter().flat_map(|package| ["--package".to_owned(), package.clone()]);
    let features = features.flat_map(|feature| ["--features".to_owned(), (*feature).to_owned()]);
    let options: Vec<_> = ["--release".to_owned()].into_iter().chain(packages).chain(features).collect();
    compare(expected, &test(Kind::Long, &options, &[])?)
}

/// Packages with tests of a kind, or `only` one of them, and the names of these tests.
fn find(kind: Kind, only: Option<&str>) -> Result<(BTreeSet<String>, Vec<String>), String> {
    let search = ["grep", "--files-with-matches", "--fixed-strings", kind.attribute(), "--", "*.rs"];
    let (mut packages, mut expected) = (BTreeSet::new(), Vec::new());
    for file in output("git", &search, &[])?.lines() {
        let text = fs::read_to_string(root().join(file)).map_err(|error| format!("cannot read {file}: {error}"))?;
        let names = names(kind, &text).map_err(|error| format!("{file}: {error}"))?;
        let package = package(&root().join(file)).ok_or_else(|| format!("{file} is in no package"))?;
        if !names.is_empty() && only.is_none_or(|only| only == package) {
            packages.insert(package);
            expected.extend(names);
        }
    }
    Ok((packages, expected))
}

/// Name of the package of a file.
fn package(file: &Path) -> Option<String> {
    let manifest = file.ancestors().find_map(|folder| fs::read_to_string(folder.join("Cargo.toml")).ok())?;
    let name = manifest.lines().find_map(|line| line.strip_prefix("name = "))?;
    Some(name.trim_matches('"').to_owned())
}

fn compare(expected: Vec<String>, log: &str) -> Result<(), String> {
    let missing = missing(expected, log);
    if missing.is_empty() { Ok(()) } else { Err(format!("tests that did not run: {}", missing.join(", "))) }
}

/// Runs the tests with the prefix, and prints and returns their output.
fn test(kind: Kind, options: &[String], variables: &[(&str, &str)]) -> Result<String, String> {
    let options = options.iter().map(String::as_str);
    let arguments: Vec<_> = ["test"]
        .into_iter()
        .chain(options)
        .chain(["--tests", "--", "--ignored", "--show-output", kind.prefix()])
        .collect();
    let line = format!("cargo {}", arguments.join(" "));
    eprintln!("xtask: {line}");
    let start = |error| format!("cannot start `{line}`: {error}");
    let mut command = Command::new("cargo");
    command.args(&arguments).current_dir(root()).envs(variables.iter().copied()).envs([build::libraries()]);
    command.stdout(Stdio::piped());
    // Other tests mostly wait, so `.cargo/config.toml` sets more threads than there are processors; these compute.
    command.env("RUST_TEST_THREADS", available_parallelism().map_or(1, NonZero::get).to_string());
    let mut cargo = command.spawn().map_err(start)?;
    let mut log = String::new();
    for line in cargo.stdout.take().into_iter().flat_map(|out| BufReader::new(out).lines()).map_while(Result::ok) {
        println!("{line}");
        log.push_str(&line);
        log.push('\n');
    }
    let status = cargo.wait().map_err(start)?;
    if status.success() { Ok(log) } else { Err(format!("`{line}` failed: {status}")) }
}

/// Names of the tests of a kind in a source file.
fn names(kind: Kind, source: &str) -> Result<Vec<String>, String> {
    let mut names = Vec::new();
    let mut lines = source.lines();
    while lines.any(|line| line.trim_start().starts_with(kind.attribute())) {
        let function = lines.find_map(|line| line.trim_start().strip_prefix("fn "));
        let name = function.and_then(|rest| rest.split('(').next()).ok_or("an ignored test without a function")?;
        let prefix = kind.prefix();
        if !name.starts_with(prefix) {
            return Err(format!("the test `{name}` would never run: its name must begin with `{prefix}`"));
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
         mod m {\n    #[test]\n    #[ignore = \"slow: CI\"]\n    fn slow_c(seed in 0..9) {}\n}\n\
         #[ignore = \"long: task\"]\nfn long_d() {}\n";

    #[test]
    fn only_ignored_tests_of_the_kind_are_found() {
        assert_eq!(names(Kind::Slow, SOURCE), Ok(vec!["slow_a".to_owned(), "slow_c".to_owned()]));
        assert_eq!(names(Kind::Long, SOURCE), Ok(vec!["long_d".to_owned()]));
    }

    #[test]
    fn a_test_without_the_prefix_is_an_error() {
        assert!(names(Kind::Slow, &SOURCE.replace("slow_c", "c")).is_err_and(|error| error.contains("`c`")));
    }

    #[test]
    fn package_of_a_file_has_the_nearest_manifest() {
        assert_eq!(package(&root().join("xtask/src/slow_tests.rs")).as_deref(), Some("xtask"));
        assert_eq!(package(&root().join("tools/player/tests/replay/games.rs")).as_deref(), Some("bica-player-program"));
    }

    #[test]
    fn a_test_that_did_not_pass_is_missing() {
        let expected = || ["slow_a", "slow_c", "slow_a"].map(str::to_owned).to_vec();
        let log = "test slow_a ... ok\ntest m::slow_c ... ok\ntest slow_b ... ok\n";
        assert_eq!(missing(expected(), log), ["slow_a"]);
        assert_eq!(missing(expected(), &log.replace("c ... ok", "c ... ignored")), ["slow_c", "slow_a"]);
        assert_eq!(missing(expected(), &format!("{log}test n::slow_a ... ok\n")), <[String; 0]>::default());
    }
}
