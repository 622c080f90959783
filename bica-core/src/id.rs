//! Names for the components of one tree.

use core::fmt;

/// A component of a tree: its place in the tree's list, and so in [`Graph::nodes`](crate::graph::Graph::nodes).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ComponentId(u16);

impl ComponentId {
    /// The component at `index` in the tree's list.
    ///
    /// An index beyond the list names no component: a tree answers for it as for one that is never active.
    #[must_use]
    pub const fn new(index: usize) -> Self {
        Self(if index < u16::MAX as usize { index as u16 } else { u16::MAX })
    }

    /// Its place in the tree's list.
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

impl fmt::Display for ComponentId {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(out)
    }
}
