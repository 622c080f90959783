//! Times of the test programs, from the output of `cargo test`.

use std::fmt::Write;
use std::fs::{self, File};
use std::path::Path;
use std::process::Command;

/// Runs all tests of the workspace in a folder and writes their output to a file.
///
/// # Errors
/// If the tests cannot be run, or one fails.
pub(super) fn run(folder: &Path, log: &Path) -> Result<(), String> {
    eprintln!("xtask: cargo test --workspace, into {}", log.display());
    let create = |error| format!("cannot write {}: {error}", log.display());
    let out = File::create(log).map_err(create)?;
    let copy = out.try_clone().map_err(create)?;
    let status = Command::new("cargo")
        .args(["test", "--workspace"])
        .current_dir(folder)
        .env_remove("CARGO_TARGET_DIR")
        .stdout(out)
        .stderr(copy)
        .status()
        .map_err(|error| format!("cannot start cargo: {error}"))?;
    if status.success() { Ok(()) } else { Err(format!("a test failed; see {}", log.display())) }
}

/// Lists the slowest test programs of a log, one per line.
///
/// # Errors
/// If the log cannot be read, or names no test program.
pub(super) fn table(log: &Path, lines: usize) -> Result<String, String> {
    let text = fs::read_to_string(log).map_err(|error| format!("cannot read {}: {error}", log.display()))?;
    let mut rows = programs(&text);
    if rows.is_empty() {
        return Err(format!("{} names no test program", log.display()));
    }
    rows.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut table = String::new();
    for (seconds, name) in rows.iter().take(lines) {
        let _ = writeln!(table, "{seconds:>8.1} s  {name}");
    }
    Ok(table)
}

/// Time and name of each test program: a line names it, and a later line contains its time.
fn programs(text: &str) -> Vec<(f64, &str)> {
    let mut name = None;
    let mut rows = Vec::new();
    for line in text.lines().map(str::trim) {
        if line.starts_with("Running ") || line.starts_with("Doc-tests ") {
            name = Some(line);
        }
        let finished = line.split_once("; finished in ").and_then(|(_, time)| time.strip_suffix('s')?.parse().ok());
        if let (Some(seconds), Some(name)) = (finished, name) {
            rows.push((seconds, name));
        }
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_program_has_the_time_of_its_result() {
        let log = "     Running unittests src/lib.rs (target/debug/deps/bica-1)\n\n\
                   test result: ok. 3 passed; 0 failed; finished in 0.25s\n\
                   \x20    Running forward/main.rs (target/debug/deps/forward-2)\n\
                   test result: ok. 9 passed; 0 failed; finished in 7.50s\n";
        let expected = [
            (0.25, "Running unittests src/lib.rs (target/debug/deps/bica-1)"),
            (7.5, "Running forward/main.rs (target/debug/deps/forward-2)"),
        ];
        assert_eq!(programs(log), expected);
    }
}
