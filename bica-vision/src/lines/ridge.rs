//! Bright ridges between green pixels in one scan.
//!
//! A ridge begins where luma rises above the carpet and ends where it falls below the mid-level again. So a line thinner than a
//! pixel is found too, although none of its pixels is white. The colour class is read only at both sides and in the middle.

use bica_core::Params;
use heapless::Vec;

use super::LineDetection;
use super::edge_scan::{LANES, ParallelScan};
use super::stripe::Axes;
use crate::colour::{Classify, Colour};
use crate::frame::{Frame, Lumas, Strip};

/// Maximum number of ridges in one scan. Recorded images have at most 6; more is noise, and the rest of the scan is skipped.
pub(super) const RIDGES: usize = 8;
/// Maximum number of rising edges followed in one scan. Recorded images have at most 17; more is noise.
const RISES: u8 = 24;

/// Ridges of one scan, in order.
pub(super) type Ridges = Vec<Ridge, RIDGES>;

/// Cross-section of a line in a scan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ridge {
    /// Middle, position on the scan, px.
    pub(super) at: f32,
    /// Width along the scan, px.
    pub(super) width: f32,
    /// Contrast to the carpet's luma, 0 to 255.
    pub(super) rise: f32,
}

/// Row or column of a frame.
pub(super) struct Scan<'a, C> {
    colours: &'a C,
    lumas: Lumas<'a>,
    pixels: Strip<'a>,
    /// Index of the row or column.
    pub(super) across: u16,
    /// Maximum width of a ridge, px.
    widest: u16,
    tuning: &'a LineDetection,
}

/// Ridge in progress.
struct Open {
    start: u16,
    base: i32,
    peak: i32,
}

/// Ridges between `first` and `end` (excluded) of neighbouring scans.
pub(super) fn in_parallel<C: Classify>(scans: &[(Scan<'_, C>, u16)], end: u16) -> [Ridges; LANES] {
    let mut found = [const { Ridges::new() }; LANES];
    let mut left = [RISES; LANES];
    let min_rise = scans.first().map_or(LineDetection::DEFAULT.min_rise, |(scan, _)| scan.tuning.min_rise);
    let mut parallel = ParallelScan::new(scans.iter().map(|(scan, first)| (scan.lumas, *first)), min_rise as i16);
    while let Some(mut rise) = parallel.next_rise(end) {
        while rise.lanes != 0 {
            let lane = rise.lanes.trailing_zeros() as usize;
            rise.lanes &= rise.lanes - 1;
            let Some((scan, _)) = scans.get(lane) else { continue };
            let (ground, luma) = parallel.carpet_and_luma(lane, rise.at);
            let ridge = Open { start: rise.at, base: ground, peak: luma };
            let (next, base) = scan.climb(ridge, end, &mut found[lane]);
            left[lane] -= 1;
            let is_noise = left[lane] == 0 || found[lane].is_full();
            parallel.resume(lane, if is_noise { end } else { next }, base);
        }
    }
    found
}

impl<'a, C: Classify> Scan<'a, C> {
    /// Creates a scan of the row or column with the index `across`. `widest` is the maximum width of a ridge, px.
    pub(super) fn new(
        frame: &Frame<'a>,
        colours: &'a C,
        axes: Axes,
        across: u16,
        widest: u16,
        tuning: &'a LineDetection,
    ) -> Self {
        let (lumas, pixels) = match axes {
            Axes::Columns => (frame.luma_column(across), frame.strip_of_column(across)),
            Axes::Rows => (frame.luma_row(across), frame.strip_of_row(across)),
        };
        Self { colours, lumas, pixels, across, widest, tuning }
    }

    /// Follows a ridge to its falling edge and adds it if it is part of a line. Returns the position where the scan
    /// continues, and a new carpet luma if the old one is unusable.
    fn climb(&self, mut ridge: Open, end: u16, found: &mut Ridges) -> (u16, Option<i32>) {
        // Position at which the ridge is too wide.
        let last = ridge.start + self.widest + 1;
        for at in ridge.start + 1..end.min(last + 1) {
            let here = i32::from(self.lumas.get(at));
            ridge.peak = ridge.peak.max(here);
            if 2 * here < ridge.base + ridge.peak {
                found.extend(self.measured(&ridge, at));
                return (at + 1, None);
            }
        }
        if last < end { (last + 1, Some(self.lumas.get(last).into())) } else { (end, None) }
    }

    /// Measures a ridge that ended before `end`, if it is white between green.
    fn measured(&self, ridge: &Open, end: u16) -> Option<Ridge> {
        let lumas = &self.lumas;
        // Luma is at least the middle if twice the luma is at least the sum.
        let is_first = |at: &u16| 2 * i32::from(lumas.get(*at)) >= ridge.base + ridge.peak;
        let first = (ridge.start..end).find(is_first)?;
        // Most ridges are not between green.
        let is_on_carpet =
            self.is_green(end + 1, end + 2) && self.is_green(first.checked_sub(2)?, first.saturating_sub(3));
        if !is_on_carpet {
            return None;
        }
        let middle = f32::midpoint(ridge.base as f32, ridge.peak as f32);
        let edge = |dark: u16, bright: u16| {
            let (dark, bright) = (f32::from(lumas.get(dark)), f32::from(lumas.get(bright)));
            (middle - dark) / (bright - dark).max(1.0)
        };
        let from = f32::from(first) - 1.0 + edge(first.checked_sub(1)?, first).clamp(0.0, 1.0);
        let to = f32::from(end) - edge(end, end - 1).clamp(0.0, 1.0);
        let rise = ridge.peak - ridge.base;
        let is_line = self.is_white(f32::midpoint(from, to) as u16, rise);
        is_line.then_some(Ridge { at: f32::midpoint(from, to), width: to - from, rise: rise as f32 })
    }

    fn class(&self, at: u16) -> Colour {
        self.pixels.pixel(at).map_or(Colour::None, |pixel| self.colours.classify(pixel))
    }

    fn is_green(&self, near: u16, far: u16) -> bool {
        self.class(near) == Colour::Green || self.class(far) == Colour::Green
    }

    fn is_white(&self, at: u16, rise: i32) -> bool {
        match self.class(at) {
            Colour::White | Colour::None => true,
            Colour::Green => rise >= self.tuning.min_thin_rise as i32,
            Colour::Orange | Colour::Yellow | Colour::Blue => false,
        }
    }
}
