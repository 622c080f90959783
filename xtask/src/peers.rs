//! Comparison of BICA with other designs, in its own workspace, so that BICA does not need their dependencies.

use crate::cli::Peers;
use crate::process::run;

const MANIFEST: [&str; 3] = ["--manifest-path", "benches/peers/Cargo.toml", "--locked"];
const TARGET: [&str; 2] = ["--target-dir", "target/peers"];

/// Builds everything, measures times, allocations and program sizes, and checks the claims.
///
/// # Errors
/// If a build fails, or a claim does not hold.
pub(crate) fn measure(selected: &Peers) -> Result<(), String> {
    // The first build takes minutes, so its progress is shown.
    cargo("build", &["--release", "--workspace"])?;
    let program = ["--quiet", "--release", "--package", "peers-run", "--"];
    let options = [(selected.quick, "--quick"), (selected.slow, "--slow")];
    let options: Vec<&str> = options.into_iter().filter_map(|(selected, word)| selected.then_some(word)).collect();
    cargo("run", &[&program[..], &options].concat())
}

/// Checks that all designs but copper-rs compute the same results, and that the claims are judged correctly.
///
/// # Errors
/// If a check fails.
pub(crate) fn check() -> Result<(), String> {
    run("cargo", &["fmt", "--all", "--check", MANIFEST[0], MANIFEST[1]], &[])?;
    cargo("clippy", &["--quiet", "--package", "peers", "--all-targets", "--", "-D", "warnings"])?;
    cargo("test", &["--quiet", "--package", "peers", "--lib", "--test", "*"])
}

fn cargo(what: &str, more: &[&str]) -> Result<(), String> {
    run("cargo", &[&[what], &MANIFEST[..], &TARGET, more].concat(), &[])
}
