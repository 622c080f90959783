//! Recordings and exports, read by programs of others: MCAP's Python library, and Rerun.

use std::fs;

use crate::cli::Viewers;
use crate::install::{folder, python};
use crate::process::{output, run};

/// Topics of a recording.
const TOPICS: [&str; 7] = ["images", "sensors", "command", "tree", "tick", "costs", "information"];
/// Topics of an export.
const EXPORTED: [&str; 6] =
    ["/camera", "/log", "/sensors/angles", "/command/targets", "/tree", "/information/BallDetector/ball_position"];
/// What Rerun makes of an export: entities with their kinds of data.
const RERUN: [&str; 4] =
    ["/camera - data columns: [CoordinateFrame:frame Image:buffer", "TextLog:text", "bica.Joints", "/costs"];

/// Records and exports a game and reads both files. `features` are those with which the program is built.
///
/// # Errors
/// If an installation fails or a file cannot be read.
pub(crate) fn check(options: &Viewers, features: &[&str]) -> Result<(), String> {
    let folder = folder("viewers");
    fs::create_dir_all(&folder).map_err(|error| format!("cannot make {}: {error}", folder.display()))?;
    let path = |name: &str| folder.join(name).to_string_lossy().into_owned();
    let (recording, export, venv) = (path("run.mcap"), path("view.mcap"), path("venv"));
    let program = [&["run", "--release", "--quiet"], features, &["--"]].concat();
    let play = ["play", "--seed", "1", "--size", "160x120", "--force", "--record", &recording];
    output("cargo", &[&program[..], &play].concat(), &[])?;
    run("cargo", &[&program[..], &["record", "export", "--force", &recording, &export]].concat(), &[])?;
    let reader = python(&venv, "mcap", &["mcap"])?;
    let script = ["tools/recording/tests/read_mcap.py", &recording];
    run(&reader, &[&script[..], &TOPICS, &["--", &export], &EXPORTED].concat(), &[])?;
    if options.rerun { rerun(&venv, &export, &path("view.rrd")) } else { Ok(()) }
}

fn rerun(venv: &str, export: &str, converted: &str) -> Result<(), String> {
    python(venv, "rerun", &["rerun-sdk"])?;
    let program = format!("{venv}/bin/rerun");
    run(&program, &["mcap", "check", export], &[])?;
    run(&program, &["mcap", "convert", export, "-o", converted], &[])?;
    let printed = output(&program, &["rrd", "print", converted], &[])?;
    let missing: Vec<_> = RERUN.iter().filter(|text| !printed.contains(**text)).collect();
    if missing.is_empty() { Ok(()) } else { Err(format!("Rerun shows no {missing:?} of {export}:\n{printed}")) }
}
