//! All open files.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::{Arc, Mutex, MutexGuard};

use bica_vicode::cli::width_of;
use bica_vicode::{Document, FileError, Folder};

use super::checks::Checks;
use super::file::OpenFile;
use super::limits;
use super::stamp::Stamp;
use crate::pages::PageId;
use crate::pages::{Pages, lock};
use crate::protocol::{Failed, SourceFile};

/// All open files, each with one document for all pages.
pub(super) struct Files {
    pub(super) folder: Folder,
    pub(super) pages: Arc<Pages>,
    pub(super) checks: Option<Arc<Checks>>,
    /// Components and trees that were found in files, by name.
    pub(super) cache: Mutex<BTreeMap<String, (Stamp, Option<SourceFile>)>>,
    /// For each change of several files the names of these files.
    pub(super) groups: Mutex<Vec<Vec<String>>>,
    open: Mutex<BTreeMap<String, OpenFile>>,
    /// Held while files are compared with the disk or written, which may take long. It is never locked while `open` is held.
    pub(super) disk: Mutex<()>,
}

impl Files {
    pub(super) fn new(folder: Folder, pages: Arc<Pages>, checks: Option<Arc<Checks>>) -> Self {
        let (groups, open, disk) = (Mutex::default(), Mutex::default(), Mutex::default());
        Self { folder, pages, checks, cache: Mutex::default(), groups, open, disk }
    }

    pub(super) fn open(&self) -> MutexGuard<'_, BTreeMap<String, OpenFile>> {
        lock(&self.open)
    }

    /// Returns the open file of that name. Opens it first if necessary.
    pub(super) fn get<'a>(
        &self,
        open: &'a mut BTreeMap<String, OpenFile>,
        name: &str,
    ) -> Result<&'a mut OpenFile, Failed> {
        limits::name(name)?;
        let key = match self.folder.source(name) {
            Ok(path) => self.name_of(&path).ok_or_else(|| failed(&FileError::Outside(name.to_owned())))?,
            // The file of an open text may have been deleted.
            Err(_) if open.contains_key(name) => name.to_owned(),
            Err(error) => return Err(failed(&error)),
        };
        if !open.contains_key(&key) {
            make_room(open)?;
            let text = self.folder.read(&key).map_err(|error| failed(&error))?;
            limits::text(&text)?;
            let path = self.folder.source(&key).map_err(|error| failed(&error))?;
            let document = Document::new(&text).with_width(width_of(&path));
            open.insert(key.clone(), OpenFile::new(key.clone(), path, document));
        }
        open.get_mut(&key).ok_or_else(|| Failed::new(format!("`{key}` is not open"), "open it again"))
    }

    /// Returns the name of a path: the part below the folder, with `/` as separator.
    pub(super) fn name_of(&self, path: &Path) -> Option<String> {
        let below = path.strip_prefix(self.folder.root()).ok()?;
        let parts: Option<Vec<&str>> = below.iter().map(|part| part.to_str()).collect();
        Some(parts?.join("/"))
    }

    /// Opens a file for a page, and sends it.
    pub(super) fn show(&self, page: PageId, name: &str) -> Result<(), Failed> {
        let mut open = self.open();
        let file = self.get(&mut open, name)?;
        file.pages.insert(page);
        self.pages.state(page, file.complete());
        Ok(())
    }

    /// Ends the messages of a file to a page. Text and history are kept.
    pub(super) fn hide(&self, page: PageId, name: &str) {
        if let Some(file) = self.open().get_mut(name) {
            file.pages.remove(&page);
        }
    }

    /// Ends the messages of all files to a page.
    pub(super) fn left(&self, page: PageId) {
        for file in self.open().values_mut() {
            file.pages.remove(&page);
        }
    }
}

/// Returns the error of a request for a component that is not in the file.
pub(super) fn no_component(component: &str, help: &str) -> Failed {
    Failed::new(format!("no component `{}` is in this file", component.escape_debug()), help)
}

/// Closes an idle file if too many are open.
fn make_room(open: &mut BTreeMap<String, OpenFile>) -> Result<(), Failed> {
    if open.len() < limits::MAX_FILES {
        return Ok(());
    }
    let idle = open.values().find(|file| file.is_idle()).map(|file| file.name.clone());
    let help = "close some of them; files with unsaved changes stay open";
    let full = || Failed::new(format!("{} files are open", limits::MAX_FILES), help);
    open.remove(&idle.ok_or_else(full)?);
    Ok(())
}

/// Returns the error of a file, for pages.
pub(super) fn failed(error: &FileError) -> Failed {
    let help = match error {
        FileError::Outside(_) => "the server edits files below the folder of `--source` only",
        FileError::NoSource(_) => "choose a Rust file",
        FileError::Missing(_) | FileError::Exists(_) => "is the name right?",
        FileError::ReadOnly(_) => "nothing is lost: the text stays on the page",
        FileError::Changed(_) => "look at the change that came from the file, and save again",
        FileError::System(..) => {
            "is the disk full? Nothing is lost: the text stays on the page, and saving is tried again"
        }
    };
    Failed::new(error.to_string(), help)
}
