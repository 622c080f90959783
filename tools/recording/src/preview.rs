//! Small JPEG images.

use bica::Format;
use jpeg_encoder::{Encoder, ImageBuffer, JpegColorType, rgb_to_ycbcr};

/// Largest width of a preview, px.
pub(crate) const MAX_WIDTH: usize = 320;
/// Quality, 1 to 100.
const QUALITY: u8 = 70;

/// Returns whether large data is an image that can have a preview.
pub(crate) const fn is_image(format: Format<'_>) -> bool {
    matches!(format, Format::Yuyv { .. } | Format::Gray8 { .. } | Format::Rgb8 { .. } | Format::Jpeg)
}

/// An image, coded as JPEG.
#[derive(Clone, Debug, PartialEq)]
pub struct Jpeg {
    /// The coded image.
    pub data: Vec<u8>,
    /// Width, px.
    pub width: u32,
    /// Height, px.
    pub height: u32,
    /// Size divided by that of the image that was coded.
    pub scale: f64,
}

/// Codes an image as JPEG, reduced by a whole factor if it is wider than `max_width`, px. Returns `None` if the pixels are no
/// image of this format.
#[must_use]
pub fn jpeg(format: Format<'_>, pixels: &[u8], max_width: usize) -> Option<Jpeg> {
    let (bytes_of_pixel, width, height) = match format {
        Format::Yuyv { width, height } => (2, width, height),
        Format::Gray8 { width, height } => (1, width, height),
        Format::Rgb8 { width, height } => (3, width, height),
        _ => return None,
    };
    let (width, height) = (usize::from(width), usize::from(height));
    let by = width.div_ceil(max_width).max(1);
    let reduced = Reduced { pixels, bytes_of_pixel, width, by, size: [width / by, height / by] };
    let [small, low] = reduced.size;
    if pixels.len() != bytes_of_pixel * width * height || small * low == 0 {
        return None;
    }
    let mut data = Vec::new();
    Encoder::new(&mut data, QUALITY).encode_image(reduced).ok()?;
    Some(Jpeg { data, width: small as u32, height: low as u32, scale: 1.0 / by as f64 })
}

/// An image that is reduced by a whole factor. The encoder reads it row by row: its functions for arrays of pixels are compiled
/// for each of nine layouts.
struct Reduced<'a> {
    pixels: &'a [u8],
    /// 1: grey, 2: YUV 4:2:2 with two pixels in four bytes `Y0 Cb Y1 Cr`, 3: red, green, blue.
    bytes_of_pixel: usize,
    /// Width of the image before, px.
    width: usize,
    /// Number of pixels, along a row and along a column, that become one.
    by: usize,
    /// Width and height, px.
    size: [usize; 2],
}

impl Reduced<'_> {
    fn byte(&self, x: usize, y: usize, channel: usize) -> u8 {
        self.pixels[match self.bytes_of_pixel {
            2 if channel > 0 => 2 * (y * self.width + x / 2 * 2) + 2 * channel - 1,
            count => count * (y * self.width + x) + channel,
        }]
    }

    /// Returns the mean of the pixels that become one.
    fn mean(&self, x: usize, y: usize, channel: usize) -> u8 {
        let by = self.by;
        let block = (0..by * by).map(|at| u32::from(self.byte(by * x + at % by, by * y + at / by, channel)));
        (block.sum::<u32>() / (by * by) as u32) as u8
    }
}

impl ImageBuffer for Reduced<'_> {
    fn get_jpeg_color_type(&self) -> JpegColorType {
        if self.bytes_of_pixel == 1 { JpegColorType::Luma } else { JpegColorType::Ycbcr }
    }

    fn width(&self) -> u16 {
        self.size[0] as u16
    }

    fn height(&self) -> u16 {
        self.size[1] as u16
    }

    fn fill_buffers(&self, y: u16, buffers: &mut [Vec<u8>; 4]) {
        for x in 0..self.size[0] {
            let mean = |channel| self.mean(x, y.into(), channel);
            if self.bytes_of_pixel == 1 {
                buffers[0].push(mean(0));
                continue;
            }
            let [a, b, c] = [mean(0), mean(1), mean(2)];
            let (luma, cb, cr) = if self.bytes_of_pixel == 3 { rgb_to_ycbcr(a, b, c) } else { (a, b, c) };
            buffers.iter_mut().zip([luma, cb, cr]).for_each(|(buffer, value)| buffer.push(value));
        }
    }
}
