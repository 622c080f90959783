//! Camera frame, borrowed without copying: YUYV 4:2:2, two pixels in four bytes.
//!
//! Pixel coordinates: `x` to the right, `y` down, the centre of the first pixel is (0, 0). Access to a pixel is a
//! bounds check and a load.

mod strips;

use bica_motion::robot::Image;
use glam::Vec2;

pub(crate) use self::strips::Strip;
pub use self::strips::{Column, Lumas};

/// Minimum width and height of a frame, px.
pub const MIN_SIDE: u16 = 16;
/// Maximum width of a frame, px.
pub const MAX_WIDTH: u16 = 1280;
/// Maximum height of a frame, px.
pub const MAX_HEIGHT: u16 = 960;

/// Reason why bytes are not a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FrameError {
    /// Two pixels share their chroma, so the width must be even.
    OddWidth(u16),
    /// Width or height is outside [`MIN_SIDE`] … [`MAX_WIDTH`] × [`MAX_HEIGHT`].
    Size(u16, u16),
    /// The number of bytes is not two per pixel.
    Length {
        /// Number of bytes of a frame of this size.
        expected: usize,
        /// Number of bytes given.
        found: usize,
    },
}

impl core::fmt::Display for FrameError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match *self {
            Self::OddWidth(width) => write!(f, "a YUYV frame needs an even width, found {width}"),
            Self::Size(width, height) => write!(
                f,
                "a frame of {width}×{height} pixels is outside {MIN_SIDE}×{MIN_SIDE} … {MAX_WIDTH}×{MAX_HEIGHT}"
            ),
            Self::Length { expected, found } => write!(f, "the frame needs {expected} bytes, found {found}"),
        }
    }
}

impl core::error::Error for FrameError {}

/// Colour of one pixel, full-range BT.601.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pixel {
    /// Luma, 0 (black) to 255 (white).
    pub y: u8,
    /// Blue-difference chroma; 128 is grey.
    pub cb: u8,
    /// Red-difference chroma; 128 is grey.
    pub cr: u8,
}

impl Pixel {
    /// Creates a pixel from its components.
    #[must_use]
    pub const fn new(y: u8, cb: u8, cr: u8) -> Self {
        Self { y, cb, cr }
    }
}

/// Pair of neighbouring pixels with shared chroma: the bytes `Y0 Cb Y1 Cr`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(transparent)]
pub struct Pair(pub [u8; 4]);

impl Pair {
    /// Mean pixel of the pair; luma is rounded down.
    #[inline(always)]
    #[must_use]
    pub const fn mean(self) -> Pixel {
        let [y0, cb, y1, cr] = self.0;
        Pixel { y: u8::midpoint(y0, y1), cb, cr }
    }
}

/// Borrowed frame of [`MIN_SIDE`] to [`MAX_WIDTH`] × [`MAX_HEIGHT`] px.
#[derive(Clone, Copy, Debug)]
pub struct Frame<'a> {
    pairs: &'a [[u8; 4]],
    width: u16,
    height: u16,
}

impl<'a> Frame<'a> {
    /// Borrows `yuyv` as a frame of `width` × `height` pixels.
    ///
    /// # Errors
    /// If the size is out of range, the width odd or the number of bytes not `2 * width * height`.
    pub fn new(width: u16, height: u16, yuyv: &'a [u8]) -> Result<Self, FrameError> {
        if !width.is_multiple_of(2) {
            return Err(FrameError::OddWidth(width));
        }
        if !(MIN_SIDE..=MAX_WIDTH).contains(&width) || !(MIN_SIDE..=MAX_HEIGHT).contains(&height) {
            return Err(FrameError::Size(width, height));
        }
        let expected = 2 * usize::from(width) * usize::from(height);
        if yuyv.len() != expected {
            return Err(FrameError::Length { expected, found: yuyv.len() });
        }
        Ok(Self { pairs: yuyv.as_chunks().0, width, height })
    }

    /// Borrows a robot's camera image as a frame.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn from_image(image: &Image<'a>) -> Result<Self, FrameError> {
        Self::new(image.width, image.height, image.yuyv)
    }

    /// Width, px.
    #[must_use]
    pub const fn width(&self) -> u16 {
        self.width
    }

    /// Height, px.
    #[must_use]
    pub const fn height(&self) -> u16 {
        self.height
    }

    /// Pixel pairs of a row from the left; empty for a row outside the frame.
    #[inline]
    #[must_use]
    pub fn row(&self, y: u16) -> &'a [[u8; 4]] {
        let pairs = usize::from(self.width / 2);
        let start = usize::from(y) * pairs;
        self.pairs.get(start..start + pairs).unwrap_or(&[])
    }

    /// Luma of a row from the left; empty for a row outside the frame.
    #[inline]
    #[must_use]
    pub fn luma_row(&self, y: u16) -> Lumas<'a> {
        Lumas { bytes: self.row(y).as_flattened(), step: 2 }
    }

    /// Luma of a column from the top; empty for a column outside the frame.
    #[inline]
    #[must_use]
    pub fn luma_column(&self, x: u16) -> Lumas<'a> {
        let first = if x < self.width { 2 * usize::from(x) } else { usize::MAX };
        Lumas { bytes: self.pairs.as_flattened().get(first..).unwrap_or(&[]), step: 2 * usize::from(self.width) }
    }

    /// Pixels of a column from the top; empty for a column outside the frame.
    #[inline]
    #[must_use]
    pub fn column(&self, x: u16) -> Column<'a> {
        let first = if x < self.width { usize::from(x / 2) } else { usize::MAX };
        let pairs = self.pairs.get(first..).unwrap_or(&[]);
        Column { pairs, stride: usize::from(self.width / 2), height: self.height, luma: usize::from(x % 2) * 2 }
    }

    /// Pixels of a row from the left; empty for a row outside the frame.
    #[inline]
    pub(crate) fn strip_of_row(&self, y: u16) -> Strip<'a> {
        Strip { pairs: self.row(y), stride: 1, shared: 1, right: 0 }
    }

    /// Pixels of a column from the top; empty for a column outside the frame.
    #[inline]
    pub(crate) fn strip_of_column(&self, x: u16) -> Strip<'a> {
        let Column { pairs, stride, .. } = self.column(x);
        Strip { pairs, stride, shared: 0, right: x % 2 }
    }

    /// Pixel at (x, y); `None` outside the frame.
    #[inline]
    #[must_use]
    pub fn pixel(&self, x: i32, y: i32) -> Option<Pixel> {
        if x < 0 || x >= i32::from(self.width) || y < 0 || y >= i32::from(self.height) {
            return None;
        }
        let [y0, cb, y1, cr] = *self.pairs.get(y as usize * usize::from(self.width / 2) + x as usize / 2)?;
        Some(Pixel { y: if x % 2 == 0 { y0 } else { y1 }, cb, cr })
    }

    /// Pixel nearest to a point; `None` outside the frame.
    #[inline]
    #[must_use]
    pub fn nearest(&self, at: Vec2) -> Option<Pixel> {
        let (x, y) = self.place(at)?;
        let [y0, cb, y1, cr] = *self.pairs.get(y * usize::from(self.width / 2) + x / 2)?;
        Some(Pixel { y: if x % 2 == 0 { y0 } else { y1 }, cb, cr })
    }

    /// Luma of the pixel nearest to a point; `None` outside the frame.
    #[inline]
    pub(crate) fn nearest_luma(&self, at: Vec2) -> Option<u8> {
        if cfg!(not(any(target_arch = "x86_64", target_arch = "aarch64"))) {
            // A microcontroller has little room for a second function.
            return self.nearest(at).map(|pixel| pixel.y);
        }
        let (x, y) = self.place(at)?;
        self.pairs.as_flattened().get(2 * (y * usize::from(self.width) + x)).copied()
    }

    /// Column and row of the pixel nearest to a point, the row possibly below the frame.
    #[inline(always)]
    fn place(&self, at: Vec2) -> Option<(usize, usize)> {
        // For non-negative values truncation equals the floor and costs less; on x86 truncation to 16 bits costs least.
        let at = at + 0.5;
        let (x, y) = (at.x as u16, at.y as u16);
        (at.x >= 0.0 && at.y >= 0.0 && x < self.width).then_some((x.into(), y.into()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixel_has_values_of_its_bytes() {
        let mut bytes = [0; 2 * 16 * 16];
        bytes[2 * (16 * 5 + 6)..][..4].copy_from_slice(&[10, 20, 30, 40]);
        let frame = Frame::new(16, 16, &bytes).unwrap();
        assert_eq!(frame.pixel(6, 5), Some(Pixel::new(10, 20, 40)));
        assert_eq!(frame.pixel(7, 5), Some(Pixel::new(30, 20, 40)));
        assert_eq!(Pair(frame.row(5)[3]).mean(), Pixel::new(20, 20, 40));
        assert_eq!(frame.pixel(8, 5), Some(Pixel::new(0, 0, 0)));
        for (x, y) in [(6, 5), (7, 5), (8, 5), (0, 0), (15, 15)] {
            assert_eq!(frame.column(x).pixel(y), frame.pixel(x.into(), y.into()));
            assert_eq!(frame.strip_of_column(x).pixel(y), frame.pixel(x.into(), y.into()));
            assert_eq!(frame.strip_of_row(y).pixel(x), frame.pixel(x.into(), y.into()));
        }
        for (x, highest, rows) in
            [(6, 0, &[15, 13, 11, 9, 7, 5, 3, 1][..]), (7, 4, &[15, 13, 11, 9, 7, 5]), (7, 16, &[])]
        {
            let expected = rows.iter().map(|y| (*y as u16, frame.pixel(x, *y).unwrap()));
            assert!(frame.column(x as u16).upwards(highest).eq(expected));
        }
        for (lowest, rows) in [(u16::MAX, 8), (15, 8), (14, 8), (13, 7), (12, 7), (1, 1), (0, 1)] {
            let expected = frame.column(6).upwards(0).skip(8 - rows);
            assert!(frame.column(6).upwards_from(lowest).eq(expected));
        }
        for (x, y) in [(16, 0), (0, 16), (15, 16), (16, 15), (u16::MAX, 0), (0, u16::MAX)] {
            assert_eq!(frame.column(x).pixel(y), None);
            assert_eq!(frame.strip_of_column(x).pixel(y), None);
            assert_eq!(frame.strip_of_row(y).pixel(x), None);
        }
        for (x, y) in [(-1, 0), (0, -1), (16, 0), (0, 16), (i32::MIN, i32::MAX)] {
            assert_eq!(frame.pixel(x, y), None);
        }
        for (x, y) in [(5.5, 4.5), (6.0, 5.0), (6.4, 5.4)] {
            assert_eq!(frame.nearest(Vec2::new(x, y)), frame.pixel(6, 5));
            assert_eq!(frame.nearest_luma(Vec2::new(x, y)), frame.pixel(6, 5).map(|pixel| pixel.y));
        }
        let nan = f32::NAN;
        for (x, y) in [(-0.6, 0.0), (0.0, -0.6), (15.5, 0.0), (0.0, 15.5), (nan, 0.0), (0.0, nan), (0.0, f32::INFINITY)]
        {
            assert_eq!(frame.nearest(Vec2::new(x, y)), None);
            assert_eq!(frame.nearest_luma(Vec2::new(x, y)), None);
        }
        assert_eq!(frame.nearest(Vec2::splat(-0.5)), frame.pixel(0, 0));
        assert!(frame.row(16).is_empty());
        assert_eq!([6, 7, 8, 16].map(|x| frame.luma_row(5).get(x)), [10, 30, 0, 0]);
        assert_eq!([6, 7].map(|x| frame.luma_column(x).get(5)), [10, 30]);
        assert_eq!([(6, 4), (6, 16), (16, 5)].map(|(x, y)| frame.luma_column(x).get(y)), [0, 0, 0]);
        assert_eq!(frame.luma_row(16).get(0), 0);
    }

    #[test]
    #[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
    fn luma_of_eight_columns_is_that_of_each() {
        let bytes: [u8; 2 * 64 * 16] = core::array::from_fn(|at| (at * 37 % 251) as u8);
        let frame = Frame::new(64, 16, &bytes).unwrap();
        let columns = |pitch: u16| core::array::from_fn(|lane| frame.luma_column(1 + pitch * lane as u16));
        for (pitch, gap) in [(2, 4), (4, 8), (8, 16), (3, 6)] {
            assert_eq!(Lumas::common_gap(&columns(pitch)), gap);
        }
        let first = frame.luma_column(1);
        for at in 0..16 {
            let each = |pitch| columns(pitch).map(|column| Some(column.get(at)));
            assert_eq!(
                [0, 1, 2, 3, 4, 5, 6, 7].map(|lane| first.spans::<29>(at).next().map(|all| all[4 * lane])),
                each(2)
            );
            assert_eq!(
                [0, 1, 2, 3, 4, 5, 6, 7].map(|lane| first.spans::<57>(at).next().map(|all| all[8 * lane])),
                each(4)
            );
            assert_eq!(first.spans::<29>(at).count(), usize::from(16 - at));
        }
        assert_eq!(first.spans::<127>(15).count(), 0);
        let mut uneven = columns(2);
        uneven[3] = frame.luma_column(9);
        assert_eq!(Lumas::common_gap(&uneven), 0);
        uneven = columns(2);
        uneven[7] = Lumas::NONE;
        assert_eq!(Lumas::common_gap(&uneven), 0);
    }

    #[test]
    fn invalid_sizes_and_lengths_are_rejected() {
        let bytes = [0; 2 * 32 * 16];
        assert_eq!(Frame::new(17, 16, &bytes).unwrap_err(), FrameError::OddWidth(17));
        assert_eq!(Frame::new(0, 16, &bytes).unwrap_err(), FrameError::Size(0, 16));
        assert_eq!(Frame::new(2000, 16, &bytes).unwrap_err(), FrameError::Size(2000, 16));
        let wrong = FrameError::Length { expected: 512, found: 1024 };
        assert_eq!(Frame::new(16, 16, &bytes).unwrap_err(), wrong);
    }
}
