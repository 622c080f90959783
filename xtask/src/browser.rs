//! Tests of JManager's page in Chromium and Firefox, in their own workspace, so that nothing else needs their dependencies.

use crate::build;
use crate::install::{folder, packages};
use crate::process::{run, works};

/// The workspace of these tests.
pub(crate) const MANIFEST: [&str; 3] = ["--manifest-path", "tools/jmanager/tests/browser/Cargo.toml", "--locked"];

/// Arguments of Cargo that run the tests.
const TEST: [&str; 9] = [
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

/// Firefox's `WebDriver`, with its version.
const GECKODRIVER: &str = "geckodriver@0.37.1";

/// Checks of accessibility, with its version.
const AXE: &str = "axe-core@4.10.3";

/// Builds JManager and tests its page, but for the firmware: its image may be built at the same time.
///
/// # Errors
/// If an installation, a build or a test fails.
pub(crate) fn test() -> Result<(), String> {
    prepare()?;
    run("cargo", &[&TEST[..], &["--skip", "firmware::"]].concat(), &[])?;
    // What a press and a drag are differs between browsers; the first hour uses most of the page.
    run("cargo", &[&TEST[..], &["pressing", "hour"]].concat(), &[("JMANAGER_BROWSER", "firefox")])
}

/// Measures the speed of the page, and prints the figures.
///
/// # Errors
/// If an installation, a build or a measurement fails.
pub(crate) fn measure() -> Result<(), String> {
    install()?;
    run("cargo", &["build", "--release", "--package", "jmanager", "--package", "bica-player-program"], &[])?;
    // Measurements are tests of the module `figures` and of the designer's speed, which do nothing without the variable.
    let test = [&TEST[..], &["figures", "speed_of"]].concat();
    run("cargo", &test, &[("JMANAGER_FIGURES", "1"), ("JMANAGER_PROFILE", "release")])
}

/// Watches the firmware, whose image exists, in the page.
///
/// # Errors
/// If an installation, a build or the test fails.
pub(crate) fn watch_firmware() -> Result<(), String> {
    prepare()?;
    run("cargo", &[&TEST[..], &["firmware::"]].concat(), &[])
}

/// Installs the browser, and builds the programs that [`TEST`] starts.
fn prepare() -> Result<(), String> {
    install()?;
    build::programs()
}

/// Installs Chromium, Firefox, their `WebDriver`s, and the checks of accessibility.
///
/// # Errors
/// If an installation fails.
pub(crate) fn install() -> Result<(), String> {
    if !works("chromedriver", &["--version"]) || !works("chromium", &["--version"]) {
        packages(&["chromium", "chromium-driver"])?;
    }
    if !works("firefox-esr", &["--version"]) {
        packages(&["firefox-esr"])?;
    }
    if !folder("axe").join("node_modules/axe-core").exists() {
        if !works("npm", &["--version"]) {
            packages(&["npm"])?;
        }
        let prefix = folder("axe").display().to_string();
        run("npm", &["install", "--silent", "--no-save", "--prefix", &prefix, AXE], &[])?;
    }
    // Debian has no package of it.
    let root = folder("geckodriver").display().to_string();
    if works("geckodriver", &["--version"]) || works(&format!("{root}/bin/geckodriver"), &["--version"]) {
        return Ok(());
    }
    let install = ["install", GECKODRIVER, "--locked", "--debug", "--quiet", "--root", &root];
    run("cargo", &install, &[("CARGO_PROFILE_DEV_DEBUG", "0")])
}
