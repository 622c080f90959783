//! Comparison of BICA with other designs, in its own workspace, so that BICA does not need their dependencies.

use crate::cli::Peers;
use crate::process::run;

const MANIFEST: [&str; 2] = ["--manifest-path", "benches/peers/Cargo.toml"];

/// Builds everything, measures times, allocations and program sizes, and checks the claims.
///
/// # Errors
/// If a build fails, or a claim does not hold.
pub(crate) fn measure(selected: &Peers) -> Result<(), String> {
    let options = [(selected.quick, "--quick"), (selected.slow, "--slow")];
    let options = options.into_iter().filter_map(|(selected, word)| selected.then_some(word));
    run("python3", &["benches/scripts/peers.py"].into_iter().chain(options).collect::<Vec<_>>(), &[])
}

/// Checks that all designs but copper-rs compute the same results, and that the claims are judged correctly.
///
/// # Errors
/// If a check fails.
pub(crate) fn check() -> Result<(), String> {
    run("python3", &["benches/scripts/test_peers.py"], &[])?;
    run("cargo", &["fmt", "--check", MANIFEST[0], MANIFEST[1]], &[])?;
    cargo("clippy", &["--quiet", "--all-targets", "--", "-D", "warnings"])?;
    cargo("test", &["--quiet", "--lib"])
}

fn cargo(what: &str, more: &[&str]) -> Result<(), String> {
    run("cargo", &[&[what], &MANIFEST[..], &["--locked", "--target-dir", "target/peers"], more].concat(), &[])
}
