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
        let (color, bytes_of_pixel, width, height) = match record.format {
            Format::Yuyv { width, height } => (ColorType::Ycbcr, 2, width, height),
            Format::Gray8 { width, height } => (ColorType::Luma, 1, width, height),
            Format::Rgb8 { width, height } => (ColorType::Rgb, 3, width, height),
            Format::Jpeg => return Some(Self { jpeg: record.stored.to_vec(), scale: 1.0, frame, ..Self::default() }),
            _ => return None,
        };
        let (width, height) = (usize::from(width), usize::from(height));
        let stored = record.decode(coder)?;
        let by = width.div_ceil(MAX_WIDTH).max(1);
        let (small, low) = (width / by, height / by);
        if stored.bytes.len() != bytes_of_pixel * width * height || small * low == 0 {
            return None;
        }
        let part = |x: usize, y: usize, channel: usize| match bytes_of_pixel {
            // Two pixels in four bytes `Y0 Cb Y1 Cr`.
            2 if channel > 0 => stored.bytes[2 * (y * width + x / 2 * 2) + 2 * channel - 1],
            count => stored.bytes[count * (y * width + x) + channel],
        };
        let channels = if color == ColorType::Luma { 1 } else { 3 };
        let mut pixels = Vec::with_capacity(channels * small * low);
        for (y, x) in (0..low).flat_map(|y| (0..small).map(move |x| (by * y, by * x))) {
            for channel in 0..channels {
                let block = (0..by * by).map(|at| u32::from(part(x + at % by, y + at / by, channel)));
                pixels.push((block.sum::<u32>() / (by * by) as u32) as u8);
            }
        }
        let mut jpeg = Vec::new();
        Encoder::new(&mut jpeg, QUALITY).encode(&pixels, small as u16, low as u16, color).ok()?;
        Some(Self { jpeg, width: small as u32, height: low as u32, scale: 1.0 / by as f64, frame })
    }
}
