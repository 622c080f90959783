//! Installation of what tasks need beyond Rust.

use std::env;
use std::path::PathBuf;

use crate::process::{root, run};

/// Installs packages with `apt-get`; options of `apt-get install` may be among the words.
///
/// # Errors
/// What could not be installed, and which packages to install by hand.
pub(crate) fn packages(words: &[&str]) -> Result<(), String> {
    let install = || {
        run("apt-get", &["update", "-qq"], &[])?;
        run("apt-get", &[&["install", "-y", "-qq"], words].concat(), &[])
    };
    let names: Vec<&str> = words.iter().copied().filter(|word| !word.starts_with('-')).collect();
    install().map_err(|error| {
        format!(
            "{error}; on a system without apt-get, or as another user than root, first install the Debian packages {} or their equivalents",
            names.join(", ")
        )
    })
}

/// The folder of this name in the build directory.
pub(crate) fn folder(name: &str) -> PathBuf {
    env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from).join(name)
}
