//! Steps that can be undone.

use crate::edit::Splice;

/// Most steps that are kept.
const STEPS: usize = 1000;

/// Lists of splices, each list of the text after the list before it.
type Splices = Vec<Vec<Splice>>;

/// A step.
#[derive(Clone, Debug)]
struct Step {
    forth: Splices,
    back: Splices,
    /// Number of a change of several documents of which it is a part.
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
    /// Adds a step and forgets undone ones.
    pub(super) fn push(&mut self, forth: Splices, back: Splices) {
        self.steps.truncate(self.done);
        self.steps.push(Step { forth, back, group: None });
        if self.steps.len() > STEPS {
            self.steps.remove(0);
        }
        self.done = self.steps.len();
    }

    /// Makes the last step a part of a change of several documents.
    pub(super) fn group(&mut self, group: usize) {
        if let Some(step) = self.done.checked_sub(1).and_then(|last| self.steps.get_mut(last)) {
            step.group = Some(group);
        }
    }

    /// Number of the change of several documents to which the step to undo, or to redo (`again`), belongs.
    pub(super) fn next_group(&self, again: bool) -> Option<usize> {
        let index = if again { self.done } else { self.done.checked_sub(1)? };
        self.steps.get(index)?.group
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
        Some(self.steps[self.done].back.clone())
    }

    /// The splices that redo the last undone step.
    pub(super) fn redo(&mut self) -> Option<Splices> {
        let forth = self.steps.get(self.done)?.forth.clone();
        self.done += 1;
        Some(forth)
    }
}
