//! Licences, duplicate and banned crates, and sources of all dependencies, checked by cargo-deny (`deny.toml`).

use crate::install::cargo_tool;
use crate::process::run;

/// Version for which `deny.toml` is written.
const VERSION: &str = "0.20.2";
/// All workspaces of the repository; each has its own lock file.
const MANIFESTS: [&str; 4] = ["Cargo.toml", "firmware/Cargo.toml", "fuzz/Cargo.toml", "benches/peers/Cargo.toml"];

/// Checks licences, duplicates and sources in all workspaces of the repository.
///
/// # Errors
/// If the tool cannot be installed, or a dependency violates a rule.
pub(crate) fn check() -> Result<(), String> {
    let tool = install()?;
    MANIFESTS.into_iter().try_for_each(|manifest| {
        run(&tool, &["--manifest-path", manifest, "--all-features", "check", "licenses", "bans", "sources"], &[])
    })
}

/// Fetches the database of advisories.
///
/// # Errors
/// If the tool cannot be installed, or the database cannot be fetched.
pub(crate) fn fetch_advisories() -> Result<(), String> {
    run(&install()?, &["fetch", "db"], &[])
}

/// Checks that no dependency has an advisory in the fetched database.
///
/// # Errors
/// If the tool cannot be installed, or a dependency has an advisory.
pub(crate) fn check_advisories() -> Result<(), String> {
    run(&install()?, &["check", "--disable-fetch", "advisories"], &[])
}

/// Returns the path of cargo-deny; installs it first if it is missing.
///
/// # Errors
/// If the installation fails.
pub(crate) fn install() -> Result<String, String> {
    cargo_tool("cargo-deny", VERSION)
}
