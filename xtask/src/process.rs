//! Execution of other programs.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Instant;

/// Folder of the workspace.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().map_or_else(|| ".".into(), Path::to_path_buf)
}

/// Prints the command line of a program, runs it in the workspace's folder, and prints the time if it took half a minute or more.
///
/// # Errors
/// If the program cannot be started or fails; the message contains the command line.
pub(crate) fn run(program: &str, arguments: &[&str], variables: &[(&str, &str)]) -> Result<(), String> {
    let line = format!("{program} {}", arguments.join(" "));
    eprintln!("xtask: {line}");
    let began = Instant::now();
    let status = Command::new(program).args(arguments).envs(variables.iter().copied()).current_dir(root()).status();
    let status = status.map_err(|error| format!("cannot start `{line}`: {error}"))?;
    let seconds = began.elapsed().as_secs();
    if seconds >= 30 {
        eprintln!("xtask: {seconds} s for {line}");
    }
    if status.success() { Ok(()) } else { Err(format!("`{line}` failed: {status}")) }
}

/// Whether a program runs and succeeds; its output is discarded.
pub(crate) fn works(program: &str, arguments: &[&str]) -> bool {
    Command::new(program)
        .args(arguments)
        .current_dir(root())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .is_ok_and(|status| status.success())
}

/// Prints the command line of a program, runs it in the workspace's folder, and returns its standard output.
///
/// # Errors
/// If the program cannot be started, fails, or prints text that is not UTF-8; the message contains the command line.
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
    String::from_utf8(done.stdout).map_err(|_| format!("the output of `{line}` is not UTF-8"))
}
