//! Everything that CI checks, in its order: what fails most often and fastest comes first.

use crate::cli::{Budget, Firmware};
use crate::process::run;
use crate::{deny, firmware, instructions, miri, mujoco, no_std, peers, publish};

/// # Errors
/// The first check that fails.
pub(crate) fn check() -> Result<(), String> {
    run("cargo", &["fmt", "--all", "--check"], &[])?;
    run("cargo", &["clippy", "--workspace", "--all-targets", "--", "-D", "warnings"], &[])?;
    run("cargo", &["doc", "--workspace", "--no-deps"], &[("RUSTDOCFLAGS", "-D warnings")])?;
    run("cargo", &["test", "--workspace"], &[])?;
    publish::check()?;
    deny::check()?;
    peers::check()?;
    run("cargo", &["run", "--release", "--", "play", "--games", "20", "--at-least", "19"], &[])?;
    miri::check_if_installable()?;
    instructions::check(&Budget::default())?;
    mujoco::check()?;
    no_std::check()?;
    firmware::check(&Firmware::default())
}
