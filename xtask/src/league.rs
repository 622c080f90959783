//! The server of the simulation league, and its checks.

use crate::build;
use crate::install::{folder, python};
use crate::process::run;

/// Package of the server on `PyPI`, which brings `MuJoCo`.
const SERVER: &str = "rcsssmj==0.2.1";
/// What the server's environment must be able to import; it fails with another version.
const MODULE: &str = "rcsssmj, importlib.metadata; assert importlib.metadata.version('rcsssmj') == '0.2.1'";

/// Installs the server into an environment of its own, with pip.
///
/// # Errors
/// If the installation fails.
pub(crate) fn install() -> Result<(), String> {
    let venv = folder("league").to_string_lossy().into_owned();
    eprintln!("xtask: {SERVER} belongs into {venv}; if it is missing, pip installs it there");
    python(&venv, MODULE, &[SERVER]).map(drop)
}

/// Tests the client with the server, then plays in it. The games show that they are played to an end; in how many of them the T1
/// scores is in `docs/league.md`.
///
/// # Errors
/// If a test or a game fails.
pub(crate) fn check() -> Result<(), String> {
    build::cargo("test", &["--lib", "league::", "--", "--ignored"], &[])?;
    build::cargo("test", &["--test", "league", "--", "--ignored"], &[])?;
    let play = ["--", "play", "--world", "league", "--robot", "t1", "--games", "4", "--at-least", "1"];
    run("cargo", &[&["run", "--release"], build::release(), &play].concat(), &[])
}
