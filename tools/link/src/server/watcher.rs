//! A monitor as the loop sees it.

use std::sync::Arc;

use super::connection::Connection;
use super::cycle_data::Watched;
use super::key::Key;
use super::outbox::Unsent;

/// Maximum number of outputs and other keys that a monitor watches, and maximum number of its stops.
pub(super) const MAX_WATCHED: usize = 512;

/// A monitor as the loop sees it.
#[derive(Debug)]
pub(super) struct Watcher {
    pub(super) connection: Arc<Connection>,
    /// A snapshot in every n-th cycle; 0: none.
    pub(super) every: u16,
    pub(super) watched: Arc<Watched>,
    /// Every n-th image; 0: none.
    pub(super) images: u16,
    /// Data that the writer has not received yet.
    pub(super) unsent: Unsent,
}

impl Watcher {
    pub(super) fn new(connection: Arc<Connection>) -> Self {
        Self { connection, every: 0, watched: Arc::default(), images: 0, unsent: Unsent::default() }
    }

    /// Returns whether a snapshot is due in a cycle.
    pub(super) const fn is_due(&self, cycle: u64) -> bool {
        self.every > 0 && cycle.is_multiple_of(self.every as u64)
    }

    /// Returns whether the data of a key are due in a cycle.
    pub(super) fn is_key_due(&self, key: Key, cycle: u64) -> bool {
        self.watched.get(&key).is_some_and(|&every| cycle.is_multiple_of(every.into()))
    }

    /// Returns whether the monitor gets the image with a number: it is due, or the world `stands` still, and the connection is
    /// ready for it.
    pub(super) fn wants_image(&self, number: u32, stands: bool) -> bool {
        let is_due = self.images > 0 && (stands || number.is_multiple_of(self.images.into()));
        is_due && self.connection.is_ready_for_image(number)
    }
}
