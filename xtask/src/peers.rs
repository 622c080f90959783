//! BICA beside its peers. They are a workspace of their own: what they need is nothing that BICA needs.

use crate::process::run;

const PLACE: [&str; 3] = ["--manifest-path", "benches/peers/Cargo.toml", "--locked"];
const TARGET: [&str; 3] = ["--quiet", "--target-dir", "target/peers"];

/// What [`measure`] takes.
pub(crate) const OPTIONS: [&str; 2] = ["--quick", "--slow"];

/// Builds all, then times, counts, weighs and judges.
///
/// # Errors
/// What could not be built, or that a promise is broken.
pub(crate) fn measure(option: Option<&str>) -> Result<(), String> {
    cargo("build", &["--release", "--workspace"])?;
    let program = ["--release", "--package", "peers-run", "--"];
    cargo("run", &[&program[..], option.as_slice()].concat())
}

/// Whether all but copper-rs come to the same results, and the judge is right.
///
/// # Errors
/// What failed.
pub(crate) fn check() -> Result<(), String> {
    run("cargo", &["fmt", "--all", "--check", PLACE[0], PLACE[1]], &[])?;
    cargo("clippy", &["--package", "peers", "--package", "peers-size", "--all-targets", "--", "-D", "warnings"])?;
    cargo("test", &["--package", "peers"])
}

fn cargo(what: &str, more: &[&str]) -> Result<(), String> {
    run("cargo", &[&[what], &PLACE[..], &TARGET, more].concat(), &[])
}
