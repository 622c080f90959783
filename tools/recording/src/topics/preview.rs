//! Small JPEG images.

use bica::Format;
use jpeg_encoder::{ColorType, Encoder};

use crate::blob::BlobRecord;
use crate::image_codec::ImageCoder;

/// Largest width of a preview, px.
const MAX_WIDTH: usize = 320;
/// Quality, 1 to 100.
const QUALITY: u8 = 70;

/// An image, coded as JPEG.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Preview {
    pub(super) jpeg: Vec<u8>,
    pub(super) width: u32,
    pub(super) height: u32,
    /// Size divided by that of the recorded image.
    pub(super) scale: f64,
    /// Name of the frame in which the image was measured.
    pub(super) frame: String,
}

/// Returns whether large data is an image of which there can be a preview.
pub(super) const fn is_image(format: Format<'_>) -> bool {
    matches!(format, Format::Yuyv { .. } | Format::Gray8 { .. } | Format::Rgb8 { .. } | Format::Jpeg)
}

impl Preview {
    /// Codes a recorded image; `None` if it is none, or damaged. One that is coded already keeps its size.
    pub(super) fn new(record: &BlobRecord<'_>, coder: &mut ImageCoder) -> Option<Self> {
        let frame = record.frame.to_owned();
        if record.format == Format::Jpeg {
            return Some(Self { jpeg: record.stored.to_vec(), scale: 1.0, frame, ..Self::default() });
        }
        let stored = is_image(record.format).then(|| record.decode(coder))??;
        let Jpeg { data, width, height, scale } = jpeg(record.format, &stored.bytes, MAX_WIDTH)?;
        Some(Self { jpeg: data, width, height, scale, frame })
    }
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

/// Codes an image as JPEG, smaller by a whole number if it is wider than `max_width`, px. Returns `None` if the pixels are no image
/// of this format.
#[must_use]
pub fn jpeg(format: Format<'_>, pixels: &[u8], max_width: usize) -> Option<Jpeg> {
    let (color, bytes_of_pixel, width, height) = match format {
        Format::Yuyv { width, height } => (ColorType::Ycbcr, 2, width, height),
        Format::Gray8 { width, height } => (ColorType::Luma, 1, width, height),
        Format::Rgb8 { width, height } => (ColorType::Rgb, 3, width, height),
        _ => return None,
    };
    let (width, height) = (usize::from(width), usize::from(height));
    let by = width.div_ceil(max_width).max(1);
    let (small, low) = (width / by, height / by);
    if pixels.len() != bytes_of_pixel * width * height || small * low == 0 {
        return None;
    }
    let part = |x: usize, y: usize, channel: usize| match bytes_of_pixel {
        // Two pixels in four bytes `Y0 Cb Y1 Cr`.
        2 if channel > 0 => pixels[2 * (y * width + x / 2 * 2) + 2 * channel - 1],
        count => pixels[count * (y * width + x) + channel],
    };
    let channels = if color == ColorType::Luma { 1 } else { 3 };
    let mut small_pixels = Vec::with_capacity(channels * small * low);
    for (y, x) in (0..low).flat_map(|y| (0..small).map(move |x| (by * y, by * x))) {
        for channel in 0..channels {
            let block = (0..by * by).map(|at| u32::from(part(x + at % by, y + at / by, channel)));
            small_pixels.push((block.sum::<u32>() / (by * by) as u32) as u8);
        }
    }
    let mut data = Vec::new();
    Encoder::new(&mut data, QUALITY).encode(&small_pixels, small as u16, low as u16, color).ok()?;
    Some(Jpeg { data, width: small as u32, height: low as u32, scale: 1.0 / by as f64 })
}
