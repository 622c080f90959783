//! A list of components.

use super::CAPACITY;

/// A list of components by their index in [`Graph::nodes`](crate::graph::Graph::nodes).
#[derive(Clone, Copy, Debug)]
pub struct Path {
    items: [u16; CAPACITY + 1],
    len: usize,
}

impl Path {
    pub(super) const EMPTY: Self = Self { items: [0; CAPACITY + 1], len: 0 };

    pub(super) const fn push(&mut self, index: usize) {
        self.items[self.len] = index as u16;
        self.len += 1;
    }

    /// How many entries the list has.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.len
    }

    /// Whether the list has no entry.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// The component at a place.
    ///
    /// # Panics
    /// If `place` is not below [`len`](Self::len).
    #[must_use]
    pub const fn get(&self, place: usize) -> usize {
        assert!(place < self.len, "a path has no entry behind its end");
        self.items[place] as usize
    }

    /// The components in order.
    pub fn iter(&self) -> impl Iterator<Item = usize> {
        self.items[..self.len].iter().map(|&index| usize::from(index))
    }
}

impl PartialEq for Path {
    fn eq(&self, other: &Self) -> bool {
        self.iter().eq(other.iter())
    }
}
