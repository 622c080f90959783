//! Identifiers of the components of one tree.

use core::fmt;

/// Identifier of a component: its index in the tree's list, and so in [`Graph::nodes`](crate::graph::Graph::nodes).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "wire", derive(serde::Serialize, serde::Deserialize, postcard_schema::Schema))]
pub struct ComponentId(u16);

impl ComponentId {
    /// Returns the identifier of the component at `index` in the tree's list.
    ///
    /// An index beyond the list identifies no component: a tree reports it as never active.
    #[must_use]
    pub const fn new(index: usize) -> Self {
        Self(if index < u16::MAX as usize { index as u16 } else { u16::MAX })
    }

    /// Returns the index in the tree's list.
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
