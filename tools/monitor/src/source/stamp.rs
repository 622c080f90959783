//! Detection of changes of files on disk.

use std::fs;
use std::path::Path;
use std::time::{Duration, SystemTime};

/// Age of the last modification below which a file may have changed again with the same modification time.
const FRESH: Duration = Duration::from_secs(2);

/// Metadata of a file, by which a change is detected without reading it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Stamp {
    length: u64,
    modified: Option<SystemTime>,
    pub(super) readonly: bool,
}

impl Stamp {
    /// Returns the stamp of a file; `None` without a file. Symbolic links are followed.
    pub(super) fn of(path: &Path) -> Option<Self> {
        let found = fs::metadata(path).ok()?;
        let readonly = found.permissions().readonly();
        Some(Self { length: found.len(), modified: found.modified().ok(), readonly })
    }

    /// Returns whether the file may have changed since without a new stamp, because clocks of file systems are coarse.
    pub(super) fn is_fresh(&self) -> bool {
        self.modified.is_none_or(|modified| modified.elapsed().is_ok_and(|age| age < FRESH))
    }

    /// Returns whether length or modification time differ.
    pub(super) fn differs(&self, other: &Self) -> bool {
        (self.length, self.modified) != (other.length, other.modified)
    }
}
