//! Absence of undefined behaviour in the framework's unsafe code: its tests run in Miri.

use crate::process::{run, works};

/// Nightly compiler for which Miri is available.
const NIGHTLY: &str = "nightly-2026-05-20";
const PARTS: [&str; 4] = ["--component", "miri", "--component", "rust-src"];
const TEST: [&str; 8] = ["cargo", "miri", "test", "--quiet", "--package", "bica-core", "--test", "main"];
/// The tests of the semantics without those over millions of cycles or thousands of random values, which take hours in Miri and do not
/// use memory differently from the others.
const SELECTION: [&str; 6] = ["--", "semantics::", "--skip", "jitter::", "--skip", "batches::about_half"];
/// Miri is about a thousand times slower than native code, so property tests run one case. proptest reads files of earlier
/// failures, which Miri forbids by default.
const VARIABLES: [(&str, &str); 2] = [("PROPTEST_CASES", "1"), ("MIRIFLAGS", "-Zmiri-disable-isolation")];

/// Installs the compiler and Miri.
///
/// # Errors
/// If the installation fails.
pub(crate) fn install() -> Result<(), String> {
    if works("rustup", &["run", NIGHTLY, "cargo", "miri", "--version"]) {
        return Ok(());
    }
    let toolchain = ["toolchain", "install", NIGHTLY, "--profile", "minimal", "--no-self-update"];
    run("rustup", &[&toolchain[..], &PARTS].concat(), &[])
        .map_err(|error| format!("{error}; Miri is available with rustup only, see https://rustup.rs"))
}

/// Runs the tests of the framework's semantics.
///
/// # Errors
/// If a test fails, or Miri detects undefined behaviour.
pub(crate) fn check() -> Result<(), String> {
    run("rustup", &[&["run", NIGHTLY], &TEST[..], &SELECTION].concat(), &VARIABLES)
}
