//! An open file.

use std::collections::BTreeSet;
use std::path::PathBuf;
use std::time::Instant;

use bica_vicode::{Change, Document, External};

use super::sidecar::Sidecar;
use super::stamp::Stamp;
use crate::pages::PageId;
use crate::pages::Pages;
use crate::protocol::{ChangedBy, Drawn, FileState, SourceChange, SourceState, ToPage};

/// An open file, shared by all pages.
pub(super) struct OpenFile {
    /// Path below the folder of sources.
    pub(super) name: String,
    /// Path with all symbolic links followed.
    pub(super) path: PathBuf,
    pub(super) document: Document,
    pub(super) layout: Sidecar,
    /// Pages that receive its messages.
    pub(super) pages: BTreeSet<PageId>,
    /// Stamp of the file when it was read or written last.
    pub(super) stamp: Option<Stamp>,
    /// Stamp of a change that may not be complete yet.
    pub(super) pending: Option<Stamp>,
    /// Version of the text at the last merge with the file.
    pub(super) merged: u64,
    /// Number of successive comparisons with the disk that did not find the file.
    pub(super) missed: u32,
    pub(super) readonly: bool,
    pub(super) deleted: bool,
    /// Why the file cannot be read or written; empty if there is no problem.
    pub(super) problem: String,
    /// Time at which the file is saved; none if no save is scheduled.
    pub(super) save_at: Option<Instant>,
    /// State and drawing that were sent last.
    sent: (FileState, Drawn),
    /// Cached drawing, with the version of the text and the revision of the layout: it is needed in each comparison with the disk.
    drawn: Option<((u64, u64), Drawn)>,
}

/// A change of the text with the version before it.
pub(super) type Changed = Option<(u64, Change)>;

impl OpenFile {
    pub(super) fn new(name: String, path: PathBuf, document: Document) -> Self {
        let stamp = Stamp::of(&path);
        let mut file = Self {
            layout: Sidecar::beside(&path),
            readonly: stamp.is_some_and(|stamp| stamp.readonly),
            name,
            path,
            document,
            pages: BTreeSet::new(),
            stamp,
            pending: None,
            merged: 0,
            missed: 0,
            deleted: false,
            problem: String::new(),
            save_at: None,
            sent: <(FileState, Drawn)>::default(),
            drawn: None,
        };
        file.layout.read();
        file.sent = (file.state(), file.drawn().clone());
        file
    }

    /// Returns the state of the file on disk, for pages.
    pub(super) fn state(&self) -> FileState {
        let conflict = self.document.conflict().map(|conflict| bica_vicode::Conflict {
            // The text may have been edited since.
            ours: self.document.text().to_owned(),
            ..conflict.clone()
        });
        let problem = if self.problem.is_empty() { self.layout.problem.clone() } else { self.problem.clone() };
        FileState {
            saved: !self.document.is_changed() && !self.deleted && conflict.is_none(),
            readonly: self.readonly,
            deleted: self.deleted,
            problem,
            conflict,
            undo: self.document.can_undo(),
            redo: self.document.can_redo(),
        }
    }

    /// Returns the centres of all states, and notes.
    pub(super) fn drawn(&mut self) -> &Drawn {
        let key = (self.document.version(), self.layout.revision());
        let known = self.drawn.take().filter(|(of, _)| *of == key);
        let make = || {
            let model = self.document.model();
            (key, Drawn { positions: self.layout.positions(model), notes: self.layout.notes(model) })
        };
        let drawn = known.unwrap_or_else(make);
        &self.drawn.insert(drawn).1
    }

    /// Returns the message with the complete file.
    pub(super) fn complete(&mut self) -> ToPage {
        let drawn = self.drawn().clone();
        ToPage::Source(Box::new(SourceState {
            file: self.name.clone(),
            version: self.document.version(),
            text: self.document.text().to_owned(),
            model: self.document.model().clone(),
            drawn,
            state: self.state(),
        }))
    }

    /// Sends changes of text, drawing and state to the pages of the file.
    pub(super) fn publish(&mut self, pages: &Pages, changed: Changed, by: ChangedBy, page: PageId) {
        let version = self.document.version();
        let (from_version, splices) = changed.map_or((version, Vec::new()), |(from, change)| (from, change.splices));
        let state = self.state();
        let now = (state, self.drawn().clone());
        if from_version == version && now == self.sent {
            return;
        }
        let message = ToPage::SourceChanged(Box::new(SourceChange {
            file: self.name.clone(),
            version,
            from_version,
            splices,
            model: (from_version != version).then(|| self.document.model().clone()),
            drawn: now.1.clone(),
            state: now.0.clone(),
            by,
            page,
        }));
        self.sent = now;
        for &one in &self.pages {
            pages.state(one, message.clone());
        }
    }

    /// Merges the text that the file has now.
    pub(super) fn external(&mut self, text: &str) -> Changed {
        let from = self.document.version();
        self.problem.clear();
        let external = self.document.external_change(text);
        self.merged = self.document.version();
        match external {
            External::Merged(change) => Some((from, change)),
            External::Same | External::Conflict(_) => None,
        }
    }

    /// Returns whether the file can be closed: no page shows it, its text is saved, and there is no conflict.
    pub(super) fn is_idle(&self) -> bool {
        self.pages.is_empty() && !self.document.is_changed() && self.document.conflict().is_none()
    }
}
