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
    /// What was found in files, by name.
    pub(super) cache: Mutex<BTreeMap<String, (Stamp, Option<SourceFile>)>>,
    /// Names of the files of each change of several files.
    pub(super) groups: Mutex<Vec<Vec<String>>>,
    open: Mutex<BTreeMap<String, OpenFile>>,
    /// Held while files are compared with the disk or written, which may take long; never while `open` is held.
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

    /// Returns the open file of that name. It is opened if it is not.
    pub(super) fn get<'a>(
        &self,
        open: &'a mut BTreeMap<String, OpenFile>,
        name: &str,
    ) -> Result<&'a mut OpenFile, Failed> {
        limits::name(name)?;
        let key = match self.folder.source(name) {
            Ok(path) => self.name_of(&path).ok_or_else(|| failed(&FileError::Outside(name.to_owned())))?,
            // The file of an open text may be gone.
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

    /// The name of a path below the folder, with `/` between its parts.
    pub(super) fn name_of(&self, path: &Path) -> Option<String> {
        let below = path.strip_prefix(self.folder.root()).ok()?;
        let parts: Option<Vec<&str>> = below.iter().map(|part| part.to_str()).collect();
        Some(parts?.join("/"))
    }

    /// Lets a page see a file.
    pub(super) fn show(&self, page: PageId, name: &str) -> Result<(), Failed> {
        let mut open = self.open();
        let file = self.get(&mut open, name)?;
        file.pages.insert(page);
        self.pages.state(page, file.complete());
        Ok(())
    }

    /// Ends what a page sees of a file. The text stays with its history.
    pub(super) fn hide(&self, page: PageId, name: &str) {
        if let Some(file) = self.open().get_mut(name) {
            file.pages.remove(&page);
        }
    }

    /// Ends all that a page sees.
    pub(super) fn left(&self, page: PageId) {
        for file in self.open().values_mut() {
            file.pages.remove(&page);
        }
    }
}

/// A request that names a component which is not in the file.
pub(super) fn no_component(component: &str, help: &str) -> Failed {
    Failed::new(format!("no component `{}` is in this file", component.escape_debug()), help)
}

/// Forgets a file that nobody needs if too many are open.
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

/// The error of a file as a page gets it.
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
