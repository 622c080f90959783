//! Luma along the carpet, in several scans at once, up to where it rises.
//!
//! What luma is on the carpet follows each pixel a little, so one pixel has to wait for the other; eight scans wait
//! together where the processor adds eight numbers at once. Cost: 0.25 ns for a pixel there, 1.5 ns elsewhere.

use crate::frame::Lumas;

/// Scans that are walked along together.
pub(super) const LANES: usize = if cfg!(any(target_arch = "x86_64", target_arch = "aarch64")) { 8 } else { 1 };

/// The least rise of luma, of 255, and as a part of what it rises from.
const RISE: (i16, i16) = (12, 6);
/// Shift by which luma is smoothed on the carpet: over four pixels.
const SMOOTH: i16 = 2;

/// Where luma rises from that of the carpet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rise {
    /// The place along the scans.
    pub(super) at: u16,
    /// A bit for each scan in which it rises there.
    pub(super) lanes: u32,
}

/// A walk along scans that lie side by side.
pub(super) struct Walk<'a> {
    lumas: [Lumas<'a>; LANES],
    /// Luma of the carpet, times four.
    bases: [i16; LANES],
    /// From where on a scan is looked at.
    from: [i16; LANES],
    at: u16,
}

impl<'a> Walk<'a> {
    /// Along scans, each from its first place.
    pub(super) fn new(scans: impl Iterator<Item = (Lumas<'a>, u16)>) -> Self {
        let mut walk = Self { lumas: [Lumas::NONE; LANES], bases: [0; LANES], from: [i16::MAX; LANES], at: u16::MAX };
        for (lane, (lumas, first)) in scans.take(LANES).enumerate() {
            walk.lumas[lane] = lumas;
            walk.go_on(lane, first, Some(i32::from(lumas.get(first))));
            walk.at = walk.at.min(first);
        }
        walk
    }

    /// The next rise before `end`.
    pub(super) fn next_rise(&mut self, end: u16) -> Option<Rise> {
        let rise = lockstep::next_rise(self, end)?;
        self.at = rise.at + 1;
        Some(rise)
    }

    /// Luma of the carpet before a place of a scan, and at the place itself.
    pub(super) fn on_carpet(&self, lane: usize, at: u16) -> (i32, i32) {
        (i32::from(self.bases[lane] >> SMOOTH), i32::from(self.lumas[lane].get(at)))
    }

    /// Comes back to the carpet in a scan at a place, perhaps with another luma.
    pub(super) fn go_on(&mut self, lane: usize, at: u16, luma: Option<i32>) {
        self.from[lane] = at as i16;
        if let Some(luma) = luma {
            self.bases[lane] = (luma as i16) << SMOOTH;
        }
    }
}

#[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
mod lockstep {
    use wide::{i16x8, u16x8};

    use super::{RISE, Rise, SMOOTH, Walk};

    #[inline]
    pub(super) fn next_rise(walk: &mut Walk<'_>, end: u16) -> Option<Rise> {
        let mut step = Step { bases: i16x8::new(walk.bases), from: i16x8::new(walk.from) };
        let rise = step.go(walk, end);
        walk.bases = step.bases.to_array();
        rise
    }

    struct Step {
        bases: i16x8,
        from: i16x8,
    }

    impl Step {
        #[inline(always)]
        fn go(&mut self, walk: &Walk<'_>, end: u16) -> Option<Rise> {
            let mut at = walk.at;
            // Of rows, eight pixels each are read at once and turned.
            while let Some(block) = block(walk, at, end) {
                for here in block {
                    let lanes = self.on(here, at);
                    if lanes != 0 {
                        return Some(Rise { at, lanes });
                    }
                    at += 1;
                }
            }
            for at in at..end {
                let lanes = self.on(i16x8::new(walk.lumas.map(|lumas| i16::from(lumas.get(at)))), at);
                if lanes != 0 {
                    return Some(Rise { at, lanes });
                }
            }
            None
        }

        /// Goes on to a place with these lumas; a bit for each scan in which luma rises there.
        #[inline(always)]
        fn on(&mut self, here: i16x8, at: u16) -> u32 {
            let ground = self.bases >> i32::from(SMOOTH);
            let is_here = i16x8::splat(at as i16).simd_ge(self.from);
            let above = (here - ground - i16x8::splat(RISE.0)) * i16x8::splat(RISE.1);
            let rises = above.simd_gt(ground) & is_here;
            self.bases += (here - ground) & is_here & !rises;
            rises.to_bitmask()
        }
    }

    /// The lumas of eight places of rows, place by place; none of columns or near the end.
    #[inline(always)]
    fn block(walk: &Walk<'_>, at: u16, end: u16) -> Option<[i16x8; 8]> {
        if end.saturating_sub(at) < 8 || walk.lumas[0].eight(at).is_none() {
            return None;
        }
        let rows = walk.lumas.map(|lumas| u16x8::new(lumas.eight(at).unwrap_or_default()));
        Some(u16x8::transpose(rows).map(|here| i16x8::new(here.to_array().map(|luma| luma as i16))))
    }
}

#[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64")))]
mod lockstep {
    use super::{RISE, Rise, SMOOTH, Walk};

    #[inline]
    pub(super) fn next_rise(walk: &mut Walk<'_>, end: u16) -> Option<Rise> {
        let ([lumas], [base], [from]) = (walk.lumas, &mut walk.bases, walk.from);
        for at in walk.at.max(from as u16)..end {
            let (here, ground) = (i16::from(lumas.get(at)), *base >> SMOOTH);
            if (here - ground - RISE.0) * RISE.1 > ground {
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

    /// Every rise of one row, pixel by pixel, going on after each one.
    fn rises(lumas: Lumas<'_>, first: u16) -> Vec<u16> {
        let (mut found, mut base) = (Vec::new(), 4 * i32::from(lumas.get(first)));
        for at in first..END {
            let (here, ground) = (i32::from(lumas.get(at)), base >> 2);
            if here > ground + 12 + ground / 6 {
                found.push(at);
            } else {
                base += here - ground;
            }
        }
        found
    }

    proptest! {
        #[test]
        fn together_scans_rise_as_each_alone(
            bytes in prop::collection::vec(prop_oneof![3 => 60_u8..90, 1 => any::<u8>()], 2 * 16 * 16),
            firsts in prop::collection::vec(0..=END, 1..=LANES),
        ) {
            let frame = Frame::new(16, 16, &bytes).unwrap();
            let rows = || firsts.iter().enumerate().map(|(row, first)| (frame.luma_row(row as u16), *first));
            let (mut walk, mut found) = (Walk::new(rows()), [const { Vec::new() }; LANES]);
            while let Some(Rise { at, lanes }) = walk.next_rise(END) {
                for lane in (0..LANES).filter(|lane| lanes >> lane & 1 != 0) {
                    prop_assert_eq!(walk.on_carpet(lane, at).1, i32::from(frame.luma_row(lane as u16).get(at)));
                    found[lane].push(at);
                    walk.go_on(lane, at + 1, None);
                }
            }
            for ((lumas, first), found) in rows().zip(found) {
                prop_assert_eq!(found, rises(lumas, first));
            }
        }
    }
}
