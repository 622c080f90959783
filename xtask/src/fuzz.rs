//! Any bytes for what reads bytes from outside: cargo-fuzz in a workspace of its own.

use std::path::{Path, PathBuf};

use crate::install::folder;
use crate::process::{run, works};

const TARGETS: [&str; 2] = ["eyes", "wire"];
/// No input may take longer, s; and what is told is a summary, instead of each input that goes where none went before.
const OPTIONS: [&str; 3] = ["-timeout=10", "-verbosity=0", "-print_final_stats=1"];

/// Gets cargo-fuzz into target/, and runs each target for so many seconds, at least 1: none would be for ever.
///
/// # Errors
/// What could not be installed or built, or a target that found an input that breaks what it holds.
pub(crate) fn check(seconds: u32) -> Result<(), String> {
    let tool = tool()?;
    let limit = format!("-max_total_time={seconds}");
    for target in TARGETS {
        // The sanitizers look for errors of memory, which safe Rust has not; without them it runs on any toolchain.
        let words = ["fuzz", "run", "--sanitizer", "none", "--fuzz-dir", "fuzz", target, "--", &limit];
        // Coverage for the fuzzer is a flag of unstable rustc.
        run(&tool.to_string_lossy(), &[&words[..], &OPTIONS].concat(), &[("RUSTC_BOOTSTRAP", "1")])
            .map_err(|error| format!("{error}\n{}", mend(target, &tool)))?;
        eprintln!("xtask: {target}: {seconds} s, and nothing broke it");
    }
    Ok(())
}

/// What can be done about a failure.
fn mend(target: &str, tool: &Path) -> String {
    let folder = tool.parent().unwrap_or(tool).display();
    format!(
        "An input that broke `{target}` is in fuzz/artifacts/{target}. The commands that cargo-fuzz tells work after\n  \
         export RUSTC_BOOTSTRAP=1 PATH={folder}:$PATH"
    )
}

/// The program; installs it first if need be.
fn tool() -> Result<PathBuf, String> {
    let folder = folder("cargo-fuzz");
    let path = folder.join("bin/cargo-fuzz");
    if !works(&path.to_string_lossy(), &["fuzz", "--version"]) {
        let folder = folder.to_string_lossy();
        eprintln!("xtask: building cargo-fuzz, once; it takes a minute or so");
        run("cargo", &["install", "cargo-fuzz", "--locked", "--quiet", "--root", &folder], &[])?;
    }
    Ok(path)
}
