//! Speed of BICA and its peers, in a workspace of its own: BICA needs none of the peers' dependencies.

use crate::cli::Peers;
use crate::process::run;

const PLACE: [&str; 3] = ["--manifest-path", "benches/peers/Cargo.toml", "--locked"];
const TARGET: [&str; 2] = ["--target-dir", "target/peers"];

/// Builds all, measures time, instructions, allocations and program size, and checks the promises.
///
/// # Errors
/// What could not be built, or a promise that does not hold.
pub(crate) fn measure(selected: &Peers) -> Result<(), String> {
    // The first build takes minutes, so its progress is shown.
    cargo("build", &["--release", "--workspace"])?;
    let program = ["--quiet", "--release", "--package", "peers-run", "--"];
    let options = [(selected.quick, "--quick"), (selected.slow, "--slow")];
    let options: Vec<&str> = options.into_iter().filter_map(|(selected, word)| selected.then_some(word)).collect();
    cargo("run", &[&program[..], &options].concat())
}

/// Checks that all designs but copper-rs compute the same results, and that the judgement of times is right.
///
/// # Errors
/// What failed.
pub(crate) fn check() -> Result<(), String> {
    run("cargo", &["fmt", "--all", "--check", PLACE[0], PLACE[1]], &[])?;
    cargo(
        "clippy",
        &["--quiet", "--package", "peers", "--package", "peers-size", "--all-targets", "--", "-D", "warnings"],
    )?;
    cargo("test", &["--quiet", "--package", "peers"])
}

fn cargo(what: &str, more: &[&str]) -> Result<(), String> {
    run("cargo", &[&[what], &PLACE[..], &TARGET, more].concat(), &[])
}
