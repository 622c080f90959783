//! Changes of the files by other programs.

use std::sync::{Arc, Condvar, Mutex};
use std::time::{Duration, Instant};

use bica_vicode::FileError;

use super::file::OpenFile;
use super::files::Files;
use super::stamp::Stamp;
use super::{limits, save};
use crate::pages::lock;
use crate::protocol::ChangedBy;

/// Interval of checks for files that are due to be saved.
const TICK: Duration = Duration::from_millis(100);
/// Number of [`TICK`]s between two comparisons of the files with the disk.
const TICKS: u32 = 2;

/// Flag that ends a waiting thread.
#[derive(Default)]
pub(super) struct End {
    ended: Mutex<bool>,
    changed: Condvar,
}

impl End {
    pub(super) fn now(&self) {
        *lock(&self.ended) = true;
        self.changed.notify_all();
    }

    /// Waits for a time or for the end; returns whether the end has come.
    fn wait(&self, time: Duration) -> bool {
        let guard = lock(&self.ended);
        let waited = self.changed.wait_timeout_while(guard, time, |ended| !*ended);
        *waited.unwrap_or_else(std::sync::PoisonError::into_inner).0
    }
}

/// Saves the files and compares them with the disk, until the end.
pub(super) fn watch(files: &Arc<Files>, end: &End) {
    let mut tick = 0_u32;
    while !end.wait(TICK) {
        tick = tick.wrapping_add(1);
        let (mut due, mut names) = (Vec::new(), Vec::new());
        {
            let now = Instant::now();
            for file in files.open().values() {
                if file.save_at.is_some_and(|at| at <= now) {
                    due.push(file.name.clone());
                }
                // An unchanged file that no page shows is read again before it is written.
                if !file.pages.is_empty() || file.document.is_changed() {
                    names.push(file.name.clone());
                }
            }
        }
        for name in due {
            // The page receives the problem with the file.
            let _ = files.write(&name);
        }
        if tick.is_multiple_of(TICKS) {
            for name in names {
                files.look(&name);
            }
        }
    }
}

impl Files {
    /// Compares a file with the disk, and merges a change.
    pub(super) fn look(&self, name: &str) {
        let _disk = lock(&self.disk);
        let path = {
            let mut open = self.open();
            let Some(file) = open.get_mut(name) else { return };
            file.layout.look();
            file.path.clone()
        };
        let found = Stamp::of(&path);
        let must_read = match self.open().get_mut(name) {
            Some(file) => must_read(file, found),
            None => false,
        };
        let read = must_read.then(|| self.folder.read(name));
        let mut open = self.open();
        let Some(file) = open.get_mut(name) else { return };
        let mut changed = None;
        match read {
            None => {}
            Some(Ok(text)) => {
                (file.stamp, file.pending, file.deleted) = (found, None, false);
                if let Err(failed) = limits::text(&text) {
                    file.problem = failed.text;
                } else if is_news(file, &text) {
                    changed = file.external(&text);
                } else if file.readonly == found.is_some_and(|stamp| stamp.readonly) && file.save_at.is_none() {
                    file.problem.clear();
                }
            }
            Some(Err(FileError::Missing(_))) => file.missed += 1,
            Some(Err(error)) => {
                (file.stamp, file.pending) = (found, None);
                file.problem = error.to_string();
            }
        }
        if file.document.is_changed() && file.save_at.is_none() {
            save::later(file);
        }
        if let Some(stamp) = found
            && file.readonly != stamp.readonly
        {
            file.readonly = stamp.readonly;
            file.problem.clear();
        }
        file.publish(&self.pages, changed, ChangedBy::File, 0);
    }
}

/// Returns whether the file must be reread: it changed, and writing has finished; its last change is too recent to exclude another
/// one; or the text changed during a conflict.
fn must_read(file: &mut OpenFile, found: Option<Stamp>) -> bool {
    let Some(stamp) = found else {
        file.missed += 1;
        // Editors remove a file for a moment when they replace it.
        file.deleted |= file.missed >= 2;
        return false;
    };
    file.missed = 0;
    let is_new = file.deleted || file.stamp.is_none_or(|last| last.differs(&stamp));
    if is_new {
        // A program may still be writing: the file is read when two successive comparisons have found the same stamp.
        let settled = file.pending.is_some_and(|pending| !pending.differs(&stamp));
        file.pending = Some(stamp);
        return settled;
    }
    stamp.is_fresh() || (file.document.conflict().is_some() && file.merged != file.document.version())
}

/// Returns whether the text of the file must be merged: it is new, or the open text has changed since the last merge during a conflict.
fn is_news(file: &OpenFile, text: &str) -> bool {
    match file.document.conflict() {
        Some(conflict) => conflict.theirs != text || file.merged != file.document.version(),
        None => text != file.document.saved(),
    }
}
