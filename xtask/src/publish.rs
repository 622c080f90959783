//! Check that the crates for users can be published.

use crate::process::run;

/// Packages every crate of the workspace that is published, and builds each from its package alone.
///
/// # Errors
/// If a crate lacks metadata, needs a file outside its folder, or does not build from its package.
pub(crate) fn check() -> Result<(), String> {
    // CI checks a commit; on a developer's machine the working tree may contain uncommitted changes.
    run("cargo", &["publish", "--workspace", "--dry-run", "--allow-dirty", "--quiet"], &[])
}
