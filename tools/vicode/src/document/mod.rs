//! A file that is open: its text, its model, its history, and the file on disk beside it.

mod history;
mod merge;
mod words;

use std::sync::Arc;

use serde::Serialize;

use self::history::History;
pub use self::merge::Conflict;
use self::merge::merge;
use self::words::difference;
use crate::edit::{Edit, Refusal, Splice, applied, inverse, plan};
use crate::model::Model;
use crate::read::read;

/// The longest line that `rustfmt` writes without a configuration.
pub const DEFAULT_WIDTH: usize = 100;

/// A file that is open. Canvas and code are two views of its one text, with one history.
#[derive(Clone, Debug)]
pub struct Document {
    text: Arc<str>,
    model: Arc<Model>,
    version: u64,
    history: History,
    /// The text of the file when it was last read or written.
    saved: Arc<str>,
    conflict: Option<Conflict>,
    width: usize,
}

/// A change of the text that was made.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Change {
    /// Version of the text after it.
    pub version: u64,
    /// Replacements, each list of the text after the list before it.
    pub splices: Vec<Vec<Splice>>,
}

/// What a change of the file on disk led to.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "external", rename_all = "snake_case")]
pub enum External {
    /// The text already equals the file.
    Same,
    /// The text has both sides' changes now.
    Merged(Change),
    /// Both sides changed the same part. The text stays as it was until one of them is chosen.
    Conflict(Conflict),
}

/// Which text to keep.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Keep {
    /// The text of this document.
    Ours,
    /// The text of the file.
    Theirs,
    /// A text made of both.
    Text(String),
}

impl Document {
    /// Opens a text as the file has it.
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

    /// The same with lines of new code of at most `width` characters.
    #[must_use]
    pub const fn with_width(mut self, width: usize) -> Self {
        self.width = width;
        self
    }

    /// The text.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The model of the text.
    #[must_use]
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// The version of the text: it grows with each change, undone ones too.
    #[must_use]
    pub const fn version(&self) -> u64 {
        self.version
    }

    /// Whether the text differs from the file.
    #[must_use]
    pub fn is_changed(&self) -> bool {
        self.text != self.saved
    }

    /// The text of the file when it was last read or written.
    #[must_use]
    pub fn saved(&self) -> &str {
        &self.saved
    }

    /// The conflict that is open.
    #[must_use]
    pub const fn conflict(&self) -> Option<&Conflict> {
        self.conflict.as_ref()
    }

    /// Applies edits as one step of the history: all or none.
    ///
    /// # Errors
    /// If one of them is not possible. Nothing has changed then.
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

    /// Makes the last step a part of a change of several documents, whose number is `group`.
    pub fn group(&mut self, group: usize) {
        self.history.group(group);
    }

    /// Number of the change of several documents to which the step to undo, or to redo (`again`), belongs.
    #[must_use]
    pub fn next_group(&self, again: bool) -> Option<usize> {
        self.history.next_group(again)
    }

    /// Undoes the last step; `None` without one.
    pub fn undo(&mut self) -> Option<Change> {
        let splices = self.history.undo()?;
        Some(self.replay(splices))
    }

    /// Whether there is a step to undo.
    #[must_use]
    pub const fn can_undo(&self) -> bool {
        self.history.can_undo()
    }

    /// Whether there is a step to redo.
    #[must_use]
    pub const fn can_redo(&self) -> bool {
        self.history.can_redo()
    }

    /// Redoes the last undone step; `None` without one.
    pub fn redo(&mut self) -> Option<Change> {
        let splices = self.history.redo()?;
        Some(self.replay(splices))
    }

    /// Takes over a change of the file on disk. It is a step of the history.
    pub fn external_change(&mut self, theirs: &str) -> External {
        if let Some(conflict) = &mut self.conflict {
            theirs.clone_into(&mut conflict.theirs);
            if *theirs == *self.saved {
                // The other side took its change back.
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

    /// Ends a conflict; `None` without one.
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

    /// Notes that the file has `text` now, which was the text of this document when it was written.
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
