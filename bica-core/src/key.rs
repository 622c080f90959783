//! Keys: what a tool or a test names a component by, or a parameter, an output or a modulation of one.

use crate::id::ComponentId;

/// Key of an entry of a list in the [`Graph`](crate::Graph): its name, its index, or of a component the identifier.
pub trait Key: Copy {
    /// Returns the index of the entry in a list with these names; an index is returned as it is.
    #[doc(hidden)]
    fn find(self, names: impl Iterator<Item = &'static str>) -> Option<usize>;
}

impl Key for &str {
    fn find(self, mut names: impl Iterator<Item = &'static str>) -> Option<usize> {
        names.position(|name| name == self)
    }
}

impl Key for usize {
    #[inline]
    fn find(self, _: impl Iterator<Item = &'static str>) -> Option<usize> {
        Some(self)
    }
}

impl Key for ComponentId {
    #[inline]
    fn find(self, _: impl Iterator<Item = &'static str>) -> Option<usize> {
        Some(self.index())
    }
}
