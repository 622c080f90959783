//! Data of a session that each page watches.

use std::collections::BTreeMap;
use std::time::Instant;

use crate::pages::PageId;
use crate::protocol::Watch;

/// Data of a session that pages watch.
#[derive(Default)]
pub(super) struct Watching {
    pub(super) by_page: BTreeMap<PageId, Watch>,
    /// Number of the last image that was sent to a page, and the instant of sending.
    pub(super) images: BTreeMap<PageId, (u32, Instant)>,
}

impl Watching {
    /// Returns the watches of all pages.
    pub(super) fn watches(&self) -> impl Iterator<Item = &Watch> {
        self.by_page.values()
    }

    pub(super) fn pages(&self, watches: impl Fn(&Watch) -> bool) -> Vec<PageId> {
        self.by_page.iter().filter(|(_, watch)| watches(watch)).map(|(&page, _)| page).collect()
    }

    /// Removes a page that was closed.
    pub(super) fn remove(&mut self, page: PageId) {
        self.by_page.remove(&page);
        self.images.remove(&page);
    }
}
