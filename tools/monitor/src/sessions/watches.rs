//! What each page watches of a session.

use std::collections::BTreeMap;
use std::time::Instant;

use crate::pages::PageId;
use crate::protocol::Watch;

/// What pages watch of a session.
#[derive(Default)]
pub(super) struct Watching {
    pub(super) by_page: BTreeMap<PageId, Watch>,
    /// Number of the last image that a page was sent, and when.
    pub(super) images: BTreeMap<PageId, (u32, Instant)>,
}

impl Watching {
    /// Everything that a page watches.
    pub(super) fn watches(&self) -> impl Iterator<Item = &Watch> {
        self.by_page.values()
    }

    pub(super) fn pages(&self, watches: impl Fn(&Watch) -> bool) -> Vec<PageId> {
        self.by_page.iter().filter(|(_, watch)| watches(watch)).map(|(&page, _)| page).collect()
    }

    /// Forgets a page that has gone.
    pub(super) fn remove(&mut self, page: PageId) {
        self.by_page.remove(&page);
        self.images.remove(&page);
    }
}
