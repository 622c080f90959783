//! A monitor as the loop sees it.

use std::sync::Arc;

use super::connection::Connection;
use super::cycle_data::Watched;

/// Largest number of information and components with conditions that a monitor watches.
pub(super) const MAX_WATCHED: usize = 512;

/// A monitor as the loop sees it.
#[derive(Clone, Debug)]
pub(super) struct Watcher {
    pub(super) connection: Arc<Connection>,
    /// A snapshot in every n-th cycle; 0: none.
    pub(super) every: u16,
    pub(super) watched: Arc<Watched>,
    /// Every n-th image; 0: none.
    pub(super) images: u16,
}

impl Watcher {
    pub(super) fn new(connection: Arc<Connection>) -> Self {
        Self { connection, every: 0, watched: Arc::default(), images: 0 }
    }

    /// Whether a snapshot is due in a cycle.
    pub(super) const fn is_due(&self, cycle: u64) -> bool {
        self.every > 0 && cycle.is_multiple_of(self.every as u64)
    }

    /// Whether it gets an image with a number: it is due, and the monitor has taken the last one.
    pub(super) fn wants_image(&self, number: u32) -> bool {
        self.images > 0 && number.is_multiple_of(self.images.into()) && self.connection.is_ready_for_image()
    }
}
