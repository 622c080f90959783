//! Bounding boxes of chroma: early rejection of sixteen pixel pairs at a time while searching for rare colours.
//!
//! If no selected class has a colour within the bounding box of the pairs' chroma, none of the pixels needs a table
//! lookup. Cost: 2 ns for `BLOCK` pairs with 16-byte SIMD, against 23 ns for their classification. Without SIMD it
//! would cost more than it saves and is compiled out.

use heapless::Vec;

/// Pixel pairs tested together.
pub(crate) const BLOCK: usize = 16;
/// Result of [`Sieve::lets_through`] if the chroma of each pair is inside a box.
pub(crate) const EVERY_PAIR: u64 = 0x1111_1111_1111_1111;

/// Box of chroma between two corners (Cb, Cr), both included; empty if the first corner is above the second.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ChromaBox {
    low: [u8; 2],
    high: [u8; 2],
}

impl ChromaBox {
    /// Box of every chroma.
    pub const ALL: Self = Self { low: [0; 2], high: [u8::MAX; 2] };
    /// Box of the first chroma, whose memory is zero.
    pub(crate) const ORIGIN: Self = Self { low: [0; 2], high: [0; 2] };
    /// Empty box.
    pub const EMPTY: Self = Self { low: [u8::MAX; 2], high: [0; 2] };

    /// Smallest box that also contains the chroma from `low` to `high`, each (Cb, Cr).
    #[must_use]
    pub const fn with(self, low: [u8; 2], high: [u8; 2]) -> Self {
        let (a, b) = (self.low, self.high);
        Self {
            low: [if low[0] < a[0] { low[0] } else { a[0] }, if low[1] < a[1] { low[1] } else { a[1] }],
            high: [if high[0] > b[0] { high[0] } else { b[0] }, if high[1] > b[1] { high[1] } else { b[1] }],
        }
    }

    /// Smallest box that contains both boxes.
    #[must_use]
    pub const fn union(self, other: Self) -> Self {
        self.with(other.low, other.high)
    }

    /// Whether the box contains a chroma.
    #[must_use]
    pub const fn has(&self, [cb, cr]: [u8; 2]) -> bool {
        self.low[0] <= cb && cb <= self.high[0] && self.low[1] <= cr && cr <= self.high[1]
    }
}

/// Filter for blocks of pixel pairs without any chroma of the given boxes.
pub(crate) struct Sieve(Vec<wide_box::WideBox, 5>);

impl Sieve {
    /// Creates a filter for at most five boxes.
    pub(crate) fn new(boxes: impl Iterator<Item = ChromaBox>) -> Self {
        Self(boxes.map(wide_box::WideBox::from).collect())
    }

    /// Whether the chroma of all pairs is outside all boxes. May return false for a block without selected pixels.
    #[inline(always)]
    pub(crate) fn holds_back(&self, pairs: &[[u8; 4]; BLOCK]) -> bool {
        wide_box::are_beyond(&self.0, pairs)
    }

    /// Pairs whose chroma is inside a box: for each, from the first on, the lowest of four bits.
    #[inline(always)]
    pub(crate) fn lets_through(&self, pairs: &[[u8; 4]; BLOCK]) -> u64 {
        wide_box::inside(&self.0, pairs)
    }
}

/// Splits a row into blocks, where the filter saves time, and a rest.
#[inline(always)]
pub(crate) const fn blocks(row: &[[u8; 4]]) -> (&[[[u8; 4]; BLOCK]], &[[u8; 4]]) {
    if wide_box::PAYS { row.as_chunks() } else { (&[], row) }
}

#[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
mod wide_box {
    #[cfg(target_arch = "aarch64")]
    use wide::u8x16 as U8x16;

    use super::{BLOCK, ChromaBox};
    #[cfg(target_arch = "x86_64")]
    use crate::sse2::U8x16;

    pub(super) const PAYS: bool = true;

    /// Corners of a box, repeated for four pairs; any luma is inside.
    #[derive(Clone, Copy)]
    pub(super) struct WideBox {
        low: U8x16,
        high: U8x16,
    }

    impl From<ChromaBox> for WideBox {
        fn from(ChromaBox { low, high }: ChromaBox) -> Self {
            let four =
                |luma: u8, [cb, cr]: [u8; 2]| U8x16::new(core::array::from_fn(|at| [luma, cb, luma, cr][at % 4]));
            Self { low: four(0, low), high: four(u8::MAX, high) }
        }
    }

    #[inline(always)]
    pub(super) fn are_beyond(boxes: &[WideBox], pairs: &[[u8; 4]; BLOCK]) -> bool {
        let (fours, _) = pairs.as_flattened().as_chunks();
        let mut fours = fours.iter().map(|four| U8x16::new(*four));
        let first = fours.next().unwrap_or_default();
        let (low, high) = fours.fold((first, first), |(low, high), four| (low.min(four), high.max(four)));
        !boxes.iter().any(|selected| whole(high.simd_ge(selected.low) & low.simd_le(selected.high)) != 0)
    }

    #[inline(always)]
    pub(super) fn inside(boxes: &[WideBox], pairs: &[[u8; 4]; BLOCK]) -> u64 {
        let (fours, _) = pairs.as_flattened().as_chunks();
        let is_in = |four: U8x16| {
            boxes.iter().fold(0, |all, selected| all | whole(four.simd_ge(selected.low) & four.simd_le(selected.high)))
        };
        fours.iter().rev().fold(0, |all, four| all << 16 | u64::from(is_in(U8x16::new(*four))))
    }

    /// Lowest bits of the pairs whose four bytes are all set.
    #[inline(always)]
    fn whole(lanes: U8x16) -> u32 {
        let lanes = lanes.to_bitmask();
        let halves = lanes & lanes >> 1;
        halves & halves >> 2 & 0x1111
    }
}

#[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64")))]
mod wide_box {
    use super::{BLOCK, ChromaBox};

    pub(super) const PAYS: bool = false;

    /// Placeholder: without SIMD there are no blocks.
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

    #[inline(always)]
    pub(super) const fn inside(_: &[WideBox], _: &[[u8; 4]; BLOCK]) -> u64 {
        super::EVERY_PAIR
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
        fn box_contains_its_members_and_all_between(a in any::<[u8; 2]>(), b in any::<[u8; 2]>(), at in any::<[u8; 2]>()) {
            let found = ChromaBox::EMPTY.with(a, a).with(b, b);
            let between = |axis: usize| (a[axis].min(b[axis])..=a[axis].max(b[axis])).contains(&at[axis]);
            prop_assert_eq!(found.has(at), between(0) && between(1));
            prop_assert!(found.has(a) && found.has(b) && ChromaBox::ALL.has(at) && !ChromaBox::EMPTY.has(at));
        }

        #[test]
        fn filter_never_skips_a_wanted_pair(
            pairs in any::<[[u8; 4]; BLOCK]>(), boxes in prop::collection::vec(chroma_box(), 0..5),
        ) {
            let selected = pairs.iter().any(|[_, cb, _, cr]| boxes.iter().any(|selected| selected.has([*cb, *cr])));
            prop_assert!(!selected || !Sieve::new(boxes.into_iter()).holds_back(&pairs));
        }

        #[test]
        #[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
        fn filter_accepts_pairs_in_a_box(
            pairs in any::<[[u8; 4]; BLOCK]>(), boxes in prop::collection::vec(chroma_box(), 0..5),
        ) {
            let is_in = |[_, cb, _, cr]: [u8; 4]| boxes.iter().any(|selected| selected.has([cb, cr]));
            let expected = (0..BLOCK).filter(|at| is_in(pairs[*at])).map(|at| 1_u64 << (4 * at)).sum::<u64>();
            prop_assert_eq!(Sieve::new(boxes.iter().copied()).lets_through(&pairs), expected);
        }

        #[test]
        #[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
        fn colour_without_a_box_is_withheld(pair in any::<[u8; 4]>(), selected in chroma_box()) {
            let sieve = Sieve::new([selected].into_iter());
            prop_assert_eq!(sieve.holds_back(&[pair; BLOCK]), !selected.has([pair[1], pair[3]]));
        }
    }
}
