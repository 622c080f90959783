//! A set of indices.

use super::CAPACITY;

const BITS: usize = u128::BITS as usize;

/// A set of components, or of states, by their index, each below [`CAPACITY`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Set {
    words: [u128; CAPACITY.div_ceil(BITS)],
}

impl Set {
    /// The set of nothing.
    pub const EMPTY: Self = Self { words: [0; CAPACITY.div_ceil(BITS)] };

    /// Whether an index is in the set.
    ///
    /// # Panics
    /// If the index is above [`CAPACITY`].
    #[must_use]
    pub const fn contains(&self, index: usize) -> bool {
        self.words[index / BITS] >> (index % BITS) & 1 == 1
    }

    /// The set with one index more.
    ///
    /// # Panics
    /// If the index is above [`CAPACITY`].
    #[must_use]
    pub const fn with(mut self, index: usize) -> Self {
        self.words[index / BITS] |= 1 << (index % BITS);
        self
    }

    /// What is in either of two sets.
    #[must_use]
    pub const fn union(self, other: Self) -> Self {
        Self { words: [self.words[0] | other.words[0], self.words[1] | other.words[1]] }
    }

    /// Whether nothing is in the set.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.words[0] | self.words[1] == 0
    }
}
