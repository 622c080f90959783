//! Builds of the workspace that all steps share.
//!
//! Cargo builds a crate again, with all that stand on it, for each selection of packages and features. The steps therefore select the whole
//! workspace with the same features.

use crate::install::folder;
use crate::mujoco;
use crate::process::run;

/// Features of packages that a step needs; not the self-test of the firmware, whose decoder makes numbers of JSON texts in all crates.
const FEATURES: &str = "bica-app/monitor,bica-app/ros,bica-evaluation/measure,bica-player-program/booster,\
    bica-player-program/evaluation,bica-player-program/league,bica-player-program/lola,bica-player-program/measure,\
    bica-player-program/referee,bica-tests/measure,therapy/monitor";
/// Those that need MuJoCo's library.
const MUJOCO: &str =
    "bica-body/mujoco,bica-evaluation/mujoco,bica-player-program/mujoco,bica-sim/mujoco,jmanager/mujoco,therapy/mujoco";

/// Arguments that select all packages and features; those of MuJoCo if it is installed.
pub(crate) fn workspace() -> Vec<String> {
    let features = if mujoco::is_installed() { format!("{FEATURES},{MUJOCO}") } else { FEATURES.to_owned() };
    ["--workspace", "--features", &features].map(str::to_owned).to_vec()
}

/// Runs a command of Cargo, such as `test`, for all packages and features.
///
/// # Errors
/// If it fails.
pub(crate) fn cargo(command: &str, more: &[&str], variables: &[(&str, &str)]) -> Result<(), String> {
    let workspace = workspace();
    let workspace = workspace.iter().map(String::as_str);
    let arguments: Vec<_> = [command].into_iter().chain(workspace).chain(more.iter().copied()).collect();
    let (name, folder) = libraries();
    run("cargo", &arguments, &[variables, &[(name, &folder)]].concat())
}

/// Variable with the folder of MuJoCo's library, for the tests of a package that has no build script which names the folder.
pub(crate) fn libraries() -> (&'static str, String) {
    ("LD_LIBRARY_PATH", folder("mujoco").to_string_lossy().into_owned())
}

/// Builds the programs and examples, as the tests use them.
///
/// # Errors
/// If a build fails.
pub(crate) fn programs() -> Result<(), String> {
    cargo("test", &["--no-run"], &[])
}

/// Path of a program that [`programs`] has built; that of an example begins with `examples/`.
pub(crate) fn program(name: &str) -> String {
    folder("debug").join(name).to_string_lossy().into_owned()
}

/// Features of a release build of the program, which is so built once for all steps.
pub(crate) fn release() -> &'static [&'static str] {
    if mujoco::is_installed() { &["--features", "mujoco"] } else { &["--features", "evaluation,league"] }
}
