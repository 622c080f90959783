//! Bright stripes between green in one scan of pixels.
//!
//! A stripe begins where luma rises from what it was on the carpet and ends where it falls through the middle again: so a
//! line that is thinner than a pixel is found too, though no pixel of it is white. Classes are asked for at its two sides
//! and in its middle only.

use heapless::Vec;

use super::Axes;
use crate::colour::{Classify, Colour};
use crate::frame::{Frame, Lumas, Pixel};

/// Stripes of one scan.
pub(super) const RIDGES: usize = 16;
/// The least rise of luma, of 255, and as a part of what it rises from.
const RISE: (i32, i32) = (12, 6);
/// A stripe of the carpet's own colour is none unless it is so much brighter: tufts are not.
const THIN_RISE: i32 = 30;
/// Shift by which luma is smoothed on the carpet: over four pixels.
const SMOOTH: i32 = 2;

/// A stripe across a scan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ridge {
    /// Its middle on the scan, px.
    pub(super) at: f32,
    /// How wide it is along the scan, px.
    pub(super) width: f32,
    /// How much brighter than the carpet it is, of 255.
    pub(super) rise: f32,
}

/// A row or a column of a frame.
pub(super) struct Scan<'a, C> {
    pub(super) frame: &'a Frame<'a>,
    pub(super) colours: &'a C,
    pub(super) axes: Axes,
    /// Which row or column.
    pub(super) across: u16,
    /// The widest stripe, px.
    pub(super) widest: u16,
}

/// A stripe that has begun.
struct Open {
    start: u16,
    base: i32,
    peak: i32,
}

impl<C: Classify> Scan<'_, C> {
    /// The stripes between two places of the scan, the second one excluded.
    pub(super) fn ridges(&self, first: u16, end: u16) -> Vec<Ridge, RIDGES> {
        let lumas = self.lumas();
        let luma = |at: u16| i32::from(lumas.get(at));
        let (mut found, mut base, mut at) = (Vec::new(), luma(first) << SMOOTH, first);
        while at < end {
            let (ground, here) = (base >> SMOOTH, luma(at));
            if here <= ground + RISE.0 + ground / RISE.1 {
                base += here - ground;
                at += 1;
                continue;
            }
            let mut ridge = Open { start: at, base: ground, peak: here };
            at += 1;
            while at < end {
                let here = luma(at);
                at += 1;
                ridge.peak = ridge.peak.max(here);
                if 2 * here < ridge.base + ridge.peak {
                    found.extend(self.measured(&ridge, at - 1).into_iter().take(RIDGES - found.len()));
                    break;
                }
                if at - 1 - ridge.start > self.widest {
                    base = here << SMOOTH;
                    break;
                }
            }
        }
        found
    }

    fn lumas(&self) -> Lumas<'_> {
        match self.axes {
            Axes::Columns => self.frame.luma_column(self.across),
            Axes::Rows => self.frame.luma_row(self.across),
        }
    }

    fn pixel(&self, at: u16) -> Option<Pixel> {
        let (x, y) = match self.axes {
            Axes::Columns => (self.across, at),
            Axes::Rows => (at, self.across),
        };
        self.frame.pixel(x.into(), y.into())
    }

    fn luma(&self, at: u16) -> i32 {
        self.pixel(at).map_or(0, |pixel| pixel.y.into())
    }

    /// The stripe that ended before a place, if it is one of white on green.
    fn measured(&self, ridge: &Open, end: u16) -> Option<Ridge> {
        let middle = f32::midpoint(ridge.base as f32, ridge.peak as f32);
        let first = (ridge.start..end).find(|at| self.luma(*at) as f32 >= middle)?;
        let edge = |dark: u16, bright: u16| {
            let (dark, bright) = (self.luma(dark) as f32, self.luma(bright) as f32);
            (middle - dark) / (bright - dark).max(1.0)
        };
        let from = f32::from(first) - 1.0 + edge(first.checked_sub(1)?, first).clamp(0.0, 1.0);
        let to = f32::from(end) - edge(end, end - 1).clamp(0.0, 1.0);
        let rise = ridge.peak - ridge.base;
        let is_line = self.is_green(first.checked_sub(2)?, first.saturating_sub(3))
            && self.is_green(end + 1, end + 2)
            && self.is_white(f32::midpoint(from, to) as u16, rise);
        is_line.then_some(Ridge { at: f32::midpoint(from, to), width: to - from, rise: rise as f32 })
    }

    fn class(&self, at: u16) -> Colour {
        self.pixel(at).map_or(Colour::None, |pixel| self.colours.classify(pixel))
    }

    fn is_green(&self, near: u16, far: u16) -> bool {
        self.class(near) == Colour::Green || self.class(far) == Colour::Green
    }

    fn is_white(&self, at: u16, rise: i32) -> bool {
        match self.class(at) {
            Colour::White | Colour::None => true,
            Colour::Green => rise >= THIN_RISE,
            Colour::Orange | Colour::Yellow | Colour::Blue => false,
        }
    }
}
