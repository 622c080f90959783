//! Installation of the tools that tasks need in addition to Rust.

use std::env;
use std::path::PathBuf;

use crate::process::{root, run, works};

/// Installs packages with `apt-get`; `words` may contain options of `apt-get install`.
///
/// # Errors
/// If the installation fails; the message names the packages to install by hand.
pub(crate) fn packages(words: &[&str]) -> Result<(), String> {
    let install = || {
        run("apt-get", &["update", "-qq"], &[])?;
        run("apt-get", &[&["install", "-y", "-qq"], words].concat(), &[])
    };
    let names: Vec<&str> = words.iter().copied().filter(|word| !word.starts_with('-')).collect();
    install().map_err(|error| {
        format!(
            "{error}; without apt-get or root rights, first install the Debian packages {} or their equivalents",
            names.join(", ")
        )
    })
}

/// Path of a folder in the build directory.
pub(crate) fn folder(name: &str) -> PathBuf {
    env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from).join(name)
}

/// Returns the path of a Cargo tool. If it is missing, installs it as Astral publishes it on `PyPI`, built, and on computers for
/// which it is not published builds it.
///
/// # Errors
/// If both fail.
pub(crate) fn cargo_tool(name: &str, version: &str) -> Result<String, String> {
    let folder = folder(name).to_string_lossy().into_owned();
    let path = format!("{folder}/bin/{name}");
    if works(&path, &["--version"]) {
        return Ok(path);
    }
    let package = format!("astral-dev-toolchain-{name}=={version}");
    let pip = format!("{folder}/bin/python");
    let ready = run("python3", &["-m", "venv", &folder], &[]).and_then(|()| {
        run(&pip, &["-m", "pip", "install", "--quiet", "--no-deps", "--only-binary", ":all:", &package], &[])
    });
    if let Err(error) = ready {
        eprintln!("xtask: {error}; building {name} {version} instead, once; this takes some minutes");
        // A debug build, because optimising takes longer than it saves.
        run(
            "cargo",
            &["install", "--quiet", "--locked", "--debug", name, "--version", version, "--root", &folder],
            &[],
        )?;
    }
    Ok(path)
}

/// Returns the path of a Python interpreter in a virtual environment that has a module; installs its packages from `PyPI` first if
/// it is missing.
///
/// # Errors
/// If an installation fails.
pub(crate) fn python(venv: &str, module: &str, pypi: &[&str]) -> Result<String, String> {
    let python = format!("{venv}/bin/python");
    let import = format!("import {module}");
    if !works(&python, &["-c", &import]) {
        run("python3", &["-m", "venv", venv], &[])
            .map_err(|error| format!("{error}; Debian has it in the packages python3 and python3-venv"))?;
        run(&python, &[&["-m", "pip", "install", "--quiet"], pypi].concat(), &[])?;
    }
    Ok(python)
}
