//! Places of connections that have not entered.

use std::collections::VecDeque;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError, Weak};

use tokio::sync::Notify;

/// Largest number of connections that have not entered; a browser needs six to load the page.
const MAX_PLACES: usize = 64;

/// The connections that have not entered. If there are too many, the oldest is closed: who asks at once always gets an answer.
#[derive(Default)]
pub(crate) struct Places(Mutex<VecDeque<Weak<Place>>>);

/// Place of a connection, free when it is dropped.
#[derive(Default)]
pub(crate) struct Place {
    needed: Notify,
    has_entered: AtomicBool,
}

impl Places {
    /// Returns a place for a new connection.
    pub(crate) fn take(&self) -> Arc<Place> {
        let place = Arc::<Place>::default();
        let mut places = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        places.retain(|place| place.upgrade().is_some_and(|place| !place.has_entered.load(Ordering::Relaxed)));
        if places.len() == MAX_PLACES
            && let Some(oldest) = places.pop_front().and_then(|oldest| oldest.upgrade())
        {
            oldest.needed.notify_one();
        }
        places.push_back(Arc::downgrade(&place));
        place
    }
}

impl Place {
    /// Waits until another connection needs the place.
    pub(crate) async fn needed(&self) {
        self.needed.notified().await;
    }

    /// The connection has entered: it keeps its place among the pages.
    pub(crate) fn enter(&self) {
        self.has_entered.store(true, Ordering::Relaxed);
    }
}
