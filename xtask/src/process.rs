//! Other programs: how they are run.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The workspace's folder.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().map_or_else(|| ".".into(), Path::to_path_buf)
}

/// Runs a program in the workspace's folder, and prints its command line first.
///
/// # Errors
/// The command line, if the program cannot be started or fails.
pub(crate) fn run(program: &str, arguments: &[&str], variables: &[(&str, &str)]) -> Result<(), String> {
    status(Command::new(program).args(arguments).envs(variables.iter().copied()).current_dir(root()))
}

/// Runs a program in another folder, with the build directory of that folder, and prints its command line first.
///
/// # Errors
/// The command line, if the program cannot be started or fails.
pub(crate) fn run_in(folder: &Path, program: &str, arguments: &[&str]) -> Result<(), String> {
    status(Command::new(program).args(arguments).env_remove("CARGO_TARGET_DIR").current_dir(folder))
}

fn status(command: &mut Command) -> Result<(), String> {
    let words: Vec<_> = command.get_args().map(|word| word.to_string_lossy().into_owned()).collect();
    let line = format!("{} {}", command.get_program().to_string_lossy(), words.join(" "));
    eprintln!("xtask: {line}");
    let status = command.status().map_err(|error| format!("cannot start `{line}`: {error}"))?;
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

/// Runs a program in the workspace's folder, prints its command line first, and returns its standard output.
///
/// # Errors
/// The command line, if the program cannot be started, fails, or prints something that is not UTF-8.
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
