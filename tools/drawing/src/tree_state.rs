//! State of a tree, for a drawing.

use bica::graph::{Graph, Link};

/// State of an activation tree after a cycle.
#[derive(Clone, Debug, PartialEq)]
pub struct TreeState {
    /// The tree.
    pub graph: &'static Graph,
    /// Whether each component is active.
    pub active: Vec<bool>,
    /// State of each state machine.
    pub states: Vec<Option<usize>>,
}

impl TreeState {
    /// Returns whether a link is in use: its owner is active and in the state that the link belongs to.
    #[must_use]
    pub fn uses(&self, node: usize, link: &Link) -> bool {
        self.active[node] && (link.state.is_none() || link.state == self.states[node])
    }

    /// Returns the name of the state of an active state machine.
    #[must_use]
    pub fn state(&self, node: usize) -> Option<&'static str> {
        let state = self.states[node].filter(|_| self.active[node])?;
        self.graph.nodes[node].states.get(state).map(|state| state.name)
    }
}
