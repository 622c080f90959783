//! Writing texts to their files.

use std::path::PathBuf;
use std::time::{Duration, Instant};

use bica_vicode::FileError;

use super::file::OpenFile;
use super::files::{Files, failed};
use super::sidecar;
use super::stamp::Stamp;
use crate::pages::{Pages, lock};
use crate::protocol::{ChangedBy, Failed};

/// Delay from the last edit to saving.
const AFTER: Duration = Duration::from_millis(500);
/// Delay after a failed attempt.
const AGAIN: Duration = Duration::from_secs(2);
/// Largest number of changes of the file that are merged in one attempt.
const MERGES: usize = 4;

/// Schedules saving for [`AFTER`] after this edit.
pub(super) fn later(file: &mut OpenFile) {
    file.save_at = Some(Instant::now() + AFTER);
}

/// Updates the state of a file after its text was written and marked as written.
pub(super) fn written(file: &mut OpenFile, pages: &Pages) {
    file.stamp = Stamp::of(&file.path);
    (file.pending, file.missed, file.deleted) = (None, 0, false);
    file.readonly = file.stamp.is_some_and(|stamp| stamp.readonly);
    file.problem.clear();
    if !file.document.is_changed() {
        file.save_at = None;
    }
    file.publish(pages, None, ChangedBy::Page, 0);
}

impl Files {
    /// Writes a text to its file, merged with changes that the file got meanwhile. A conflict, or a deleted file, prevents it.
    pub(super) fn write(&self, name: &str) -> Result<(), Failed> {
        let _disk = lock(&self.disk);
        for _ in 0..MERGES {
            let (before, text) = {
                let mut open = self.open();
                let Some(file) = open.get_mut(name) else { return Ok(()) };
                file.save_at = None;
                if file.document.conflict().is_some() || file.deleted {
                    return Ok(());
                }
                if !file.document.is_changed() {
                    drop(open);
                    return self.write_layout(name, false);
                }
                (file.document.saved().to_owned(), file.document.text().to_owned())
            };
            // `open` is not held during the write: only the saving thread waits for the disk.
            let result = self.folder.save(name, &before, &text);
            let mut open = self.open();
            let Some(file) = open.get_mut(name) else { return Ok(()) };
            match result {
                Ok(()) => {
                    file.document.mark_written(&text);
                    written(file, &self.pages);
                    if file.document.is_changed() {
                        later(file);
                    }
                    let path = file.path.clone();
                    drop(open);
                    self.wants_check(path);
                    // The text is saved; the page receives the problem with the layout.
                    let _ = self.write_layout(name, false);
                    return Ok(());
                }
                Err(FileError::Changed(theirs)) => {
                    let changed = file.external(&theirs);
                    file.stamp = None;
                    file.publish(&self.pages, changed, ChangedBy::File, 0);
                }
                Err(error) => {
                    file.deleted |= matches!(error, FileError::Missing(_));
                    file.readonly |= matches!(error, FileError::ReadOnly(_));
                    file.problem = error.to_string();
                    file.save_at = Some(Instant::now() + AGAIN);
                    file.publish(&self.pages, None, ChangedBy::File, 0);
                    return Err(failed(&error));
                }
            }
        }
        if let Some(file) = self.open().get_mut(name) {
            later(file);
        }
        Ok(())
    }

    /// Writes the layout file if it is outdated; while the source has syntax errors only with `force`.
    pub(super) fn write_layout(&self, name: &str, force: bool) -> Result<(), Failed> {
        let plan = match self.open().get(name) {
            Some(file) => file.layout.plan(file.document.model(), force)?,
            None => None,
        };
        let Some((path, text)) = plan else { return Ok(()) };
        let result = sidecar::write(&path, &text);
        let mut open = self.open();
        let Some(file) = open.get_mut(name) else { return Ok(()) };
        match &result {
            Ok(()) => file.layout.wrote(text),
            Err(failed) => file.problem.clone_from(&failed.text),
        }
        file.publish(&self.pages, None, ChangedBy::Page, 0);
        result
    }

    fn wants_check(&self, path: PathBuf) {
        if let Some(checks) = &self.checks {
            checks.want([path]);
        }
    }

    /// Writes all unsaved texts, at the end of the server. A text that cannot be saved is kept in another file.
    pub(super) fn finish(&self) {
        let names: Vec<String> = self.open().keys().cloned().collect();
        for name in names {
            // A failure is detected again below.
            let _ = self.write(&name);
            let open = self.open();
            let Some(file) = open.get(&name).filter(|file| file.document.is_changed()) else { continue };
            match keep(file) {
                Ok(path) => eprintln!("`{name}` could not be saved: its text is in `{}`", path.display()),
                Err(error) => eprintln!("`{name}` could not be saved, and its text is lost: {error}"),
            }
        }
    }
}

/// Writes a text that cannot be saved to a new file beside its own, or in the folder of temporary files.
fn keep(file: &OpenFile) -> std::io::Result<PathBuf> {
    use std::io::Write as _;
    let last = file.path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let folders = [file.path.parent().map(PathBuf::from).unwrap_or_default(), std::env::temp_dir()];
    let mut result = Err(std::io::Error::other("there are too many such files"));
    for path in folders.iter().flat_map(|folder| (1..100).map(|number| folder.join(format!("{last}.unsaved-{number}"))))
    {
        let made = std::fs::File::create_new(&path);
        match made.and_then(|mut out| out.write_all(file.document.text().as_bytes()).and_then(|()| out.sync_all())) {
            Ok(()) => return Ok(path),
            Err(error) => result = Err(error),
        }
    }
    result
}
