//! What chores need beyond Rust, and where it goes.

use std::env;
use std::path::PathBuf;

use crate::process::{root, run};

/// Installs packages of Debian and its like; options of `apt-get install` may be among the words.
///
/// # Errors
/// What could not be installed, and that one may do it oneself.
pub(crate) fn packages(words: &[&str]) -> Result<(), String> {
    let install = || {
        run("apt-get", &["update", "-qq"], &[])?;
        run("apt-get", &[&["install", "-y", "-qq"], words].concat(), &[])
    };
    let names: Vec<&str> = words.iter().copied().filter(|word| !word.starts_with('-')).collect();
    install().map_err(|error| {
        format!(
            "{error}; on a system of another kind, or as another user than root, install what Debian calls {} first",
            names.join(", ")
        )
    })
}

/// A folder beside what Cargo builds.
pub(crate) fn folder(name: &str) -> PathBuf {
    env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from).join(name)
}
