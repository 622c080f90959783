//! State of a tree, for a drawing.

use bica_wire::model::{Description, Link};

/// State of an activation tree after a cycle.
#[derive(Clone, Debug, PartialEq)]
pub struct TreeState<'a> {
    /// The tree.
    pub tree: &'a Description,
    /// Whether each component is active.
    pub active: Vec<bool>,
    /// State of each state machine.
    pub states: Vec<Option<usize>>,
}

impl<'a> TreeState<'a> {
    /// Returns whether a link is in use: its owner is active and in the state that the link belongs to.
    #[must_use]
    pub fn uses(&self, node: usize, link: &Link) -> bool {
        self.active[node] && (link.state.is_none() || link.state == self.states[node])
    }

    /// Returns the name of the state of an active state machine.
    #[must_use]
    pub fn state(&self, node: usize) -> Option<&'a str> {
        self.tree.state(node, self.states[node].filter(|_| self.active[node]))
    }
}
