//! Progress of a long command.

use std::io::{IsTerminal, Write, stderr};
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// Number of steps of the progress bar.
const STEPS: u64 = 30;

/// Progress bar on stderr, as `[######        ] 20 %`; nothing if stderr is not a terminal.
#[derive(Debug)]
pub struct Progress {
    all: u64,
    /// Steps shown; `STEPS + 1` hides the line.
    shown: AtomicU64,
}

impl Progress {
    /// Creates a bar for a total amount, such as bytes or games.
    #[must_use]
    pub fn new(all: u64) -> Self {
        Self { all: all.max(1), shown: AtomicU64::new(if stderr().is_terminal() { 0 } else { STEPS + 1 }) }
    }

    /// Shows that `done` of the total is done, and a note. Several threads may call it.
    pub fn show(&self, done: u64, note: &str) {
        let done = done.min(self.all);
        let step = done * STEPS / self.all;
        if self.shown.fetch_max(step, Relaxed) < step {
            let bar = "#".repeat(step as usize);
            let _ = write!(stderr().lock(), "\r[{bar:<30}] {} % {note}", 100 * done / self.all);
        }
    }
}

/// Clears the line.
impl Drop for Progress {
    fn drop(&mut self) {
        if (1..=STEPS).contains(self.shown.get_mut()) {
            let _ = write!(stderr().lock(), "\r{:79}\r", "");
        }
    }
}
