//! Rows and columns of a frame.

use super::Pixel;

/// Luma of the pixels of a row or a column.
#[derive(Clone, Copy, Debug)]
pub struct Lumas<'a> {
    pub(super) bytes: &'a [u8],
    /// Distance between pixels, bytes.
    pub(super) step: usize,
}

impl Lumas<'_> {
    /// No pixels.
    pub const NONE: Self = Self { bytes: &[], step: 1 };

    /// Luma of the pixel with an index; 0 beyond the frame.
    #[inline(always)]
    #[must_use]
    pub fn get(&self, at: u16) -> u8 {
        self.bytes.get(usize::from(at) * self.step).copied().unwrap_or_default()
    }

    /// Bytes of eight consecutive pixels of a row, each luma first; `None` for a column or near the end of a row.
    #[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
    #[inline(always)]
    pub(crate) fn eight(&self, from: u16) -> Option<&[u8; 16]> {
        let first = 2 * usize::from(from);
        self.bytes.get(first..first + 16).filter(|_| self.step == 2)?.try_into().ok()
    }

    /// Bytes from each pixel on, the first its luma, beginning at an index and ending near the end of the frame.
    ///
    /// For the first of eight columns that are `GAP` bytes apart, 7 × `GAP` + 1 bytes contain the luma of all.
    #[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
    #[inline(always)]
    pub(crate) fn spans<const SPAN: usize>(&self, first: u16) -> impl Iterator<Item = &[u8; SPAN]> {
        let mut rest = self.bytes.get(usize::from(first) * self.step..).unwrap_or(&[]);
        core::iter::from_fn(move || {
            let span = rest.first_chunk()?;
            rest = rest.get(self.step..).unwrap_or(&[]);
            Some(span)
        })
    }

    /// Distance of the first pixels of columns or rows, bytes, if it is the same for all neighbours; otherwise 0.
    #[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
    pub(crate) fn common_gap(all: &[Self; 8]) -> usize {
        let gap = |at: usize| all[at].bytes.len().saturating_sub(all[at + 1].bytes.len());
        if (1..7).all(|at| gap(at) == gap(0)) && !all[7].bytes.is_empty() { gap(0) } else { 0 }
    }
}

/// Pixels of a column.
#[derive(Clone, Copy, Debug)]
pub struct Column<'a> {
    /// Pairs from the column's first one on.
    pub(super) pairs: &'a [[u8; 4]],
    /// Number of pairs in a row.
    pub(super) stride: usize,
    /// Number of rows.
    pub(super) height: u16,
    /// Place of the luma in a pair: 0 for the left pixels of their pairs, 2 for the right ones.
    pub(super) luma: usize,
}

impl<'a> Column<'a> {
    /// Pixel in a row; `None` beyond the frame.
    #[inline(always)]
    #[must_use]
    pub fn pixel(&self, y: u16) -> Option<Pixel> {
        self.pairs.get(usize::from(y) * self.stride).map(|pair| self.of_pair(pair))
    }

    /// Pixels of every second row from the bottom of the frame up to the row `highest` at most.
    #[inline(always)]
    pub(crate) fn upwards(self, highest: u16) -> Upwards<'a> {
        let rows = usize::from(highest) * self.stride..=usize::from(self.height - 1) * self.stride;
        let pairs = self.pairs.get(rows).unwrap_or(&[]);
        Upwards { column: Self { pairs, ..self }, at: pairs.len().wrapping_sub(1), row: self.height + 1 }
    }

    /// Pixels of every second row from the row `lowest` up to the top; otherwise as [`upwards`](Self::upwards).
    #[inline(always)]
    pub(crate) fn upwards_from(self, lowest: u16) -> Upwards<'a> {
        let mut rows = self.upwards(0);
        let skipped = (self.height - 1).saturating_sub(lowest) / 2 * 2;
        rows.at = rows.at.wrapping_sub(usize::from(skipped) * self.stride);
        rows.row -= skipped;
        rows
    }

    #[inline(always)]
    #[expect(clippy::trivially_copy_pass_by_ref, reason = "a copy would be stored before it is indexed")]
    fn of_pair(&self, pair: &[u8; 4]) -> Pixel {
        Pixel { y: pair[self.luma & 2], cb: pair[1], cr: pair[3] }
    }
}

/// Pixels of every second row from the bottom of a frame, with their rows.
pub(crate) struct Upwards<'a> {
    column: Column<'a>,
    /// Index of the next pair; above the first pair it exceeds all others.
    at: usize,
    /// Row of the last pixel.
    row: u16,
}

impl Iterator for Upwards<'_> {
    type Item = (u16, Pixel);

    #[inline(always)]
    fn next(&mut self) -> Option<(u16, Pixel)> {
        let pair = self.column.pairs.get(self.at)?;
        self.at = self.at.wrapping_sub(2 * self.column.stride);
        self.row -= 2;
        Some((self.row, self.column.of_pair(pair)))
    }
}

/// Pixels of a row or a column, which are read in the same way.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Strip<'a> {
    /// Pairs from the first one on.
    pub(super) pairs: &'a [[u8; 4]],
    /// Distance between pairs of the strip.
    pub(super) stride: usize,
    /// 1 if two neighbouring pixels of the strip are a pair, otherwise 0.
    pub(super) shared: u16,
    /// 1 for a column of right pixels, otherwise 0.
    pub(super) right: u16,
}

impl Strip<'_> {
    /// Pixel with an index; `None` beyond the frame.
    #[inline(always)]
    pub(crate) fn pixel(&self, at: u16) -> Option<Pixel> {
        let [left, cb, right, cr] = *self.pairs.get(usize::from(at >> self.shared) * self.stride)?;
        Some(Pixel { y: if at & self.shared | self.right == 0 { left } else { right }, cb, cr })
    }
}
