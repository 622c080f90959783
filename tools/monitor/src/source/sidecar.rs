//! The layout file beside a source.

use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use bica_vicode::draw::automatic;
use bica_vicode::model::{Model, Reporter};
use bica_vicode::{Layout, Note, Position};

use super::stamp::Stamp;
use crate::protocol::{Failed, PlacedNote, StatePosition};

/// Largest layout file, bytes.
const MAX_LAYOUT: u64 = 1 << 20;

/// Positions of the states of a file, and notes. Positions of removed states are kept, so that undo restores them.
#[derive(Default)]
pub(super) struct Sidecar {
    path: PathBuf,
    remembered: Layout,
    /// Number that increases with each change.
    revision: u64,
    /// Text of the layout file; empty without one.
    written: String,
    stamp: Option<Stamp>,
    /// Why the layout file cannot be used.
    pub(super) problem: String,
}

impl Sidecar {
    /// The layout beside a source, not read yet.
    pub(super) fn beside(source: &Path) -> Self {
        Self { path: Layout::beside(source), ..Self::default() }
    }

    /// Reads the layout file if it has changed.
    pub(super) fn look(&mut self) {
        let now = Stamp::of(&self.path);
        let same = match (&now, &self.stamp) {
            (Some(now), Some(last)) => !now.differs(last) && !now.is_fresh(),
            (None, None) => true,
            _ => false,
        };
        if !same {
            self.read();
        }
    }

    /// Reads the layout file.
    pub(super) fn read(&mut self) {
        self.stamp = Stamp::of(&self.path);
        match self.text() {
            Ok(text) if text == self.written && self.problem.is_empty() => {}
            Ok(text) => match Layout::parse(&text) {
                Ok(layout) => {
                    (self.remembered, self.written) = (layout, text);
                    self.revision += 1;
                    self.problem.clear();
                }
                Err(error) => self.problem = format!("`{}`: {error}; mend the line by hand", self.path.display()),
            },
            Err(problem) => self.problem = problem,
        }
    }

    /// Returns the text of the file; empty without one. A symbolic link is not followed, because it could lead out of the folder.
    fn text(&self) -> Result<String, String> {
        let failed = |why: &dyn std::fmt::Display| format!("`{}` cannot be read: {why}", self.path.display());
        let found = match fs::symlink_metadata(&self.path) {
            Ok(found) => found,
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(String::new()),
            Err(error) => return Err(failed(&error)),
        };
        if !found.is_file() || found.len() > MAX_LAYOUT {
            return Err(failed(&"it is no file, or above 1 MB"));
        }
        fs::read_to_string(&self.path).map_err(|error| failed(&error))
    }

    /// Returns the centres of all states.
    pub(super) fn positions(&self, model: &Model) -> Vec<StatePosition> {
        let mut positions = Vec::new();
        for component in &model.components {
            let name = &component.key;
            for (state, Position { x, y }) in component.states.iter().zip(automatic(component, &self.remembered)) {
                let state = state.function.name.text.clone();
                let placed = self.remembered.get(name, &state).is_some();
                positions.push(StatePosition { component: name.clone(), state, x, y, placed });
            }
        }
        positions
    }

    /// Returns the notes of all components.
    pub(super) fn notes(&self, model: &Model) -> Vec<PlacedNote> {
        let of = |component: &str| {
            let placed = |note: &Note| PlacedNote { component: component.to_owned(), note: note.clone() };
            self.remembered.notes(component).map(placed).collect::<Vec<_>>()
        };
        model.components.iter().flat_map(|component| of(&component.key)).collect()
    }

    /// Replaces, adds or removes a note. Returns whether the old note existed; otherwise no note is changed.
    pub(super) fn change_note(&mut self, component: &str, old: Option<&Note>, new: Option<Note>) -> bool {
        let is_there = old.is_none_or(|old| self.remembered.remove_note(component, old));
        if let Some(new) = new.filter(|_| is_there) {
            self.remembered.add_note(component, new);
        }
        self.revision += 1;
        is_there
    }

    /// Returns a number that differs after each change.
    pub(super) const fn revision(&self) -> u64 {
        self.revision
    }

    pub(super) fn set(&mut self, component: &str, state: &str, x: i32, y: i32) {
        self.revision += 1;
        self.remembered.set(component, state, Position { x, y });
    }

    pub(super) fn remove(&mut self, component: &str, state: &str) {
        self.revision += 1;
        self.remembered.remove(component, state);
    }

    /// Copies the position of a renamed state to its new name. The old name keeps it, for undo.
    pub(super) fn renamed(&mut self, component: &str, from: &str, to: &str) {
        if let Some(position) = self.remembered.get(component, from) {
            self.set(component, to, position.x, position.y);
        }
    }

    /// Returns the text that the layout file should have: lines of existing states, of notes, and of components that are not in the
    /// source. Code with a syntax error (`is_broken`) may hide states: then the lines of all states are kept.
    fn wanted(&self, model: &Model, is_broken: bool) -> String {
        // The written text is always valid.
        let mut layout = Layout::parse(&self.written).unwrap_or_default();
        let is_known = |word: &str| model.components.iter().any(|one| Layout::is_of(word, &one.key));
        layout.retain(|component, state| !is_known(component) || (is_broken && state.is_some()));
        for component in &model.components {
            for note in self.remembered.notes(&component.key) {
                layout.add_note(&component.key, note.clone());
            }
            for state in &component.states {
                let (component, state) = (&component.key, &state.function.name.text);
                if let Some(position) = self.remembered.get(component, state) {
                    layout.set(component, state, position);
                }
            }
        }
        layout.to_string()
    }

    /// Returns path and text of the layout file if it is outdated. While the source has syntax errors the file is written only
    /// after a change by a person (`force`).
    pub(super) fn plan(&self, model: &Model, force: bool) -> Result<Option<(PathBuf, String)>, Failed> {
        if !self.problem.is_empty() {
            let help = "mend the layout file by hand, or remove it";
            return if force { Err(Failed::new(self.problem.clone(), help)) } else { Ok(None) };
        }
        let is_broken = model.problems.iter().any(|problem| problem.from == Reporter::Syntax);
        let wanted = self.wanted(model, is_broken);
        let is_needed = wanted != self.written && (force || !is_broken);
        Ok(is_needed.then(|| (self.path.clone(), wanted)))
    }

    /// Stores that the layout file has this text.
    pub(super) fn wrote(&mut self, text: String) {
        self.written = text;
        self.stamp = Stamp::of(&self.path);
    }
}

/// Writes a layout file, or removes it if the text is empty.
pub(super) fn write(path: &Path, text: &str) -> Result<(), Failed> {
    let done = if text.is_empty() { fs::remove_file(path) } else { bica_vicode::save(path, text.as_bytes(), None) };
    done.map_err(|error| {
        let help = "is the disk full, or the folder write-protected? The positions are kept until the server ends";
        Failed::new(format!("the layout file `{}` was not written: {error}", path.display()), help)
    })
}
