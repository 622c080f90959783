//! MuJoCo's library, and the software renderer for its camera images.

use std::env::consts::{ARCH, OS};
use std::fs;
use std::path::Path;

use crate::build;
use crate::install::packages;
use crate::process::{root, run, works};

/// Folder in which builds with the feature `mujoco` find the library (set in `.cargo/config.toml`).
const FOLDER: &str = "target/mujoco";
/// Version that `mujoco-rs` requires.
const VERSION: &str = "3.17.0";
/// Debian packages of EGL and of Mesa's software renderer.
const RENDERER: [&str; 2] = ["libegl1", "libgl1-mesa-dri"];

/// Whether the library is installed.
pub(crate) fn is_installed() -> bool {
    root().join(FOLDER).join(format!("libmujoco.so.{VERSION}")).is_file()
}

/// Installs the library in [`FOLDER`], from the Python package that its authors publish, and [`RENDERER`].
///
/// # Errors
/// If an installation fails.
pub(crate) fn install() -> Result<(), String> {
    if OS != "linux" {
        return Err(format!("MuJoCo's library can be installed on Linux only; this system is {OS}"));
    }
    let folder = root().join(FOLDER);
    let library = format!("libmujoco.so.{VERSION}");
    if is_installed() {
        eprintln!("xtask: {FOLDER}/{library} is already installed");
    } else {
        fetch(&folder, &library).map_err(|error| {
            format!("{error}\n  help: this needs Python's pip and a network; or copy {library} into {FOLDER} by hand")
        })?;
    }
    link(&folder, &library).map_err(|error| format!("cannot link {FOLDER}/libmujoco.so to {library}: {error}"))?;
    if RENDERER.iter().all(|package| works("dpkg", &["-s", package])) {
        eprintln!("xtask: {} are already installed", RENDERER.join(" and "));
        return Ok(());
    }
    packages(&[&["--no-install-recommends"], &RENDERER[..]].concat())
        .map_err(|error| format!("{error}\n  help: MuJoCo's library is installed; only the renderer is missing"))
}

/// Trials in CI, with fewer runs than the default of `player trial`.
const TRIALS: [&str; 9] = ["walk", "commands", "pushes", "bodies", "odometry", "kicks", "falls", "get-up", "obstacles"];

/// Plays in MuJoCo: trials of the body, and some games. The lints and the tests have their steps.
///
/// # Errors
/// If a check fails; later ones do not run.
pub(crate) fn check() -> Result<(), String> {
    let program = [&["run", "--release"], build::release(), &["--"]].concat();
    run("cargo", &[&program[..], &["trial", "--runs", "4"], &TRIALS[..]].concat(), &[])?;
    run("cargo", &[&program[..], &["trial", "--runs", "4", "--robot", "k1"]].concat(), &[])?;
    run("cargo", &[&program[..], &["trial", "--runs", "4", "--robot", "t1", "kicks", "get-up"]].concat(), &[])?;
    let games = ["play", "--world", "mujoco", "--games", "8", "--seconds", "180", "--at-least", "7"];
    run("cargo", &[&program[..], &games].concat(), &[])
}

/// Downloads the Python package and extracts the library.
fn fetch(folder: &Path, library: &str) -> Result<(), String> {
    if !works("python3", &["-m", "pip", "--version"]) {
        packages(&["--no-install-recommends", "python3-pip"])?;
    }
    let wheel = folder.join("wheel");
    let message = |error| format!("cannot write to {FOLDER}: {error}");
    fs::create_dir_all(&wheel).map_err(message)?;
    let (package, platform) = (format!("mujoco=={VERSION}"), format!("manylinux_2_28_{ARCH}"));
    let place = format!("{FOLDER}/wheel");
    let chosen = ["--only-binary=:all:", "--platform", &platform, "--python-version", "3.12"];
    let get = ["-m", "pip", "download", "--quiet", "--no-deps", "--dest", &place, &package];
    run("python3", &[&get[..], &chosen].concat(), &[])?;
    let packed = fs::read_dir(&wheel).map_err(message)?.flatten().map(|entry| entry.path());
    let packed = packed.max().ok_or("pip downloaded no package")?;
    run("python3", &["-m", "zipfile", "-e", &packed.to_string_lossy(), &place], &[])?;
    fs::rename(wheel.join("mujoco").join(library), folder.join(library)).map_err(message)?;
    fs::remove_dir_all(wheel).map_err(message)?;
    eprintln!("xtask: put {library} into {FOLDER}");
    Ok(())
}

/// Links the library to the name that the linker expects.
fn link(folder: &Path, library: &str) -> std::io::Result<()> {
    let name = folder.join("libmujoco.so");
    if name.symlink_metadata().is_ok() {
        fs::remove_file(&name)?;
    }
    std::os::unix::fs::symlink(library, name)
}
