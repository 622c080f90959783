//! Check that the crates for users can be published.

use std::path::{Path, PathBuf};
use std::{env, fs};

use crate::process::{root, run};

/// Build directory of the packages. It is made anew: for Cargo a package of the same version is the same package, also if
/// its source has changed.
const TARGET: &str = "target/publish";

/// Packages every crate of the workspace that is published, and builds each from its package alone.
///
/// # Errors
/// If a crate lacks metadata, needs a file outside its folder, or does not build from its package.
pub(crate) fn check() -> Result<(), String> {
    remove(&root().join(TARGET))?;
    if let Some(home) = cargo_home() {
        remove_unpacked(&home.join("registry/src"))?;
    }
    // CI checks a commit; on a developer's machine the working tree may contain uncommitted changes.
    let publish = ["publish", "--workspace", "--dry-run", "--allow-dirty", "--quiet", "--target-dir", TARGET];
    // What is built here never runs.
    run("cargo", &publish, &[("CARGO_PROFILE_DEV_DEBUG", "false")])
}

/// Returns the folder in which Cargo keeps packages.
fn cargo_home() -> Option<PathBuf> {
    env::var_os("CARGO_HOME").map(PathBuf::from).or_else(|| Some(env::home_dir()?.join(".cargo")))
}

/// Removes the sources that former checks unpacked, because Cargo would build them instead of the current ones. It keeps them in
/// one folder for each temporary registry; such a registry has no host, so the folder's name begins with a hyphen.
fn remove_unpacked(sources: &Path) -> Result<(), String> {
    let Ok(registries) = fs::read_dir(sources) else { return Ok(()) };
    for registry in registries.flatten().filter(|entry| entry.file_name().to_string_lossy().starts_with('-')) {
        let Ok(packages) = fs::read_dir(registry.path()) else { continue };
        for package in packages.flatten().filter(|entry| entry.file_name().to_string_lossy().starts_with("bica-")) {
            remove(&package.path())?;
        }
    }
    Ok(())
}

fn remove(folder: &Path) -> Result<(), String> {
    if !folder.exists() {
        return Ok(());
    }
    fs::remove_dir_all(folder).map_err(|error| format!("cannot remove {}: {error}", folder.display()))
}
