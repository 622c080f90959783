//! The proof that the crates that users need can be published.

use crate::process::run;

/// Packages every crate of the workspace that is to be published, and builds each from its package alone.
///
/// # Errors
/// A crate that lacks metadata, needs a file outside its folder, or does not build from its package.
pub(crate) fn check() -> Result<(), String> {
    // CI checks a commit; at a desk the working tree may hold changes that are not committed yet.
    run("cargo", &["publish", "--workspace", "--dry-run", "--allow-dirty", "--quiet"], &[])
}
