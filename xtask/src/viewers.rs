//! Recordings and exports, read by MCAP's Python library.

use std::fs;

use crate::install::{folder, python};
use crate::process::{output, run};

/// Topics of a recording.
const TOPICS: [&str; 7] = ["images", "sensors", "command", "tree", "tick", "costs", "information"];
/// Topics of an export.
const EXPORTED: [&str; 6] =
    ["/camera", "/log", "/sensors/angles", "/command/targets", "/tree", "/information/BallDetector/ball_position"];
/// Records and exports a game and reads both files. `features` are those with which the program is built.
///
/// # Errors
/// If an installation fails or a file cannot be read.
pub(crate) fn check(features: &[&str]) -> Result<(), String> {
    let folder = folder("viewers");
    fs::create_dir_all(&folder).map_err(|error| format!("cannot make {}: {error}", folder.display()))?;
    let path = |name: &str| folder.join(name).to_string_lossy().into_owned();
    let (recording, export) = (path("run.mcap"), path("view.mcap"));
    let program = [&["run", "--release", "--quiet"], features, &["--"]].concat();
    let play = ["play", "--seed", "1", "--size", "160x120", "--force", "--record", &recording];
    output("cargo", &[&program[..], &play].concat(), &[])?;
    run("cargo", &[&program[..], &["record", "export", "--force", &recording, &export]].concat(), &[])?;
    let reader = install()?;
    let script = ["tools/recording/tests/read_mcap.py", &recording];
    run(&reader, &[&script[..], &TOPICS, &["--", &export], &EXPORTED].concat(), &[])
}

/// Installs MCAP's Python library; returns the path of the interpreter that has it.
///
/// # Errors
/// If the installation fails.
pub(crate) fn install() -> Result<String, String> {
    python(&folder("viewers/venv").to_string_lossy(), "mcap", &["mcap"])
}
