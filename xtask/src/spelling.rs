//! Spelling of all files, checked by typos (`typos.toml`).

use crate::install::{folder, python};
use crate::process::run;

/// Package of `PyPI`, with the version for which `typos.toml` is written.
const PACKAGE: &str = "typos==1.52.0";

/// Checks the spelling.
///
/// # Errors
/// If the tool cannot be installed, or a word is wrong.
pub(crate) fn check() -> Result<(), String> {
    run(&install()?, &[], &[])
}

/// Returns the path of typos; installs it first if it is missing.
///
/// # Errors
/// If the installation fails.
pub(crate) fn install() -> Result<String, String> {
    let venv = folder("typos").to_string_lossy().into_owned();
    // The package has a program and no module.
    python(&venv, "importlib.metadata as installed; installed.version('typos')", &[PACKAGE])?;
    Ok(format!("{venv}/bin/typos"))
}
