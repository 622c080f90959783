//! Rising luma edges on the carpet, in several scans at once.
//!
//! A low-pass filter tracks the luma of the carpet, so each pixel depends on the one before. Eight scans run in the
//! lanes of one SIMD register. Cost: 0.25 ns for each pixel with SIMD, 1.5 ns without.

use crate::frame::Lumas;

/// Number of scans that run in parallel.
pub(super) const LANES: usize = if cfg!(any(target_arch = "x86_64", target_arch = "aarch64")) { 8 } else { 1 };

/// Divisor of the carpet's luma in the minimum luma step.
const RISE_DIVISOR: i16 = 6;
/// Shift of the low-pass filter for the carpet's luma: a time constant of four pixels.
const SMOOTH: i16 = 2;

/// Rising edge.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rise {
    /// Position along the scans.
    pub(super) at: u16,
    /// One bit for each scan with an edge at this position.
    pub(super) lanes: u32,
}

/// State of neighbouring scans that run in parallel.
pub(super) struct ParallelScan<'a> {
    lumas: [Lumas<'a>; LANES],
    /// Luma of the carpet in each scan, times four.
    bases: [i16; LANES],
    /// First position to examine in each scan.
    from: [i16; LANES],
    at: u16,
    /// Distance between the scans, bytes, if it is the same for all; otherwise 0.
    #[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
    gap: usize,
    /// Lumas of eight positions, position by position.
    #[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
    block: [lockstep::I16x8; 8],
    /// First of these positions.
    #[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
    block_at: Option<u16>,
    /// Constant part of the minimum luma step, 0 to 255.
    min_rise: i16,
}

impl<'a> ParallelScan<'a> {
    /// Starts scans, each at its first position. `min_rise` is the constant part of the minimum luma step, 0 to 255.
    pub(super) fn new(scans: impl Iterator<Item = (Lumas<'a>, u16)>, min_rise: i16) -> Self {
        let (lumas, bases, from) = ([Lumas::NONE; LANES], [0; LANES], [i16::MAX; LANES]);
        let mut scan = Self {
            lumas,
            bases,
            from,
            at: u16::MAX,
            #[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
            gap: 0,
            #[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
            block: [lockstep::I16x8::splat(0); 8],
            #[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
            block_at: None,
            min_rise,
        };
        for (lane, (lumas, first)) in scans.take(LANES).enumerate() {
            scan.lumas[lane] = lumas;
            scan.resume(lane, first, Some(i32::from(lumas.get(first))));
            scan.at = scan.at.min(first);
        }
        #[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
        {
            scan.gap = Lumas::common_gap(&scan.lumas);
        }
        scan
    }

    /// Next rising edge before `end`.
    pub(super) fn next_rise(&mut self, end: u16) -> Option<Rise> {
        let rise = lockstep::next_rise(self, end)?;
        self.at = rise.at + 1;
        Some(rise)
    }

    /// Luma of the carpet before a position of a scan, and at the position itself.
    pub(super) fn carpet_and_luma(&self, lane: usize, at: u16) -> (i32, i32) {
        (i32::from(self.bases[lane] >> SMOOTH), i32::from(self.lumas[lane].get(at)))
    }

    /// Continues a scan on the carpet at a position, with a new carpet luma if given.
    pub(super) fn resume(&mut self, lane: usize, at: u16, luma: Option<i32>) {
        self.from[lane] = at as i16;
        if let Some(luma) = luma {
            self.bases[lane] = (luma as i16) << SMOOTH;
        }
    }
}

#[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
mod lockstep {
    #[cfg(target_arch = "aarch64")]
    pub(super) use wide::i16x8 as I16x8;

    use super::{ParallelScan, RISE_DIVISOR, Rise, SMOOTH};
    #[cfg(target_arch = "x86_64")]
    pub(super) use crate::sse2::I16x8;

    #[inline]
    pub(super) fn next_rise(scan: &mut ParallelScan<'_>, end: u16) -> Option<Rise> {
        let (bases, from) = (I16x8::new(scan.bases), I16x8::new(scan.from));
        let mut step = Step { bases, from, min_rise: I16x8::splat(scan.min_rise) };
        let rise = step.go(scan, end);
        scan.bases = step.bases.to_array();
        rise
    }

    struct Step {
        bases: I16x8,
        from: I16x8,
        min_rise: I16x8,
    }

    impl Step {
        #[inline(always)]
        fn go(&mut self, scan: &mut ParallelScan<'_>, end: u16) -> Option<Rise> {
            let mut at = scan.at;
            while let Some(first) = load_block(scan, at, end) {
                if at == first && self.passes(&scan.block, at) {
                    at += 8;
                    continue;
                }
                let rest = &scan.block[usize::from(at - first)..];
                let rise = self.along(rest.iter().copied(), &mut at, end);
                if rise.is_some() {
                    return rise;
                }
            }
            let lumas = (at..end).map(|at| I16x8::new(scan.lumas.map(|lumas| lumas.get(at).into())));
            self.along(lumas, &mut at, end)
        }

        /// Advances over a block that begins at `first` if it contains no rising edge. Returns whether it did.
        #[inline(always)]
        fn passes(&mut self, block: &[I16x8; 8], first: u16) -> bool {
            let ground = self.bases >> i32::from(SMOOTH);
            let (low, high) =
                block.iter().fold((ground, ground), |(low, high), here| (low.min(*here), high.max(*here)));
            let [is_here, is_there] = [1, 8].map(|offset| I16x8::splat(first as i16 + offset).simd_gt(self.from));
            // The luma of the carpet stays between the lowest and the highest luma. A scan that begins within the block is not passed.
            let rises = self.scaled(high).simd_gt(low * I16x8::splat(RISE_DIVISOR + 1)) & is_here;
            if (rises | is_there & !is_here).to_bitmask() != 0 {
                return false;
            }
            for here in block {
                self.bases += (*here - (self.bases >> i32::from(SMOOTH))) & is_here;
            }
            true
        }

        /// Advances over positions before `end` with these lumas.
        #[inline(always)]
        fn along(&mut self, lumas: impl Iterator<Item = I16x8>, at: &mut u16, end: u16) -> Option<Rise> {
            let mut next = I16x8::splat(*at as i16 + 1);
            for (here, at_here) in lumas.zip(*at..end) {
                let lanes = self.on(here, next);
                if lanes != 0 {
                    return Some(Rise { at: at_here, lanes });
                }
                next += I16x8::splat(1);
                *at = at_here + 1;
            }
            None
        }

        /// Advances to a position with the lumas `here`; `next` are the lumas of the next position. Returns one bit for
        /// each scan with a rising edge.
        #[inline(always)]
        fn on(&mut self, here: I16x8, next: I16x8) -> u32 {
            let ground = self.bases >> i32::from(SMOOTH);
            let is_here = next.simd_gt(self.from);
            let rises = self.scaled(here).simd_gt(ground * I16x8::splat(RISE_DIVISOR + 1)) & is_here;
            self.bases += (here - ground) & is_here & !rises;
            rises.to_bitmask()
        }

        /// Luma minus the constant part of the minimum step, times the divisor. It is a rising edge if it exceeds the
        /// carpet's luma times the divisor plus one.
        #[inline(always)]
        fn scaled(&self, luma: I16x8) -> I16x8 {
            (luma - self.min_rise) * I16x8::splat(RISE_DIVISOR)
        }
    }

    /// First position of the block that contains a position. Reads another block if necessary; `None` near the end.
    #[inline(always)]
    fn load_block(scan: &mut ParallelScan<'_>, at: u16, end: u16) -> Option<u16> {
        if let Some(first) = scan.block_at.filter(|first| at - first < 8) {
            return Some(first);
        }
        let is_read = end.saturating_sub(at) >= 8 && read_block(scan, at);
        scan.block_at = is_read.then_some(at);
        scan.block_at
    }

    /// Reads a block, for rows or for columns of a frame of 160 × 120, 320 × 240 or 640 × 480. Returns whether it did.
    #[inline(never)]
    fn read_block(scan: &mut ParallelScan<'_>, at: u16) -> bool {
        let first = scan.lumas[0];
        if first.eight(at).is_some() {
            let mut rows = [I16x8::splat(0); 8];
            for (row, lumas) in rows.iter_mut().zip(&scan.lumas) {
                if let Some(bytes) = lumas.eight(at) {
                    *row = EVERY_SECOND(bytes);
                }
            }
            scan.block = I16x8::transpose(rows);
            return true;
        }
        match scan.gap {
            4 => fill(&mut scan.block, first.spans(at).map(EVERY_FOURTH)),
            8 => fill(&mut scan.block, first.spans(at).map(EVERY_EIGHTH)),
            16 => fill(&mut scan.block, first.spans(at).map(every::<113, 16>)),
            _ => false,
        }
    }

    /// Fills a block if there are enough lumas. Returns whether it did.
    #[inline(always)]
    fn fill(block: &mut [I16x8; 8], lumas: impl Iterator<Item = I16x8>) -> bool {
        let places = block.iter_mut().zip(lumas).map(|(place, here)| *place = here);
        places.count() == 8
    }

    /// Every `GAP`th of some bytes.
    #[inline(always)]
    fn every<const SPAN: usize, const GAP: usize>(bytes: &[u8; SPAN]) -> I16x8 {
        I16x8::new(core::array::from_fn(|lane| bytes[GAP * lane].into()))
    }

    #[cfg(target_arch = "x86_64")]
    const EVERY_SECOND: fn(&[u8; 16]) -> I16x8 = I16x8::every_second;
    #[cfg(target_arch = "x86_64")]
    const EVERY_FOURTH: fn(&[u8; 29]) -> I16x8 = I16x8::every_fourth;
    #[cfg(target_arch = "x86_64")]
    const EVERY_EIGHTH: fn(&[u8; 57]) -> I16x8 = I16x8::every_eighth;
    #[cfg(target_arch = "aarch64")]
    const EVERY_SECOND: fn(&[u8; 16]) -> I16x8 = every::<16, 2>;
    #[cfg(target_arch = "aarch64")]
    const EVERY_FOURTH: fn(&[u8; 29]) -> I16x8 = every::<29, 4>;
    #[cfg(target_arch = "aarch64")]
    const EVERY_EIGHTH: fn(&[u8; 57]) -> I16x8 = every::<57, 8>;
}

#[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64")))]
mod lockstep {
    use super::{ParallelScan, RISE_DIVISOR, Rise, SMOOTH};

    #[inline]
    pub(super) fn next_rise(scan: &mut ParallelScan<'_>, end: u16) -> Option<Rise> {
        let ([lumas], [base], [from]) = (scan.lumas, &mut scan.bases, scan.from);
        for at in scan.at.max(from as u16)..end {
            let (here, ground) = (i16::from(lumas.get(at)), *base >> SMOOTH);
            if (here - ground - scan.min_rise) * RISE_DIVISOR > ground {
                return Some(Rise { at, lanes: 1 });
            }
            *base += here - ground;
        }
        None
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::vec::Vec;

    use proptest::prelude::*;

    use super::*;
    use crate::frame::Frame;

    const END: u16 = 16;

    /// Reference: each rising edge of one row, pixel by pixel.
    fn rises(lumas: Lumas<'_>, first: u16, min_rise: i32) -> Vec<u16> {
        let (mut found, mut base) = (Vec::new(), 4 * i32::from(lumas.get(first)));
        for at in first..END {
            let (here, ground) = (i32::from(lumas.get(at)), base >> 2);
            if here > ground + min_rise + ground / 6 {
                found.push(at);
            } else {
                base += here - ground;
            }
        }
        found
    }

    proptest! {
        #[test]
        fn parallel_scans_find_edges_of_single_scans(
            bytes in prop::collection::vec(prop_oneof![3 => 60_u8..90, 1 => any::<u8>()], 2 * 16 * 16),
            firsts in prop::collection::vec(0..=END, 1..=LANES),
            min_rise in 1..40_i16,
        ) {
            let frame = Frame::new(16, 16, &bytes).unwrap();
            let rows = || firsts.iter().enumerate().map(|(row, first)| (frame.luma_row(row as u16), *first));
            let (mut scan, mut found) = (ParallelScan::new(rows(), min_rise), [const { Vec::new() }; LANES]);
            while let Some(Rise { at, lanes }) = scan.next_rise(END) {
                for lane in (0..LANES).filter(|lane| lanes >> lane & 1 != 0) {
                    prop_assert_eq!(scan.carpet_and_luma(lane, at).1, i32::from(frame.luma_row(lane as u16).get(at)));
                    found[lane].push(at);
                    scan.resume(lane, at + 1, None);
                }
            }
            for ((lumas, first), found) in rows().zip(found) {
                prop_assert_eq!(found, rises(lumas, first, min_rise.into()));
            }
        }
    }
}
