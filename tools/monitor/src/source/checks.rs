//! Requests for the compiler's check.

use std::collections::BTreeSet;
use std::path::PathBuf;
use std::sync::{Condvar, Mutex};
use std::time::{Duration, Instant};

use super::process::Group;
use crate::pages::lock;
use crate::protocol::Check;

/// Delay from a save to the check.
const AFTER: Duration = Duration::from_millis(200);

/// Requested checks.
#[derive(Default)]
pub(super) struct Checks {
    pub(super) state: Mutex<State>,
    changed: Condvar,
}

#[derive(Default)]
pub(super) struct State {
    /// Files whose packages are to be checked.
    pub(super) wanted: BTreeSet<PathBuf>,
    due: Option<Instant>,
    running: Option<Group>,
    /// Whether the running check concerns an older text.
    outdated: bool,
    pub(super) ended: bool,
    pub(super) last: Option<Check>,
}

impl Checks {
    /// Requests a check of the packages of files. A running check is cancelled.
    pub(super) fn want(&self, paths: impl IntoIterator<Item = PathBuf>) {
        let mut state = lock(&self.state);
        state.wanted.extend(paths);
        state.due = Some(Instant::now() + AFTER);
        state.outdated = true;
        if let Some(group) = state.running {
            group.kill();
        }
        self.changed.notify_all();
    }

    /// Ends the running check, and the thread.
    pub(super) fn end(&self) {
        let mut state = lock(&self.state);
        state.ended = true;
        if let Some(group) = state.running {
            group.kill();
        }
        self.changed.notify_all();
    }

    /// Returns the last message about a check.
    pub(super) fn last(&self) -> Option<Check> {
        lock(&self.state).last.clone()
    }

    /// Waits for a requested check, and returns its files; `None` at the end.
    pub(super) fn next(&self) -> Option<BTreeSet<PathBuf>> {
        let mut state = lock(&self.state);
        loop {
            if state.ended {
                return None;
            }
            let left = state.due.map(|due| due.saturating_duration_since(Instant::now()));
            if left == Some(Duration::ZERO) && !state.wanted.is_empty() {
                (state.due, state.outdated) = (None, false);
                return Some(std::mem::take(&mut state.wanted));
            }
            let wait = left.unwrap_or(Duration::from_mins(1)).max(Duration::from_millis(1));
            let waited = self.changed.wait_timeout(state, wait);
            state = waited.unwrap_or_else(std::sync::PoisonError::into_inner).0;
        }
    }

    pub(super) fn is_outdated(&self) -> bool {
        let state = lock(&self.state);
        state.outdated || state.ended
    }

    pub(super) fn set_running(&self, group: Option<Group>) -> bool {
        let mut state = lock(&self.state);
        state.running = group;
        state.outdated || state.ended
    }
}
