//! Boxes of chroma: a cheap no, sixteen pairs at a time, where rare colours are looked for.
//!
//! The chroma of neighbouring pixels lies in a small box; if no wanted class has any colour in it, none of the pixels
//! needs to be classified. Cost: 2 ns for `BLOCK` pairs where the processor takes 16 bytes at once, against 23 ns for
//! their classes. Elsewhere it would cost more than it saves and is left out.

use heapless::Vec;

/// Pairs that are looked at together.
pub(crate) const BLOCK: usize = 16;

/// All chroma from one (Cb, Cr) to another, both included; empty if the first is above the second.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ChromaBox {
    low: [u8; 2],
    high: [u8; 2],
}

impl ChromaBox {
    /// Every chroma.
    pub const ALL: Self = Self { low: [0; 2], high: [u8::MAX; 2] };
    /// No chroma.
    pub const EMPTY: Self = Self { low: [u8::MAX; 2], high: [0; 2] };

    /// The smallest box that also has the chroma from `low` to `high`, each (Cb, Cr).
    #[must_use]
    pub const fn with(self, low: [u8; 2], high: [u8; 2]) -> Self {
        let (a, b) = (self.low, self.high);
        Self {
            low: [if low[0] < a[0] { low[0] } else { a[0] }, if low[1] < a[1] { low[1] } else { a[1] }],
            high: [if high[0] > b[0] { high[0] } else { b[0] }, if high[1] > b[1] { high[1] } else { b[1] }],
        }
    }

    /// Whether a chroma is in it.
    #[must_use]
    pub const fn has(&self, [cb, cr]: [u8; 2]) -> bool {
        self.low[0] <= cb && cb <= self.high[0] && self.low[1] <= cr && cr <= self.high[1]
    }
}

/// Tells blocks of pairs that have no chroma of any of some boxes.
pub(crate) struct Sieve(Vec<wide_box::WideBox, 5>);

impl Sieve {
    /// For at most five boxes.
    pub(crate) fn new(boxes: impl Iterator<Item = ChromaBox>) -> Self {
        Self(boxes.map(wide_box::WideBox::from).collect())
    }

    /// Whether all pairs have chroma that is in none of the boxes; a no may be wrong.
    #[inline(always)]
    pub(crate) fn holds_back(&self, pairs: &[[u8; 4]; BLOCK]) -> bool {
        wide_box::are_beyond(&self.0, pairs)
    }
}

/// Cuts a row into blocks where a sieve pays, and a rest.
#[inline(always)]
pub(crate) const fn blocks(row: &[[u8; 4]]) -> (&[[[u8; 4]; BLOCK]], &[[u8; 4]]) {
    if wide_box::PAYS { row.as_chunks() } else { (&[], row) }
}

#[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
mod wide_box {
    use wide::u8x16;

    use super::{BLOCK, ChromaBox};

    pub(super) const PAYS: bool = true;

    /// The ends of a box, once for each of four pairs; any luma is in it.
    #[derive(Clone, Copy)]
    pub(super) struct WideBox {
        low: u8x16,
        high: u8x16,
    }

    impl From<ChromaBox> for WideBox {
        fn from(ChromaBox { low, high }: ChromaBox) -> Self {
            let four =
                |luma: u8, [cb, cr]: [u8; 2]| u8x16::new(core::array::from_fn(|at| [luma, cb, luma, cr][at % 4]));
            Self { low: four(0, low), high: four(u8::MAX, high) }
        }
    }

    #[inline(always)]
    pub(super) fn are_beyond(boxes: &[WideBox], pairs: &[[u8; 4]; BLOCK]) -> bool {
        let (fours, _) = pairs.as_flattened().as_chunks();
        let mut fours = fours.iter().map(|four| u8x16::new(*four));
        let first = fours.next().unwrap_or_default();
        let (low, high) = fours.fold((first, first), |(low, high), four| (low.min(four), high.max(four)));
        !boxes.iter().any(|wanted| {
            let lanes = (high.simd_ge(wanted.low) & low.simd_le(wanted.high)).to_bitmask();
            // A pair passes if its four bytes do.
            let halves = lanes & lanes >> 1;
            halves & halves >> 2 & 0x1111 != 0
        })
    }
}

#[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64")))]
mod wide_box {
    use super::{BLOCK, ChromaBox};

    pub(super) const PAYS: bool = false;

    /// Nothing, as it is never asked.
    #[derive(Clone, Copy)]
    pub(super) struct WideBox;

    impl From<ChromaBox> for WideBox {
        fn from(_: ChromaBox) -> Self {
            Self
        }
    }

    #[inline(always)]
    pub(super) const fn are_beyond(_: &[WideBox], _: &[[u8; 4]; BLOCK]) -> bool {
        false
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn chroma_box() -> impl Strategy<Value = ChromaBox> {
        any::<([u8; 2], [u8; 2])>().prop_map(|(a, b)| ChromaBox::EMPTY.with(a, a).with(b, b))
    }

    proptest! {
        #[test]
        fn a_box_has_what_was_put_in_and_what_is_between(a in any::<[u8; 2]>(), b in any::<[u8; 2]>(), at in any::<[u8; 2]>()) {
            let found = ChromaBox::EMPTY.with(a, a).with(b, b);
            let between = |axis: usize| (a[axis].min(b[axis])..=a[axis].max(b[axis])).contains(&at[axis]);
            prop_assert_eq!(found.has(at), between(0) && between(1));
            prop_assert!(found.has(a) && found.has(b) && ChromaBox::ALL.has(at) && !ChromaBox::EMPTY.has(at));
        }

        #[test]
        fn nothing_wanted_is_held_back(
            pairs in any::<[[u8; 4]; BLOCK]>(), boxes in prop::collection::vec(chroma_box(), 0..5),
        ) {
            let wanted = pairs.iter().any(|[_, cb, _, cr]| boxes.iter().any(|wanted| wanted.has([*cb, *cr])));
            prop_assert!(!wanted || !Sieve::new(boxes.into_iter()).holds_back(&pairs));
        }

        #[test]
        #[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
        fn one_colour_is_held_back_if_it_is_in_no_box(pair in any::<[u8; 4]>(), wanted in chroma_box()) {
            let sieve = Sieve::new([wanted].into_iter());
            prop_assert_eq!(sieve.holds_back(&[pair; BLOCK]), !wanted.has([pair[1], pair[3]]));
        }
    }
}
