//! History of steps for undo and redo.

use crate::edit::Splice;

/// Largest number of kept steps.
const STEPS: usize = 1000;

/// Lists of splices; each list applies to the result of the previous one.
type Splices = Vec<Vec<Splice>>;

/// A step.
#[derive(Clone, Debug)]
struct Step {
    forth: Splices,
    back: Splices,
    /// Number of the change of several documents that it belongs to.
    group: Option<usize>,
}

/// The steps of a document.
#[derive(Clone, Debug, Default)]
pub(super) struct History {
    steps: Vec<Step>,
    /// Number of steps that are not undone.
    done: usize,
}

impl History {
    /// Adds a step; discards undone ones.
    pub(super) fn push(&mut self, forth: Splices, back: Splices) {
        self.steps.truncate(self.done);
        self.steps.push(Step { forth, back, group: None });
        if self.steps.len() > STEPS {
            self.steps.remove(0);
        }
        self.done = self.steps.len();
    }

    /// Assigns the last step to a change of several documents.
    pub(super) fn group(&mut self, group: usize) {
        if let Some(step) = self.done.checked_sub(1).and_then(|last| self.steps.get_mut(last)) {
            step.group = Some(group);
        }
    }

    /// Returns the group of the step to undo, or with `again` to redo: the number of a change of several documents.
    pub(super) fn next_group(&self, again: bool) -> Option<usize> {
        let index = if again { self.done } else { self.done.checked_sub(1)? };
        self.steps.get(index)?.group
    }

    /// Returns whether there is a step to undo.
    pub(super) const fn can_undo(&self) -> bool {
        self.done > 0
    }

    /// Returns whether there is a step to redo.
    pub(super) const fn can_redo(&self) -> bool {
        self.done < self.steps.len()
    }

    /// Returns the splices that undo the last step.
    pub(super) fn undo(&mut self) -> Option<Splices> {
        self.done = self.done.checked_sub(1)?;
        Some(self.steps[self.done].back.clone())
    }

    /// Returns the splices that redo the last undone step.
    pub(super) fn redo(&mut self) -> Option<Splices> {
        let forth = self.steps.get(self.done)?.forth.clone();
        self.done += 1;
        Some(forth)
    }
}
