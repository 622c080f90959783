//! Any bytes for what reads bytes from outside: cargo-fuzz in a workspace of its own.

use std::env;
use std::path::PathBuf;

use crate::process::{root, run, works};

const TARGETS: [&str; 2] = ["eyes", "wire"];

/// Gets cargo-fuzz into target/, and runs each target for so many seconds, at least 1: none would be for ever.
///
/// # Errors
/// What could not be installed or built, or a target that found an input that breaks what it holds.
pub(crate) fn check(seconds: u32) -> Result<(), String> {
    let tool = tool()?;
    let limit = format!("-max_total_time={seconds}");
    for target in TARGETS {
        // The sanitizers look for errors of memory, which safe Rust has not; without them it runs on any toolchain.
        let words = ["fuzz", "run", "--sanitizer", "none", "--fuzz-dir", "fuzz", target, "--", &limit, "-timeout=10"];
        // Coverage for the fuzzer is a flag of unstable rustc.
        run(&tool, &words, &[("RUSTC_BOOTSTRAP", "1")])?;
    }
    Ok(())
}

/// The program; installs it first if need be.
fn tool() -> Result<String, String> {
    let folder =
        env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from).join("cargo-fuzz");
    let path = folder.join("bin/cargo-fuzz").to_string_lossy().into_owned();
    if !works(&path, &["fuzz", "--version"]) {
        let folder = folder.to_string_lossy();
        run("cargo", &["install", "cargo-fuzz", "--locked", "--quiet", "--root", &folder], &[])?;
    }
    Ok(path)
}
