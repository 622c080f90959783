//! A monitor as the loop sees it.

use std::sync::Arc;

use super::connection::Connection;
use super::cycle_data::Watched;

/// Largest number of information that a monitor watches.
pub(super) const MAX_INFO: usize = 256;

/// A monitor as the loop sees it.
#[derive(Clone, Debug)]
pub(super) struct Watcher {
    pub(super) connection: Arc<Connection>,
    /// A snapshot in every n-th cycle; 0: none.
    pub(super) every: u16,
    pub(super) watched: Arc<Watched>,
}

impl Watcher {
    pub(super) fn new(connection: Arc<Connection>) -> Self {
        Self { connection, every: 0, watched: Arc::default() }
    }

    /// Whether a snapshot is due in a cycle.
    pub(super) const fn is_due(&self, cycle: u64) -> bool {
        self.every > 0 && cycle.is_multiple_of(self.every as u64)
    }
}
