//! Repetition of the tests that start programs, threads and sockets.

use std::hint::spin_loop;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Instant;

use crate::browser;
use crate::cli::Stress;
use crate::process::capture;

/// Repeats each kind of tests, and prints the number of runs of each.
///
/// # Errors
/// At the first failure, with its output.
pub(crate) fn repeat(options: &Stress) -> Result<(), String> {
    let mut counts = Vec::new();
    let result = beside(options.busy, || {
        let test = ["test", "--quiet", "--workspace"];
        series(&mut counts, "cargo test --workspace", options.workspace, || capture("cargo", &test, &[]))
    })
    .and_then(|()| {
        let test = ["test", "--quiet", "--package", "jmanager", "--test", "main", "sessions::"];
        series(&mut counts, "sessions", options.sessions, || capture("cargo", &test, &[]))
    })
    .and_then(|()| {
        if options.browser > 0 {
            browser::prepare()?;
        }
        series(&mut counts, "browser", options.browser, || capture("cargo", &browser::TEST, &[]))
    });
    for (name, passed, runs) in counts {
        println!("{name}: {passed} of {runs} runs passed");
    }
    result
}

/// Runs a test several times, and notes how many runs passed.
fn series(
    counts: &mut Vec<(&'static str, u32, u32)>,
    name: &'static str,
    runs: u32,
    mut test: impl FnMut() -> Result<(), String>,
) -> Result<(), String> {
    let place = counts.len();
    counts.push((name, 0, runs));
    for run in 1..=runs {
        let began = Instant::now();
        test().map_err(|error| format!("{name}, run {run} of {runs}: {error}"))?;
        println!("{name}: run {run} of {runs} passed in {} s", began.elapsed().as_secs());
        counts[place].1 = run;
    }
    Ok(())
}

/// Does some work while a number of threads compute.
fn beside<R>(busy: u32, work: impl FnOnce() -> R) -> R {
    let running = AtomicBool::new(true);
    thread::scope(|scope| {
        for _ in 0..busy {
            scope.spawn(|| {
                while running.load(Ordering::Relaxed) {
                    spin_loop();
                }
            });
        }
        let result = work();
        running.store(false, Ordering::Relaxed);
        result
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_failure_ends_a_series() {
        let (mut counts, mut left) = (Vec::new(), 3);
        let result = series(&mut counts, "some", 9, || {
            left -= 1;
            if left == 0 { Err("broken".to_owned()) } else { Ok(()) }
        });
        assert_eq!(result, Err("some, run 3 of 9: broken".to_owned()));
        assert_eq!(counts, [("some", 2, 9)]);
    }
}
