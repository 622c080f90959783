//! The Python package in `python/`: its environment, its checks, and its wheel in a clean environment.

use std::fs;
use std::path::Path;

use crate::build;
use crate::install::{folder, packages};
use crate::process::{run, works};

/// Folder of the package, from the workspace.
const PACKAGE: &str = "./python";
/// Where Debian puts the programs of `PostgreSQL`, whose server the tests start.
const POSTGRES: &str = "/usr/lib/postgresql";

/// Installs the package with all that its tests need, as a developer uses it, and `PostgreSQL`.
///
/// # Errors
/// If an installation fails.
pub(crate) fn install() -> Result<String, String> {
    if !Path::new(POSTGRES).is_dir() && !works("pg_ctl", &["--version"]) {
        packages(&["--no-install-recommends", "postgresql"])?;
    }
    let python = environment("venv")?;
    run(&python, &["-m", "pip", "install", "--quiet", "--editable", &format!("{PACKAGE}[test]")], &[])?;
    Ok(python)
}

/// Tests that CI leaves out: those of clusters, and of searches that are killed, take half of the time.
pub(crate) const SHORT: [&str; 3] = ["--ignore=python/tests/test_distribution.py", "-k", "not interrupt"];

/// Checks lints, types and tests of the package with the programs of this workspace, then the wheel. `selection` has arguments of pytest.
///
/// # Errors
/// If an installation or a check fails.
pub(crate) fn check(selection: &[&str]) -> Result<(), String> {
    run("cargo", &[&["build", "--release", "--quiet"], build::release()].concat(), &[])?;
    build::programs()?;
    let python = install()?;
    let player = folder("release/player").to_string_lossy().into_owned();
    let programs = [("BICA_PROGRAM", &*player), ("BICA_WALL_FOLLOWER", &build::program("examples/wall_follower"))];
    let config = format!("{PACKAGE}/pyproject.toml");
    run(&python, &["-m", "ruff", "check", PACKAGE], &[])?;
    run(&python, &["-m", "ruff", "format", "--check", PACKAGE], &[])?;
    run(&python, &["-m", "mypy", "--config-file", &config, "python/bica", "python/tests"], &[])?;
    let tests = ["-m", "pytest", "--quiet", "--rootdir", PACKAGE, "-c", &config, "python/tests"];
    run(&python, &[&tests[..], selection].concat(), &programs)?;
    wheel(&python)
}

/// Builds the wheel, and installs it without this checkout in an environment of its own.
fn wheel(python: &str) -> Result<(), String> {
    let wheels = folder("python/wheels");
    _ = fs::remove_dir_all(&wheels);
    _ = fs::remove_dir_all(folder("python/clean"));
    let directory = wheels.to_string_lossy();
    run(python, &["-m", "pip", "wheel", "--quiet", "--no-deps", "--wheel-dir", &directory, PACKAGE], &[])?;
    let clean = environment("clean")?;
    let wheel = format!("{directory}/bica-{}-py3-none-any.whl", env!("CARGO_PKG_VERSION"));
    run(&clean, &["-m", "pip", "install", "--quiet", &wheel], &[])?;
    run(&clean, &["-I", "-c", "import bica; bica.Program, bica.Recording, bica.series"], &[])
}

/// Returns the interpreter of a virtual environment, which is made if it is missing.
fn environment(name: &str) -> Result<String, String> {
    let folder = folder("python").join(name).to_string_lossy().into_owned();
    let python = format!("{folder}/bin/python");
    if !works(&python, &["--version"]) {
        run("python3", &["-m", "venv", &folder], &[])
            .map_err(|error| format!("{error}; Debian has it in the packages python3 and python3-venv"))?;
    }
    Ok(python)
}
