//! BICA beside its peers. They are a workspace of their own: what they need is nothing that BICA needs.

use crate::cli::Peers;
use crate::process::run;

const PLACE: [&str; 3] = ["--manifest-path", "benches/peers/Cargo.toml", "--locked"];
const TARGET: [&str; 2] = ["--target-dir", "target/peers"];

/// Builds all, then times, counts, weighs and judges.
///
/// # Errors
/// What could not be built, or that a promise is broken.
pub(crate) fn measure(asked: &Peers) -> Result<(), String> {
    // The first build takes minutes and shows how far it is.
    cargo("build", &["--release", "--workspace"])?;
    let program = ["--quiet", "--release", "--package", "peers-run", "--"];
    let options = [(asked.quick, "--quick"), (asked.slow, "--slow")];
    let options: Vec<&str> = options.into_iter().filter_map(|(is_asked, word)| is_asked.then_some(word)).collect();
    cargo("run", &[&program[..], &options].concat())
}

/// Whether all but copper-rs come to the same results, and the judge is right.
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
