//! Recordings and exports, read by MCAP's Python library, and recordings that it has written again.

use std::fs;

use crate::install::{folder, python};
use crate::process::{output, run};

/// Topics of a recording.
const TOPICS: [&str; 7] = ["blobs", "sensors", "command", "tree", "tick", "costs", "information"];
/// Topics of an export.
const EXPORTED: [&str; 6] =
    ["/camera", "/log", "/sensors/angles", "/command/targets", "/tree", "/information/BallDetector/ball_position"];
/// Number of files that are written again: compressions, with chunks or not, with checksums or not.
const REWRITTEN: usize = 12;

/// Records and exports a game and reads both files; replays what MCAP's library makes of the recording. `features` are
/// those with which the program is built.
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
    run(&reader, &[&script[..], &TOPICS, &["--", &export], &EXPORTED].concat(), &[])?;
    let written = output(&reader, &["tools/recording/tests/rewrite_mcap.py", &recording, &path("")], &[])?;
    replay_all(&written, &program)
}

/// Replays files that another program wrote: equal, or refused if their chunks have a compression that ours cannot read.
fn replay_all(files: &str, program: &[&str]) -> Result<(), String> {
    for file in files.lines() {
        let replayed = output("cargo", &[program, &["replay", file]].concat(), &[]);
        match replayed {
            Err(_) if file.contains("zstd-chunks") => {}
            Ok(_) if file.contains("zstd-chunks") => return Err(format!("`{file}` was not refused")),
            result => _ = result?,
        }
    }
    let count = files.lines().count();
    if count == REWRITTEN { Ok(()) } else { Err(format!("{count} files were written again, not {REWRITTEN}")) }
}

/// Installs MCAP's Python library; returns the path of the interpreter that has it.
///
/// # Errors
/// If the installation fails.
pub(crate) fn install() -> Result<String, String> {
    python(&folder("viewers/venv").to_string_lossy(), "mcap, lz4, zstandard", &["mcap", "lz4", "zstandard"])
}
