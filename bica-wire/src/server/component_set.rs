//! A set of components.

use bica_core::ComponentId;
use bica_core::check::CAPACITY;

const BITS: usize = u32::BITS as usize;

/// A set of components of one tree, by their indices.
#[derive(Clone, Copy, Debug)]
pub(super) struct ComponentSet {
    words: [u32; CAPACITY.div_ceil(BITS)],
}

impl ComponentSet {
    pub(super) const EMPTY: Self = Self { words: [0; CAPACITY.div_ceil(BITS)] };

    /// Adds or removes a component. An index that no tree has is left out.
    pub(super) fn set(&mut self, component: ComponentId, is_member: bool) {
        let index = component.index();
        let Some(word) = self.words.get_mut(index / BITS) else { return };
        let bit = 1 << (index % BITS);
        *word = if is_member { *word | bit } else { *word & !bit };
    }

    /// Adds all components of another set, which is then empty.
    pub(super) fn take_all(&mut self, other: &mut Self) {
        for (word, more) in self.words.iter_mut().zip(&mut other.words) {
            *word |= core::mem::take(more);
        }
    }

    /// Returns the component with the smallest index.
    pub(super) fn first(&self) -> Option<ComponentId> {
        let (index, word) = self.words.iter().enumerate().find(|(_, word)| **word != 0)?;
        Some(ComponentId::new(index * BITS + word.trailing_zeros() as usize))
    }

    /// Removes and returns the component with the smallest index.
    pub(super) fn pop(&mut self) -> Option<ComponentId> {
        let first = self.first()?;
        self.set(first, false);
        Some(first)
    }
}
