//! JPEG files.

use std::fs;
use std::path::Path;

use bica_drawing::png::Picture;
use zune_jpeg::JpegDecoder;
use zune_jpeg::zune_core::bytestream::ZCursor;
use zune_jpeg::zune_core::colorspace::ColorSpace;
use zune_jpeg::zune_core::options::DecoderOptions;

/// Reads a picture; grey becomes RGB.
pub(super) fn read(path: &Path) -> Result<Picture, String> {
    let bytes = fs::read(path).map_err(|error| format!("cannot be read: {error}"))?;
    let options = DecoderOptions::default().jpeg_set_out_colorspace(ColorSpace::RGB).set_strict_mode(true);
    let mut decoder = JpegDecoder::new_with_options(ZCursor::new(bytes), options);
    let rgb = decoder.decode().map_err(|error| format!("broken: {error}"))?;
    let (width, height) = decoder.dimensions().ok_or("broken: it has no size")?;
    Ok(Picture { width, height, rgb: rgb.as_chunks().0.to_vec() })
}
