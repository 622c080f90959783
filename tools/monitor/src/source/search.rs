//! Files below the folder of sources.

use std::fs;
use std::path::{Path, PathBuf};

use bica_vicode::model::{Model, Span};
use bica_vicode::{Target, read, trees, uses};

use super::files::{Files, failed, no_component};
use super::limits;
use super::stamp::Stamp;
use crate::pages::lock;
use crate::protocol::{Failed, SourceComponent, SourceFile, SourceTable, SourceUse};

/// Largest number of Rust files that are read.
const MAX_SOURCES: usize = 10_000;
/// Deepest folder that is searched.
const MAX_DEPTH: usize = 24;
/// Largest number of uses that are listed.
const MAX_USES: usize = 1000;

/// Collects all Rust files below a folder, sorted. Symbolic links, hidden files and folders, and folders of builds are left out.
fn walk(folder: &Path, depth: usize, found: &mut Vec<PathBuf>) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    let mut entries: Vec<fs::DirEntry> = entries.filter_map(Result::ok).collect();
    entries.sort_by_key(fs::DirEntry::file_name);
    for entry in entries {
        let (name, path) = (entry.file_name(), entry.path());
        let is_left_out = name.to_string_lossy().starts_with('.') || name == "target" || name == "node_modules";
        let Ok(kind) = entry.file_type() else { continue };
        if found.len() >= MAX_SOURCES || is_left_out {
            continue;
        }
        if kind.is_dir() && depth < MAX_DEPTH {
            walk(&path, depth + 1, found);
        } else if kind.is_file() && path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
}

impl Files {
    /// Returns the names of all Rust files, with their stamps.
    pub(super) fn all(&self) -> Vec<(String, Stamp)> {
        let mut paths = Vec::new();
        walk(self.folder.root(), 0, &mut paths);
        paths.iter().filter_map(|path| Some((self.name_of(path)?, Stamp::of(path)?))).collect()
    }

    /// Returns the text of a file; if the file is open, that of the pages.
    pub(super) fn text(&self, name: &str) -> Result<String, Failed> {
        if let Some(file) = self.open().get(name) {
            return Ok(file.document.text().to_owned());
        }
        let text = self.folder.read(name).map_err(|error| failed(&error))?;
        limits::text(&text).map(|()| text)
    }

    /// Lists the files with components or trees, and those that cannot be read.
    pub(super) fn sources(&self) -> Vec<SourceFile> {
        let mut cache = lock(&self.cache);
        let mut old = std::mem::take(&mut *cache);
        let mut list = Vec::new();
        for (name, stamp) in self.all() {
            let is_open = self.open().contains_key(&name);
            let known = old.remove(&name).filter(|(last, _)| !is_open && !last.differs(&stamp) && !stamp.is_fresh());
            let entry = known.map_or_else(|| self.source(&name), |(_, entry)| entry);
            list.extend(entry.clone());
            cache.insert(name, (stamp, entry));
        }
        list
    }

    fn source(&self, name: &str) -> Option<SourceFile> {
        let file = name.to_owned();
        let text = match self.text(name) {
            Ok(text) => text,
            Err(failed) => {
                let (components, trees) = (Vec::new(), Vec::new());
                return Some(SourceFile { file, components, trees, problem: Some(failed.text) });
            }
        };
        let trees = trees(&text).into_iter().map(|tree| tree.name).collect::<Vec<_>>();
        let components = if text.contains("component") { components(&read(&text)) } else { Vec::new() };
        (!components.is_empty() || !trees.is_empty()).then_some(SourceFile { file, components, trees, problem: None })
    }

    /// Lists the tables of constants whose rows have one of these types. Files that cannot be read are left out.
    pub(super) fn tables(&self, types: &[String]) -> Vec<SourceTable> {
        let mut list = Vec::new();
        for (file, _) in self.all() {
            let Ok(text) = self.text(&file) else { continue };
            if !types.iter().any(|ty| text.contains(&**ty)) {
                continue;
            }
            let tables = read(&text).tables.into_iter().filter(|table| types.contains(&table.ty));
            list.extend(tables.map(|table| {
                let first = table.rows.first().into_iter().flat_map(|row| &row.cells);
                let cells = first.map(|cell| cell.name.clone()).collect();
                SourceTable { file: file.clone(), key: table.key, ty: table.ty, cells }
            }));
        }
        list
    }

    /// Lists the uses of a function in other files. Uncertain uses of a private function are left out.
    pub(super) fn uses(&self, name: &str, component: &str, function: &str) -> Result<Vec<SourceUse>, Failed> {
        let (own, text, found) = {
            let mut open = self.open();
            let file = self.get(&mut open, name)?;
            let found = file.document.model().component(component);
            let found = found.ok_or_else(|| no_component(component, "open the file that has it"))?;
            (file.name.clone(), file.document.text().to_owned(), found.clone())
        };
        let none = || {
            let what = format!("`{component}` has no function `{}`", function.escape_debug());
            Failed::new(what, "it may have been renamed")
        };
        let start = found.function(function).ok_or_else(none)?.name.span.start;
        let is_public = text[..start].lines().last().is_some_and(|line| line.contains("pub"));
        let simple = |name: &str| name.split('<').next().map(str::to_owned);
        let mut others = self.sources().into_iter().filter(|file| file.file != own);
        let has_namesakes =
            others.any(|file| file.components.iter().any(|one| simple(&one.name) == simple(&found.name.text)));
        let target = Target::new(&text, &found, has_namesakes);
        let mut list = Vec::new();
        for (file, _) in self.all().into_iter().filter(|(file, _)| *file != own) {
            let Ok(text) = self.text(&file) else { continue };
            if !text.contains(function) {
                continue;
            }
            for found in uses(&text, &target, function, false).into_iter().filter(|one| one.certain || is_public) {
                list.push(use_at(&file, &text, found.span, found.certain));
                if list.len() >= MAX_USES {
                    return Ok(list);
                }
            }
        }
        Ok(list)
    }
}

/// Returns the use at a span of a file.
pub(super) fn use_at(file: &str, text: &str, span: Span, certain: bool) -> SourceUse {
    let begin = text[..span.start].rfind('\n').map_or(0, |newline| newline + 1);
    let line = 1 + text[..begin].matches('\n').count();
    let shown = text[begin..].lines().next().unwrap_or_default().trim().to_owned();
    SourceUse { file: file.to_owned(), line, span, text: shown, certain }
}

fn components(model: &Model) -> Vec<SourceComponent> {
    let one = |component: &bica_vicode::model::Component| SourceComponent {
        key: component.key.clone(),
        name: component.name.text.clone(),
        machine: component.is_machine(),
    };
    model.components.iter().map(one).collect()
}
