//! Fuzzing of the code that decodes external bytes, with cargo-fuzz in its own workspace.

use std::path::Path;

use crate::install::cargo_tool;
use crate::process::run;

const VERSION: &str = "0.13.2";
const TARGETS: [&str; 6] = ["vicode", "vision", "wire", "recording", "link", "session"];
/// Limits of one input: 10 s and 2 GB of memory; a summary at the end instead of a line for each new input.
const OPTIONS: [&str; 4] = ["-timeout=10", "-rss_limit_mb=2048", "-verbosity=0", "-print_final_stats=1"];

/// Installs cargo-fuzz into `target/`, and runs each target for `seconds`, at least 1 (0 would mean no limit).
///
/// # Errors
/// If an installation or a build fails, or a target finds a failing input.
pub(crate) fn check(seconds: u32) -> Result<(), String> {
    let tool = cargo_tool("cargo-fuzz", VERSION)?;
    let limit = format!("-max_total_time={seconds}");
    for target in TARGETS {
        // Sanitizers detect memory errors, which safe Rust excludes; without them any toolchain works.
        // With `cfg(fuzzing)` proc-macro2 gives no places, which VICODE needs.
        let build = ["--sanitizer", "none", "--no-cfg-fuzzing", "--fuzz-dir", "fuzz"];
        let words = [&["fuzz", "run"][..], &build, &[target, "--", &limit]].concat();
        // Coverage instrumentation is an unstable option of rustc.
        run(&tool, &[&words[..], &OPTIONS].concat(), &[("RUSTC_BOOTSTRAP", "1")])
            .map_err(|error| format!("{error}\n{}", advice(target, Path::new(&tool))))?;
        eprintln!("xtask: {target}: {seconds} s without a failure");
    }
    Ok(())
}

/// Instructions for the reproduction of a failure.
fn advice(target: &str, tool: &Path) -> String {
    let folder = tool.parent().unwrap_or(tool).display();
    format!(
        "The failing input of `{target}` is in fuzz/artifacts/{target}. The commands that cargo-fuzz prints work with\n  \
         --no-cfg-fuzzing after\n  export RUSTC_BOOTSTRAP=1 PATH={folder}:$PATH"
    )
}
