//! Other programs, run where their output can be seen.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The workspace's folder.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().map_or_else(|| ".".into(), Path::to_path_buf)
}

/// Runs a program in the workspace's folder, saying so first.
///
/// # Errors
/// The command line, if it can't be started or fails.
pub(crate) fn run(program: &str, arguments: &[&str], variables: &[(&str, &str)]) -> Result<(), String> {
    let line = format!("{program} {}", arguments.join(" "));
    eprintln!("xtask: {line}");
    let status = Command::new(program)
        .args(arguments)
        .envs(variables.iter().copied())
        .current_dir(root())
        .status()
        .map_err(|error| format!("cannot start `{line}`: {error}"))?;
    if status.success() { Ok(()) } else { Err(format!("`{line}` failed: {status}")) }
}

/// Whether a program runs and succeeds, its output unseen.
pub(crate) fn works(program: &str, arguments: &[&str]) -> bool {
    Command::new(program)
        .args(arguments)
        .current_dir(root())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .is_ok_and(|status| status.success())
}

/// Runs a program in the workspace's folder, saying so first: what it prints on its standard output.
///
/// # Errors
/// The command line, if it can't be started, fails, or prints what is no text.
pub(crate) fn output(program: &str, arguments: &[&str], variables: &[(&str, &str)]) -> Result<String, String> {
    let line = format!("{program} {}", arguments.join(" "));
    eprintln!("xtask: {line}");
    let done = Command::new(program)
        .args(arguments)
        .envs(variables.iter().copied())
        .current_dir(root())
        .stderr(Stdio::inherit())
        .output()
        .map_err(|error| format!("cannot start `{line}`: {error}"))?;
    if !done.status.success() {
        return Err(format!("`{line}` failed: {}", done.status));
    }
    String::from_utf8(done.stdout).map_err(|_| format!("`{line}` printed what is no text"))
}
