//! Rising luma edges on the carpet, in several scans at once.
//!
//! A low-pass filter tracks the luma of the carpet, so each pixel depends on the one before. Eight scans run in the
//! lanes of one SIMD register. Cost: 0.25 ns for each pixel with SIMD, 1.5 ns without.

use crate::frame::Lumas;

/// Number of scans that run in parallel.
pub(super) const LANES: usize = if cfg!(any(target_arch = "x86_64", target_arch = "aarch64")) { 8 } else { 1 };

/// The minimum luma step grows by the carpet's luma over this.
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
    use core::ops::Range;

    #[cfg(target_arch = "aarch64")]
    use wide::i16x8 as I16x8;

    use super::{ParallelScan, RISE_DIVISOR, Rise, SMOOTH};
    use crate::frame::Lumas;
    #[cfg(target_arch = "x86_64")]
    use crate::sse2::I16x8;

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
        fn go(&mut self, scan: &ParallelScan<'_>, end: u16) -> Option<Rise> {
            let mut at = scan.at;
            // For rows, blocks of eight pixels are read at once and transposed.
            while let Some(block) = block(scan, at, end) {
                for here in block {
                    let lanes = self.on(here, at);
                    if lanes != 0 {
                        return Some(Rise { at, lanes });
                    }
                    at += 1;
                }
            }
            // Columns of a frame of 160 × 120, 320 × 240 or 640 × 480 are read with one check of the bounds.
            match scan.gap {
                4 => self.along(scan, at..end, Lumas::of_eight_columns::<29, 4>),
                8 => self.along(scan, at..end, Lumas::of_eight_columns::<57, 8>),
                16 => self.along(scan, at..end, Lumas::of_eight_columns::<113, 16>),
                _ => self.along(scan, at..end, |_, _| None),
            }
        }

        /// Advances over positions. `eight` reads a position of all scans, given the first one's pixels, if it can.
        #[inline(always)]
        fn along<'a>(
            &mut self,
            scan: &ParallelScan<'a>,
            places: Range<u16>,
            eight: impl Fn(&Lumas<'a>, u16) -> Option<[u8; 8]>,
        ) -> Option<Rise> {
            for at in places {
                let here = eight(&scan.lumas[0], at).unwrap_or_else(|| scan.lumas.map(|lumas| lumas.get(at)));
                let lanes = self.on(I16x8::new(here.map(i16::from)), at);
                if lanes != 0 {
                    return Some(Rise { at, lanes });
                }
            }
            None
        }

        /// Advances to a position with these lumas. Returns one bit for each scan with a rising edge.
        #[inline(always)]
        fn on(&mut self, here: I16x8, at: u16) -> u32 {
            let ground = self.bases >> i32::from(SMOOTH);
            let is_here = I16x8::splat(at as i16).simd_ge(self.from);
            let above = (here - ground - self.min_rise) * I16x8::splat(RISE_DIVISOR);
            let rises = above.simd_gt(ground) & is_here;
            self.bases += (here - ground) & is_here & !rises;
            rises.to_bitmask()
        }
    }

    /// Lumas of eight positions of rows, position by position; `None` for columns or near the end.
    #[inline(always)]
    fn block(scan: &ParallelScan<'_>, at: u16, end: u16) -> Option<[I16x8; 8]> {
        if end.saturating_sub(at) < 8 || scan.lumas[0].eight(at).is_none() {
            return None;
        }
        Some(columns(scan.lumas.map(|lumas| lumas.eight(at).unwrap_or_default())))
    }

    #[cfg(target_arch = "x86_64")]
    #[inline(always)]
    fn columns(rows: [[u16; 8]; 8]) -> [I16x8; 8] {
        I16x8::transpose(rows.map(|row| I16x8::new(row.map(|luma| luma as i16))))
    }

    #[cfg(target_arch = "aarch64")]
    #[inline(always)]
    fn columns(rows: [[u16; 8]; 8]) -> [I16x8; 8] {
        use wide::u16x8;

        u16x8::transpose(rows.map(u16x8::new)).map(|here| I16x8::new(here.to_array().map(|luma| luma as i16)))
    }
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
        fn parallel_scans_find_the_edges_of_single_scans(
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
