//! Reproducible pseudo-random numbers, and random damage.

/// A sequence of pseudo-random numbers (`SplitMix64`, S. Vigna).
pub(crate) struct Random(u64);

impl Random {
    /// Creates the sequence of a seed.
    pub(crate) const fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Returns a random 64-bit number.
    pub(crate) const fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// Returns a number below `end`, or 0 if `end` is 0.
    pub(crate) fn below(&mut self, end: usize) -> usize {
        (self.next() % end.max(1) as u64) as usize
    }

    /// Returns a number from −`limit` to `limit`.
    pub(crate) fn within(&mut self, limit: f32) -> f32 {
        limit * (self.below(20_001) as f32 / 10_000.0 - 1.0)
    }

    /// Damages a stream: flips, removes, duplicates, inserts and truncates bytes.
    pub(crate) fn damage(&mut self, stream: &mut Vec<u8>) {
        for _ in 0..=self.below(8) {
            let place = self.below(stream.len());
            let end = (place + self.below(40)).min(stream.len());
            match self.below(7) {
                0 => stream[place..end].iter_mut().for_each(|byte| *byte ^= self.next() as u8),
                1 => drop(stream.drain(place..end)),
                2 => stream.splice(place..place, (0..self.below(20)).map(|_| 0)).for_each(drop),
                3 => stream.extend_from_within(place..end),
                4 if self.below(8) == 0 => stream.truncate(place),
                5 => stream.splice(place..place, (0..self.below(3000)).map(|at| at as u8 | 1)).for_each(drop),
                _ => stream.insert(place, self.next() as u8),
            }
        }
    }
}
