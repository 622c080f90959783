//! Connections that have not entered.

use std::collections::VecDeque;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError, Weak};

use tokio::sync::Notify;

/// Largest number of connections that have not entered; a browser needs six to load the page.
const MAX_PENDING: usize = 64;

/// Connections that have not entered. If there are too many, the oldest is closed, so that a request that is sent at once is always
/// answered.
#[derive(Default)]
pub(crate) struct PendingConnections(Mutex<VecDeque<Weak<PendingConnection>>>);

/// A connection. It leaves the list when it is dropped.
#[derive(Default)]
pub(crate) struct PendingConnection {
    needed: Notify,
    has_entered: AtomicBool,
}

impl PendingConnections {
    /// Adds a new connection.
    pub(crate) fn add(&self) -> Arc<PendingConnection> {
        let connection = Arc::<PendingConnection>::default();
        let mut pending = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        pending.retain(|one| one.upgrade().is_some_and(|one| !one.has_entered.load(Ordering::Relaxed)));
        if pending.len() == MAX_PENDING
            && let Some(oldest) = pending.pop_front().and_then(|oldest| oldest.upgrade())
        {
            oldest.needed.notify_one();
        }
        pending.push_back(Arc::downgrade(&connection));
        connection
    }
}

impl PendingConnection {
    /// Waits until another connection needs its place.
    pub(crate) async fn needed(&self) {
        self.needed.notified().await;
    }

    /// Marks the connection as entered, so that it is not closed to make room.
    pub(crate) fn enter(&self) {
        self.has_entered.store(true, Ordering::Relaxed);
    }
}
