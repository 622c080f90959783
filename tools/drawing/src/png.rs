//! PNG files.

use std::fs::File;
use std::io::{BufReader, BufWriter, Write};
use std::path::Path;

use super::canvas::Canvas;

/// Writes a picture.
///
/// # Errors
/// If the file cannot be written.
pub fn write(path: &Path, canvas: &Canvas) -> Result<(), png::EncodingError> {
    encode_to(BufWriter::new(File::create(path)?), canvas)
}

/// Returns a picture as the bytes of a file.
///
/// # Errors
/// If the picture is empty.
pub fn encode(canvas: &Canvas) -> Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Vec::new();
    encode_to(&mut bytes, canvas)?;
    Ok(bytes)
}

fn encode_to(out: impl Write, canvas: &Canvas) -> Result<(), png::EncodingError> {
    let mut encoder = png::Encoder::new(out, canvas.width() as u32, canvas.height() as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::Fast);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(canvas.bytes())?;
    writer.finish()
}

/// Picture of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Width, px.
    pub width: usize,
    /// Height, px.
    pub height: usize,
    /// Red, green, blue of each pixel, row by row.
    pub rgb: Vec<[u8; 3]>,
}

/// Reads a picture of any colour type; grey becomes RGB, transparency is dropped, 16 bits become 8.
///
/// # Errors
/// If the file cannot be read or is no complete PNG.
pub fn read(path: &Path) -> Result<Picture, png::DecodingError> {
    let mut decoder = png::Decoder::new(BufReader::new(File::open(path)?));
    decoder.set_transformations(png::Transformations::normalize_to_color8());
    let mut reader = decoder.read_info()?;
    let mut bytes = vec![0; reader.output_buffer_size().ok_or(png::DecodingError::LimitsExceeded)?];
    let frame = reader.next_frame(&mut bytes)?;
    reader.finish()?;
    let samples = frame.color_type.samples();
    let rgb = bytes[..frame.buffer_size()]
        .chunks_exact(samples)
        .map(|pixel| if samples < 3 { [pixel[0]; 3] } else { [pixel[0], pixel[1], pixel[2]] })
        .collect();
    Ok(Picture { width: frame.width as usize, height: frame.height as usize, rgb })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn written_picture_is_read_back_unchanged() {
        let path = std::env::temp_dir().join(format!("bica-player-{}.png", std::process::id()));
        let mut canvas = Canvas::new(3, 2, [1, 2, 3]);
        canvas.set(2, 1, [250, 0, 7]);
        write(&path, &canvas).unwrap();
        let back = read(&path);
        std::fs::remove_file(&path).unwrap();
        let Picture { width, height, rgb } = back.unwrap();
        assert_eq!((width, height, rgb.as_flattened()), (3, 2, canvas.bytes()));
    }
}
