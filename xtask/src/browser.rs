//! Tests of JManager's page in Chromium, in their own workspace, so that nothing else needs their dependencies.

use crate::install::packages;
use crate::process::{run, works};

/// The workspace of these tests.
pub(crate) const MANIFEST: [&str; 3] = ["--manifest-path", "tools/jmanager/tests/browser/Cargo.toml", "--locked"];

const PROGRAMS: [&str; 5] = ["build", "--package", "jmanager", "--package", "bica-player-program"];
/// Arguments of Cargo that run the tests.
pub(crate) const TEST: [&str; 9] = [
    "test",
    MANIFEST[0],
    MANIFEST[1],
    MANIFEST[2],
    "--target-dir",
    "target/browser",
    "--",
    "--test-threads=1",
    "--nocapture",
];

/// Builds JManager and tests its page.
///
/// # Errors
/// If an installation, a build or a test fails.
pub(crate) fn test(figures: bool) -> Result<(), String> {
    if !figures {
        prepare()?;
        return run("cargo", &TEST, &[]);
    }
    install()?;
    run("cargo", &[&PROGRAMS[..], &["--release"]].concat(), &[])?;
    // Measurements are tests of the module `figures` and of the designer's speed, which do nothing without the variable.
    let test = [&TEST[..], &["figures", "speed_of"]].concat();
    run("cargo", &test, &[("JMANAGER_FIGURES", "1"), ("JMANAGER_PROFILE", "release")])
}

/// Installs the browser, and builds the programs that [`TEST`] starts.
///
/// # Errors
/// If the installation or the build fails.
pub(crate) fn prepare() -> Result<(), String> {
    install()?;
    run("cargo", &PROGRAMS, &[])
}

/// Installs Chromium and its `WebDriver`.
///
/// # Errors
/// If the installation fails.
pub(crate) fn install() -> Result<(), String> {
    if works("chromedriver", &["--version"]) && works("chromium", &["--version"]) {
        return Ok(());
    }
    packages(&["chromium", "chromium-driver"])
}
