//! Check that the crates for users can be published.

use std::fs;
use std::path::{Path, PathBuf};

use crate::process::{root, run};

/// Build directory of the packages.
const TARGET: &str = "target/publish";
/// Workspace of the unpacked packages, within [`TARGET`].
const UNPACKED: &str = "unpacked";
/// End of the name of a package.
const VERSION: &str = concat!("-", env!("CARGO_PKG_VERSION"));

/// Packages every crate of the workspace that is published, and checks each from its package alone.
///
/// # Errors
/// If a crate lacks metadata, needs a file outside its folder, or does not compile from its package.
pub(crate) fn check() -> Result<(), String> {
    let target = root().join(TARGET);
    if target.exists() {
        fs::remove_dir_all(&target).map_err(|error| format!("cannot remove {TARGET}: {error}"))?;
    }
    // CI checks a commit; on a developer's machine the working tree may contain uncommitted changes. Cargo would also build what it
    // packages, which takes three times as long as a check.
    let publish = ["publish", "--workspace", "--dry-run", "--no-verify", "--allow-dirty", "--quiet"];
    run("cargo", &[&publish[..], &["--target-dir", TARGET]].concat(), &[])?;
    let packages = packages(&target.join("package/tmp-crate"))?;
    let manifest = unpack(&packages, &target.join(UNPACKED))?;
    packages.iter().try_for_each(|(name, _)| {
        let check = ["check", "--quiet", "--manifest-path", &manifest, "--target-dir", TARGET, "--package", name];
        // Empty without its feature.
        let features: &[&str] = if name == "bica-ros" { &["--all-features"] } else { &[] };
        run("cargo", &[&check[..], features].concat(), &[])
    })
}

/// Names and paths of the packages in a folder.
fn packages(folder: &Path) -> Result<Vec<(String, String)>, String> {
    let files = fs::read_dir(folder).map_err(|error| format!("cannot read {}: {error}", folder.display()))?;
    let named = |path: &Path| Some(path.file_stem()?.to_str()?.strip_suffix(VERSION)?.to_owned());
    let package = |path: PathBuf| match named(&path) {
        Some(name) => Ok((name, path.display().to_string())),
        None => Err(format!("{} does not have the version of the workspace", path.display())),
    };
    let mut packages = files.flatten().map(|file| package(file.path())).collect::<Result<Vec<_>, _>>()?;
    packages.sort();
    if packages.is_empty() { Err(format!("no package is in {}", folder.display())) } else { Ok(packages) }
}

/// Unpacks packages into a workspace in which each replaces the published one; returns the path of its manifest.
fn unpack(packages: &[(String, String)], folder: &Path) -> Result<String, String> {
    let failed = |error| format!("cannot write {}: {error}", folder.display());
    fs::create_dir_all(folder).map_err(failed)?;
    for (_, path) in packages {
        run("tar", &["-xzf", path, "-C", &folder.to_string_lossy()], &[])?;
    }
    let patches = packages.iter().map(|(name, _)| format!("{name} = {{ path = \"{name}{VERSION}\" }}\n"));
    let workspace = "[workspace]\nresolver = \"3\"\nmembers = [\"*\"]\n\n[patch.crates-io]\n";
    let manifest = folder.join("Cargo.toml");
    fs::write(&manifest, workspace.to_owned() + &patches.collect::<String>()).map_err(failed)?;
    fs::copy(root().join("Cargo.lock"), folder.join("Cargo.lock")).map_err(failed)?;
    Ok(manifest.display().to_string())
}
