//! Lines of a run that wait for the end of the cycle.

use std::mem::take;
use std::sync::{Mutex, MutexGuard, PoisonError};

use bica::ComponentId;
use bica_wire::message::MAX_TEXT_BYTES;
use bica_wire::truncate;
use log::{Level, Record};

/// Largest number of lines in a second of the robot's time; further ones are counted.
pub(super) const MAX_LINES: u32 = 100;

/// A line as it was written.
pub(super) struct Line {
    /// Component whose step or job wrote it; `None` is other code of the loop's thread, such as the world.
    pub(super) component: Option<ComponentId>,
    pub(super) level: Level,
    /// Module that wrote it.
    pub(super) target: String,
    /// At most [`MAX_TEXT_BYTES`] bytes.
    pub(super) text: String,
}

/// Lines of a run, which its loop and its jobs write.
pub(super) struct Waiting(Mutex<State>);

struct State {
    lines: Vec<Line>,
    /// Number of lines that are accepted in this second.
    left: u32,
    /// Number of lines that were not accepted.
    dropped: u64,
}

impl Waiting {
    pub(super) const fn new() -> Self {
        Self(Mutex::new(State { lines: Vec::new(), left: MAX_LINES, dropped: 0 }))
    }

    fn lock(&self) -> MutexGuard<'_, State> {
        // No code panics while it holds the lock.
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Adds a line. One that is dropped is not formatted.
    pub(super) fn add(&self, component: Option<ComponentId>, record: &Record<'_>) {
        {
            let mut state = self.lock();
            let Some(left) = state.left.checked_sub(1) else {
                state.dropped += 1;
                return;
            };
            state.left = left;
        }
        // The value that is formatted may write a line itself.
        let text = truncate(&record.args().to_string(), MAX_TEXT_BYTES).to_owned();
        let line = Line { component, level: record.level(), target: record.target().to_owned(), text };
        self.lock().lines.push(line);
    }

    /// Returns the lines since the last call.
    pub(super) fn take(&self) -> Vec<Line> {
        take(&mut self.lock().lines)
    }

    /// Begins a second; returns the number of lines that were dropped in the last one.
    pub(super) fn begin_second(&self) -> u64 {
        let mut state = self.lock();
        state.left = MAX_LINES;
        take(&mut state.dropped)
    }
}
