//! Numbers that look random and are the same in every run.

/// A sequence of pseudo-random numbers (`SplitMix64`, S. Vigna).
pub(crate) struct Random(u64);

impl Random {
    /// The sequence with a number.
    pub(crate) const fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Any number.
    pub(crate) const fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// A number below `end`; 0 if that is 0.
    pub(crate) fn below(&mut self, end: usize) -> usize {
        (self.next() % end.max(1) as u64) as usize
    }

    /// Any number from −`most` to `most`.
    pub(crate) fn within(&mut self, most: f32) -> f32 {
        most * (self.below(20_001) as f32 / 10_000.0 - 1.0)
    }
}
