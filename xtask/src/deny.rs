//! Licences, duplicate and banned crates, and sources of all dependencies, checked by cargo-deny (`deny.toml`).

use crate::install::folder;
use crate::process::{run, works};

/// Version for which `deny.toml` is written.
const VERSION: &str = "0.20.2";
/// All workspaces of the repository; each has its own lock file.
const MANIFESTS: [&str; 4] = ["Cargo.toml", "firmware/Cargo.toml", "fuzz/Cargo.toml", "benches/peers/Cargo.toml"];

/// Checks all workspaces of the repository; advisories only if their database can be fetched.
///
/// # Errors
/// If the tool cannot be installed, or a dependency violates a rule.
pub(crate) fn check() -> Result<(), String> {
    let tool = install()?;
    for manifest in MANIFESTS {
        run(&tool, &["--manifest-path", manifest, "--all-features", "check", "licenses", "bans", "sources"], &[])?;
    }
    if works(&tool, &["fetch", "db"]) {
        return run(&tool, &["check", "advisories"], &[]);
    }
    eprintln!("xtask: SKIPPED: the database of advisories cannot be fetched here, so advisories are not checked");
    Ok(())
}

/// Returns the path of cargo-deny; builds it first if it is missing.
fn install() -> Result<String, String> {
    let folder = folder("cargo-deny");
    let path = folder.join("bin/cargo-deny").to_string_lossy().into_owned();
    if !works(&path, &["--version"]) {
        eprintln!("xtask: building cargo-deny {VERSION}, once; this takes some minutes");
        // A debug build is sufficient: checking a lock file takes a second.
        let install = ["install", "--quiet", "--locked", "--debug", "cargo-deny", "--version", VERSION];
        run("cargo", &[&install[..], &["--root", &folder.to_string_lossy()]].concat(), &[])?;
    }
    Ok(path)
}
