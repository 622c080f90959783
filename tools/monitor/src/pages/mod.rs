//! All pages, each with the queue of its messages.

mod outbox;

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use crate::protocol::{Failed, ToPage};

pub use outbox::{DataKind, Frame, Key, Outbox};

/// Identifier of a page.
pub type PageId = u64;

/// All pages with their outboxes.
#[derive(Default)]
pub(crate) struct Pages {
    all: Mutex<BTreeMap<PageId, Arc<dyn Outbox>>>,
}

/// Locks a mutex, also if it is poisoned: the data that a panicked thread left are used unchanged.
pub(crate) fn lock<T: ?Sized>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Pages {
    pub(crate) fn add(&self, page: PageId, outbox: Arc<dyn Outbox>) {
        lock(&self.all).insert(page, outbox);
    }

    pub(crate) fn remove(&self, page: PageId) {
        lock(&self.all).remove(&page);
    }

    pub(crate) fn list(&self) -> Vec<PageId> {
        lock(&self.all).keys().copied().collect()
    }

    fn get(&self, page: PageId) -> Option<Arc<dyn Outbox>> {
        lock(&self.all).get(&page).cloned()
    }

    pub(crate) fn state(&self, page: PageId, message: ToPage) {
        if let Some(outbox) = self.get(page) {
            outbox.state(message);
        }
    }

    pub(crate) fn binary(&self, page: PageId, frame: Arc<[u8]>) {
        if let Some(outbox) = self.get(page) {
            outbox.binary(frame);
        }
    }

    pub(crate) fn data(&self, page: PageId, key: Key, frame: Frame) {
        if let Some(outbox) = self.get(page) {
            outbox.data(key, frame);
        }
    }

    /// Sends a message to all pages.
    pub(crate) fn broadcast(&self, message: &ToPage) {
        for page in self.list() {
            self.state(page, message.clone());
        }
    }

    /// Sends data to all pages.
    pub(crate) fn broadcast_data(&self, key: Key, frame: &Frame) {
        for page in self.list() {
            self.data(page, key, frame.clone());
        }
    }

    /// Answers a message of a page.
    pub(crate) fn answer(&self, page: PageId, id: u32, result: Result<serde_json::Value, Failed>) {
        let (result, error) = match result {
            Ok(value) => (Some(value), None),
            Err(error) => (None, Some(error)),
        };
        self.state(page, ToPage::Answer { id, result, error });
    }
}
