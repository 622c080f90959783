//! Sets of components: one bit each.

/// A set of small numbers, as an array of words.
pub trait Set: Copy {
    /// Holds nothing.
    const EMPTY: Self;

    /// The bits, lowest number first.
    fn words(&self) -> &[usize];

    /// The bits, to be changed.
    fn words_mut(&mut self) -> &mut [usize];

    /// Whether it holds `number`.
    #[inline]
    fn contains(&self, number: usize) -> bool {
        self.words()[number / WORD] & bit(number) != 0
    }

    /// Adds `number`; whether it was new.
    #[inline]
    fn insert(&mut self, number: usize) -> bool {
        let word = &mut self.words_mut()[number / WORD];
        let new = *word & bit(number) == 0;
        *word |= bit(number);
        new
    }

    /// Takes `number` out.
    #[inline]
    fn remove(&mut self, number: usize) {
        self.words_mut()[number / WORD] &= !bit(number);
    }

    /// What it holds and `other` does not.
    #[inline]
    #[must_use]
    fn without(mut self, other: &Self) -> Self {
        for (word, out) in self.words_mut().iter_mut().zip(other.words()) {
            *word &= !out;
        }
        self
    }

    /// Takes the lowest number out.
    #[inline]
    fn pop(&mut self) -> Option<usize> {
        for (place, word) in self.words_mut().iter_mut().enumerate() {
            if *word != 0 {
                let lowest = word.trailing_zeros() as usize;
                *word &= *word - 1;
                return Some(place * WORD + lowest);
            }
        }
        None
    }
}

impl<const W: usize> Set for [usize; W] {
    const EMPTY: Self = [0; W];

    #[inline]
    fn words(&self) -> &[usize] {
        self
    }

    #[inline]
    fn words_mut(&mut self) -> &mut [usize] {
        self
    }
}

const WORD: usize = usize::BITS as usize;

const fn bit(number: usize) -> usize {
    1 << (number % WORD)
}

/// How many words a set of `count` numbers takes.
#[must_use]
pub const fn words(count: usize) -> usize {
    count.div_ceil(WORD)
}
