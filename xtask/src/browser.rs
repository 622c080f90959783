//! Tests of JManager's page in Chromium, in their own workspace, so that nothing else needs their dependencies.

use std::process::ExitStatus;

use crate::process::{echo, run, works};

/// The workspace of these tests.
pub(crate) const MANIFEST: [&str; 3] = ["--manifest-path", "tools/jmanager/tests/browser/Cargo.toml", "--locked"];

/// Largest number of stories that have a second try in CI.
const SECOND_TRIES: usize = 2;

/// Builds JManager and tests its page, or measures it.
///
/// # Errors
/// If a build or a test fails.
pub(crate) fn test(figures: bool) -> Result<(), String> {
    if !ready(figures)? {
        return Ok(());
    }
    // Measurements are tests of the module `figures` and of the designer's speed, which do nothing without the variable.
    let (only, variables): (&[&str], &[_]) = if figures {
        (&["figures", "speed_of"], &[("JMANAGER_FIGURES", "1"), ("JMANAGER_PROFILE", "release")])
    } else {
        (&[], &[])
    };
    let (status, _, line) = stories(only, variables)?;
    if status.success() { Ok(()) } else { Err(format!("`{line}` failed: {status}")) }
}

/// The same for CI: one or two stories that fail have a second try, and are named if they pass it. A story takes a minute of two programs and
/// a browser on a machine that others use too; a fault of the page fails it again.
///
/// # Errors
/// If a build fails, if more stories fail, or one fails twice.
pub(crate) fn check() -> Result<(), String> {
    if !ready(false)? {
        return Ok(());
    }
    let (status, log, line) = stories(&[], &[])?;
    if status.success() {
        return Ok(());
    }
    let names = failed(&log);
    if names.is_empty() || names.len() > SECOND_TRIES {
        return Err(format!("`{line}` failed: {status}"));
    }
    let (status, ..) = stories(&[&["--exact"], &names[..]].concat(), &[])?;
    if !status.success() {
        return Err(format!("`{line}` failed: {status}, also in a second try"));
    }
    println!("xtask: UNSTABLE: passed only in a second try: {}", names.join(", "));
    Ok(())
}

/// Installs the browser and builds the programs. Returns whether there is a browser.
fn ready(release: bool) -> Result<bool, String> {
    if !installed() {
        println!(
            "xtask: NOT TESTED: the page of JManager, because Chromium and its WebDriver cannot be installed here"
        );
        return Ok(false);
    }
    let programs = ["build", "--package", "jmanager", "--package", "bica-player-program"];
    let profile: &[&str] = if release { &["--release"] } else { &[] };
    run("cargo", &[&programs, profile].concat(), &[]).map(|()| true)
}

/// Runs stories one after the other, all or those with a filter of the test harness.
fn stories(filter: &[&str], variables: &[(&str, &str)]) -> Result<(ExitStatus, String, String), String> {
    let threads = ["--target-dir", "target/browser", "--test", "stories", "--", "--test-threads=1", "--nocapture"];
    echo("cargo", &[&["test"], &MANIFEST[..], &threads, filter].concat(), variables)
}

/// Names of the tests that failed: the harness lists them, indented, after its last line `failures:`.
fn failed(log: &str) -> Vec<&str> {
    let Some((_, list)) = log.rsplit_once("\nfailures:\n") else { return Vec::new() };
    list.lines().map_while(|line| line.strip_prefix("    ")).collect()
}

fn installed() -> bool {
    let found = || works("chromedriver", &["--version"]) && works("chromium", &["--version"]);
    if found() {
        return true;
    }
    let _ = run("apt-get", &["install", "-y", "chromium", "chromium-driver"], &[]);
    found()
}

#[cfg(test)]
mod tests {
    use super::failed;

    #[test]
    fn failed_tests_are_those_of_the_last_list() {
        let log =
            "test a ... FAILED\n\nfailures:\n\nfailures:\n    panels::a\n    b\n\ntest result: FAILED. 1 passed\n";
        assert_eq!(failed(log), ["panels::a", "b"]);
        assert_eq!(failed("test a ... ok\n"), <[&str; 0]>::default());
    }
}
