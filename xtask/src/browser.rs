//! Tests of JManager's page in Chromium, in their own workspace, so that nothing else needs their dependencies.

use crate::process::{run, works};

/// The workspace of these tests.
pub(crate) const MANIFEST: [&str; 3] = ["--manifest-path", "tools/jmanager/tests/browser/Cargo.toml", "--locked"];

/// Builds JManager and tests its page.
///
/// # Errors
/// If a build or a test fails.
pub(crate) fn test(figures: bool) -> Result<(), String> {
    if !installed() {
        println!(
            "xtask: NOT TESTED: the page of JManager, because Chromium and its WebDriver cannot be installed here"
        );
        return Ok(());
    }
    let programs = ["build", "--package", "jmanager", "--package", "bica-player-program"];
    let (profile, variables): (&[&str], &[(&str, &str)]) = if figures {
        (&["--release"], &[("JMANAGER_FIGURES", "1"), ("JMANAGER_PROFILE", "release")])
    } else {
        (&[], &[])
    };
    run("cargo", &[&programs, profile].concat(), &[])?;
    let threads = ["--target-dir", "target/browser", "--", "--test-threads=1", "--nocapture"];
    // Measurements are tests of the module `figures` and of the designer's speed, which do nothing without the variable.
    let only: &[&str] = if figures { &["figures", "speed_of"] } else { &[] };
    run("cargo", &[&["test"], &MANIFEST[..], &threads, only].concat(), variables)
}

fn installed() -> bool {
    let found = || works("chromedriver", &["--version"]) && works("chromium", &["--version"]);
    if found() {
        return true;
    }
    let _ = run("apt-get", &["install", "-y", "chromium", "chromium-driver"], &[]);
    found()
}
