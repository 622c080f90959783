//! Waiting time of a newcomer: the README's two commands in a fresh clone, and their slowest parts.

mod tests_by_time;
mod timings;

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

use crate::cli::Newcomer;
use crate::process::{root, run, run_in};
use crate::processor_time::{self, Spent};

/// Folder of the fresh clone; emptied before each measurement.
const CLONE: &str = "target/newcomer";
/// Limit of the time from the command to the end of the first game, on two idle processors.
const FIRST_GAME: Duration = Duration::from_secs(75);
/// Limit of the first `cargo test --workspace`.
const FIRST_TEST: Duration = Duration::from_mins(5);
/// Limit of the second `cargo test --workspace`, when everything is built.
const TEST: Duration = Duration::from_mins(1);
/// Number of lines of each list.
const LINES: usize = 12;

/// Measures and prints both commands and their slowest parts.
///
/// # Errors
/// If cloning, building or a test fails; with the option `--judge` also if a time is above its limit.
pub(crate) fn measure(options: &Newcomer) -> Result<(), String> {
    let clone = fresh_clone()?;
    let cargo = |arguments: &[&str]| run_in(&clone, "cargo", arguments);
    // The network is not measured.
    cargo(&["fetch", "--quiet", "--locked"])?;
    let game = processor_time::measure(|| cargo(&["run", "--release", "--timings"]))?;
    println!("\nslowest parts of the release build:\n{}", timings::table(&clone, LINES)?);
    let build = processor_time::measure(|| cargo(&["test", "--workspace", "--no-run", "--timings"]))?;
    println!("\nslowest parts of the test build:\n{}", timings::table(&clone, LINES)?);
    let log = clone.join("target/tests.log");
    let first = processor_time::measure(|| tests_by_time::run(&clone, &log))?;
    let again = processor_time::measure(|| tests_by_time::run(&clone, &log))?;
    println!("\nslowest test programs:\n{}", tests_by_time::table(&log, LINES)?);
    let clean = Spent { wall: build.wall + first.wall, busy: build.busy + first.busy };
    let rows = [
        ("first `cargo run --release`, to the end of the game", game, FIRST_GAME),
        ("first `cargo test --workspace`", clean, FIRST_TEST),
        ("second `cargo test --workspace`", again, TEST),
    ];
    report(&rows, options.judge)
}

fn fresh_clone() -> Result<PathBuf, String> {
    let clone = root().join(CLONE);
    if clone.exists() {
        fs::remove_dir_all(&clone).map_err(|error| format!("cannot empty {CLONE}: {error}"))?;
    }
    let text = |path: &Path| path.to_string_lossy().into_owned();
    run("git", &["clone", "--quiet", &text(&root()), &text(&clone)], &[])?;
    Ok(clone)
}

fn report(rows: &[(&str, Spent, Duration)], judge: bool) -> Result<(), String> {
    println!("\n{:<56}{:>10}{:>18}{:>10}", "", "wall", "all processors", "limit");
    for (what, Spent { wall, busy }, limit) in rows {
        let (wall, busy, limit) = (wall.as_secs_f64(), busy.as_secs_f64(), limit.as_secs());
        println!("{what:<56}{wall:>8.1} s{busy:>16.1} s{limit:>8} s");
    }
    println!(
        "Limits are for two idle processors; on a busy machine, half of the time of all processors is a lower bound."
    );
    let late = rows.iter().filter(|(_, spent, limit)| spent.wall > *limit).map(|(what, ..)| *what);
    let late: Vec<&str> = late.collect();
    if judge && !late.is_empty() { Err(format!("above its limit: {}", late.join("; "))) } else { Ok(()) }
}
