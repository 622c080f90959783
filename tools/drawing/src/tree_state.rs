//! State of a tree, for a drawing.

use bica_core::{ComponentId, Status, Tree};
use bica_wire::model::{Description, Link};

/// State of an activation tree after a cycle.
#[derive(Clone, Debug, PartialEq)]
pub struct TreeState<'a> {
    /// The tree.
    pub tree: &'a Description,
    /// State of each component.
    components: Vec<Status>,
}

impl<'a> TreeState<'a> {
    /// Reads the state of a robot with this description.
    #[must_use]
    pub fn of<T: Tree>(tree: &'a Description, robot: &T) -> Self {
        let components = (0..T::COUNT).filter_map(|index| robot.status(ComponentId::new(index))).collect();
        Self { tree, components }
    }

    /// Returns whether a component is active.
    #[must_use]
    pub fn is_active(&self, node: usize) -> bool {
        self.components[node].active
    }

    /// Returns the active components.
    pub fn active(&self) -> impl Iterator<Item = usize> {
        (0..self.components.len()).filter(|&node| self.is_active(node))
    }

    /// Returns whether a link is in use: its owner is active and in the state that the link belongs to.
    #[must_use]
    pub fn uses(&self, node: usize, link: &Link) -> bool {
        self.is_active(node) && (link.state.is_none() || link.state == self.components[node].state)
    }

    /// Returns the name of the state of an active state machine.
    #[must_use]
    pub fn state(&self, node: usize) -> Option<&'a str> {
        self.tree.state(node, self.components[node].state.filter(|_| self.is_active(node)))
    }
}
