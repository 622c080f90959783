//! All pages.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use super::outbox::{Frame, Key, Outbox};
use crate::protocol::{Failed, ToPage};

/// Identifier of a page.
pub type PageId = u64;

/// All pages with their outboxes.
#[derive(Default)]
pub(super) struct Pages {
    all: Mutex<BTreeMap<PageId, Arc<dyn Outbox>>>,
}

/// Locks a mutex; what a thread that panicked left behind is used as it is.
pub(super) fn lock<T: ?Sized>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Pages {
    pub(super) fn add(&self, page: PageId, outbox: Arc<dyn Outbox>) {
        lock(&self.all).insert(page, outbox);
    }

    pub(super) fn remove(&self, page: PageId) {
        lock(&self.all).remove(&page);
    }

    pub(super) fn list(&self) -> Vec<PageId> {
        lock(&self.all).keys().copied().collect()
    }

    fn get(&self, page: PageId) -> Option<Arc<dyn Outbox>> {
        lock(&self.all).get(&page).cloned()
    }

    pub(super) fn state(&self, page: PageId, message: ToPage) {
        if let Some(outbox) = self.get(page) {
            outbox.state(message);
        }
    }

    pub(super) fn binary(&self, page: PageId, frame: Arc<[u8]>) {
        if let Some(outbox) = self.get(page) {
            outbox.binary(frame);
        }
    }

    pub(super) fn data(&self, page: PageId, key: Key, frame: Frame) {
        if let Some(outbox) = self.get(page) {
            outbox.data(key, frame);
        }
    }

    /// Sends a message to all pages.
    pub(super) fn broadcast(&self, message: &ToPage) {
        for page in self.list() {
            self.state(page, message.clone());
        }
    }

    /// Sends data to all pages.
    pub(super) fn broadcast_data(&self, key: Key, frame: &Frame) {
        for page in self.list() {
            self.data(page, key, frame.clone());
        }
    }

    /// Answers a message of a page.
    pub(super) fn answer(&self, page: PageId, id: u32, result: Result<serde_json::Value, Failed>) {
        let (result, error) = match result {
            Ok(value) => (Some(value), None),
            Err(error) => (None, Some(error)),
        };
        self.state(page, ToPage::Answer { id, result, error });
    }
}
