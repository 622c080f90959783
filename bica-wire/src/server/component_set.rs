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

    /// Adds or removes a component. An index that no tree has is ignored.
    pub(super) fn set(&mut self, component: ComponentId, is_member: bool) {
        let index = component.index();
        let Some(word) = self.words.get_mut(index / BITS) else { return };
        let bit = 1 << (index % BITS);
        *word = if is_member { *word | bit } else { *word & !bit };
    }

    /// Moves all components of another set into this one.
    pub(super) fn take_all(&mut self, other: &mut Self) {
        for (word, more) in self.words.iter_mut().zip(&mut other.words) {
            *word |= core::mem::take(more);
        }
    }

    /// Removes and returns the component with the smallest index.
    pub(super) fn pop(&mut self) -> Option<ComponentId> {
        let (index, word) = self.words.iter_mut().enumerate().find(|(_, word)| **word != 0)?;
        let bit = word.trailing_zeros();
        *word &= *word - 1;
        Some(ComponentId::new(index * BITS + bit as usize))
    }
}
