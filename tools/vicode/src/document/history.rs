//! Steps that can be undone.

use crate::edit::Splice;

/// Most steps that are kept.
const STEPS: usize = 1000;

/// Lists of splices, each list of the text after the list before it.
type Splices = Vec<Vec<Splice>>;

/// The steps of a document.
#[derive(Clone, Debug, Default)]
pub(super) struct History {
    /// Forth and back.
    steps: Vec<(Splices, Splices)>,
    /// Number of steps that are not undone.
    done: usize,
}

impl History {
    /// Adds a step. Undone ones cannot be made again.
    pub(super) fn push(&mut self, forth: Splices, back: Splices) {
        self.steps.truncate(self.done);
        self.steps.push((forth, back));
        if self.steps.len() > STEPS {
            self.steps.remove(0);
        }
        self.done = self.steps.len();
    }

    /// Whether there is a step to undo.
    pub(super) const fn can_undo(&self) -> bool {
        self.done > 0
    }

    /// Whether there is a step to make again.
    pub(super) const fn can_redo(&self) -> bool {
        self.done < self.steps.len()
    }

    /// The splices that undo the last step.
    pub(super) fn undo(&mut self) -> Option<Splices> {
        self.done = self.done.checked_sub(1)?;
        Some(self.steps[self.done].1.clone())
    }

    /// The splices that make the last undone step again.
    pub(super) fn redo(&mut self) -> Option<Splices> {
        let (forth, _) = self.steps.get(self.done)?;
        self.done += 1;
        Some(forth.clone())
    }
}
