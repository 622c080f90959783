//! The proof that the framework's unsafe code means something: Miri runs its tests, and stops at undefined behaviour.

use crate::process::{run, works};

/// A nightly compiler that has Miri; not each has.
const NIGHTLY: &str = "nightly-2026-05-20";
const PARTS: [&str; 4] = ["--component", "miri", "--component", "rust-src"];
const TEST: [&str; 8] = ["cargo", "miri", "test", "--quiet", "--package", "bica-core", "--test", "semantics"];
/// Miri is a thousand times slower than a processor: one case has to do for a test that tries many. proptest looks for
/// files of earlier failures, which Miri forbids unless told.
const VARIABLES: [(&str, &str); 2] = [("PROPTEST_CASES", "1"), ("MIRIFLAGS", "-Zmiri-disable-isolation")];

/// Gets Miri, and runs the tests of what the framework means.
///
/// # Errors
/// What could not be installed, a test that fails, or undefined behaviour.
pub(crate) fn check() -> Result<(), String> {
    install()?;
    test()
}

/// The same where Miri can be installed; elsewhere it is only said that it cannot.
///
/// # Errors
/// A test that fails, or undefined behaviour.
pub(crate) fn check_where_possible() -> Result<(), String> {
    if let Err(error) = install() {
        eprintln!("xtask: Miri cannot be installed here, so nothing is checked in it: {error}");
        return Ok(());
    }
    test()
}

fn install() -> Result<(), String> {
    if works("rustup", &["run", NIGHTLY, "cargo", "miri", "--version"]) {
        return Ok(());
    }
    let toolchain = ["toolchain", "install", NIGHTLY, "--profile", "minimal", "--no-self-update"];
    run("rustup", &[&toolchain[..], &PARTS].concat(), &[])
        .map_err(|error| format!("{error}; Miri comes with rustup's compilers only, see https://rustup.rs"))
}

fn test() -> Result<(), String> {
    run("rustup", &[&["run", NIGHTLY], &TEST[..]].concat(), &VARIABLES)
}
