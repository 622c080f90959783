//! Whether a file on disk has changed.

use std::fs;
use std::path::Path;
use std::time::{Duration, SystemTime};

/// Age below which a file may have changed again without a new time of its last change.
const FRESH: Duration = Duration::from_secs(2);

/// What a file system knows of a file without its being read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Stamp {
    length: u64,
    modified: Option<SystemTime>,
    pub(super) readonly: bool,
}

impl Stamp {
    /// The stamp of a file; `None` if there is none. Links are followed.
    pub(super) fn of(path: &Path) -> Option<Self> {
        let found = fs::metadata(path).ok()?;
        let readonly = found.permissions().readonly();
        Some(Self { length: found.len(), modified: found.modified().ok(), readonly })
    }

    /// Whether the file could have changed since without a new stamp, as clocks of file systems are coarse.
    pub(super) fn is_fresh(&self) -> bool {
        self.modified.is_none_or(|modified| modified.elapsed().is_ok_and(|age| age < FRESH))
    }

    /// Whether the content may differ.
    pub(super) fn differs(&self, other: &Self) -> bool {
        (self.length, self.modified) != (other.length, other.modified)
    }
}
