//! An open source file: text, model, history, and its version on disk.

mod history;
mod merge;
mod words;

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use self::history::History;
pub use self::merge::Conflict;
use self::merge::merge;
use self::words::difference;
use crate::edit::{DEFAULT_WIDTH, Edit, Refusal, Splice, applied, inverse, plan};
use crate::model::Model;
use crate::read::read;

/// An open source file. Canvas and code are views of its text, with one history.
#[derive(Clone, Debug)]
pub struct Document {
    text: Arc<str>,
    model: Arc<Model>,
    version: u64,
    history: History,
    /// Text of the file when it was last read or written.
    saved: Arc<str>,
    conflict: Option<Conflict>,
    width: usize,
}

/// A change that was made.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Change {
    /// Version of the text after it.
    pub version: u64,
    /// Lists of splices; each list applies to the result of the previous one.
    pub splices: Vec<Vec<Splice>>,
}

/// Result of a change of the file on disk.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "external", rename_all = "snake_case")]
pub enum External {
    /// The document has the same text already.
    Same,
    /// Both changes are merged in the document.
    Merged(Change),
    /// Both changed the same part. The document keeps its text until one version is chosen.
    Conflict(Conflict),
}

/// Choice that ends a conflict.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Keep {
    /// Text of the document.
    Ours,
    /// Text of the file.
    Theirs,
    /// A text that merges both.
    Text(String),
}

impl Document {
    /// Creates a document of a file's text.
    #[must_use]
    pub fn new(text: &str) -> Self {
        let model = Arc::new(read(text));
        let text: Arc<str> = text.into();
        Self {
            saved: Arc::clone(&text),
            text,
            model,
            version: 0,
            history: History::default(),
            conflict: None,
            width: DEFAULT_WIDTH,
        }
    }

    /// Sets the maximum line length of new code, characters.
    #[must_use]
    pub const fn with_width(mut self, width: usize) -> Self {
        self.width = width;
        self
    }

    /// Returns the text.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Returns the model of the text.
    #[must_use]
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// Returns the version of the text. Each change increases it, also undo and redo.
    #[must_use]
    pub const fn version(&self) -> u64 {
        self.version
    }

    /// Returns whether the text differs from the file.
    #[must_use]
    pub fn is_changed(&self) -> bool {
        self.text != self.saved
    }

    /// Text of the file when it was last read or written.
    #[must_use]
    pub fn saved(&self) -> &str {
        &self.saved
    }

    /// Returns the open conflict.
    #[must_use]
    pub const fn conflict(&self) -> Option<&Conflict> {
        self.conflict.as_ref()
    }

    /// Applies edits as one step of the history: all or none.
    ///
    /// # Errors
    /// If one of them is not possible. Nothing is changed then.
    pub fn apply(&mut self, edits: &[Edit]) -> Result<Change, Refusal> {
        let (mut text, mut model) = (self.text.to_string(), None);
        let (mut all, mut back) = (Vec::new(), Vec::new());
        for edit in edits {
            let before: &Model = model.as_ref().unwrap_or(&self.model);
            let (splices, after, changed) = plan(&text, before, edit, self.width)?;
            back.push(inverse(&text, &splices));
            all.push(splices);
            (text, model) = (after, Some(changed));
        }
        if text == *self.text {
            return Ok(Change { version: self.version, splices: Vec::new() });
        }
        back.reverse();
        self.history.push(all.clone(), back);
        Ok(self.changed(text, model, all))
    }

    /// Assigns the last step to the change `group` of several documents.
    pub fn group(&mut self, group: usize) {
        self.history.group(group);
    }

    /// Returns the group of the step to undo, or with `again` to redo: the number of a change of several documents.
    #[must_use]
    pub fn next_group(&self, again: bool) -> Option<usize> {
        self.history.next_group(again)
    }

    /// Undoes the last step; returns `None` without one.
    pub fn undo(&mut self) -> Option<Change> {
        let splices = self.history.undo()?;
        Some(self.replay(splices))
    }

    /// Returns whether there is a step to undo.
    #[must_use]
    pub const fn can_undo(&self) -> bool {
        self.history.can_undo()
    }

    /// Returns whether there is a step to redo.
    #[must_use]
    pub const fn can_redo(&self) -> bool {
        self.history.can_redo()
    }

    /// Redoes the last undone step; returns `None` without one.
    pub fn redo(&mut self) -> Option<Change> {
        let splices = self.history.redo()?;
        Some(self.replay(splices))
    }

    /// Merges a change of the file on disk, as a step of the history.
    pub fn external_change(&mut self, theirs: &str) -> External {
        if let Some(conflict) = &mut self.conflict {
            theirs.clone_into(&mut conflict.theirs);
            if *theirs == *self.saved {
                // The file has its former text again.
                self.conflict = None;
                return External::Same;
            }
        } else if *theirs == *self.saved {
            return External::Same;
        }
        match merge(&self.saved, &self.text, theirs) {
            Ok(text) => {
                self.conflict = None;
                self.saved = theirs.into();
                if text == *self.text { External::Same } else { External::Merged(self.replace(text)) }
            }
            Err(conflict) => {
                self.conflict = Some(conflict.clone());
                External::Conflict(conflict)
            }
        }
    }

    /// Ends the conflict; returns `None` without one.
    pub fn resolve(&mut self, keep: Keep) -> Option<Change> {
        let conflict = self.conflict.take()?;
        self.saved = conflict.theirs.as_str().into();
        Some(match keep {
            Keep::Ours => {
                // Two steps that lead to the other text and back: undoing the choice shows the text of the file.
                let splices = difference(&self.text, &conflict.theirs);
                let back = inverse(&self.text, &splices);
                self.history.push(vec![splices.clone()], vec![back.clone()]);
                self.history.push(vec![back], vec![splices]);
                Change { version: self.version, splices: Vec::new() }
            }
            Keep::Theirs => self.replace(conflict.theirs),
            Keep::Text(text) => self.replace(text),
        })
    }

    /// Records that `text`, a former or the current text, was written to the file.
    pub fn mark_written(&mut self, text: &str) {
        self.saved = if *text == *self.text { Arc::clone(&self.text) } else { text.into() };
    }

    /// Replaces the text as one step of the history.
    fn replace(&mut self, text: String) -> Change {
        let splices = difference(&self.text, &text);
        if splices.is_empty() {
            return Change { version: self.version, splices: Vec::new() };
        }
        self.history.push(vec![splices.clone()], vec![inverse(&self.text, &splices)]);
        self.changed(text, None, vec![splices])
    }

    fn replay(&mut self, splices: Vec<Vec<Splice>>) -> Change {
        let text = splices.iter().fold(self.text.to_string(), |text, step| applied(&text, step));
        self.changed(text, None, splices)
    }

    fn changed(&mut self, text: String, model: Option<Model>, splices: Vec<Vec<Splice>>) -> Change {
        self.model = Arc::new(model.unwrap_or_else(|| read(&text)));
        self.text = text.into();
        self.version += 1;
        Change { version: self.version, splices }
    }
}
