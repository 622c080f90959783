//! Raw images as a camera driver delivers them: `NAME_WxH.yuyv`, bytes Y0 Cb Y1 Cr.
//!
//! Some robots read only every second row. Their images are at least twice as wide as high. They are reduced to square
//! pixels: each pair of columns becomes one, so 640×240 is processed as 320×240.

use std::fs;
use std::path::Path;

use super::RecordedFrame;

/// Reads a file.
pub(super) fn read(path: &Path) -> Result<RecordedFrame, String> {
    let (width, height) = size(path).ok_or("its name does not give its size: NAME_WxH.yuyv")?;
    let bytes = fs::read(path).map_err(|error| format!("cannot be read: {error}"))?;
    let expected = 2 * usize::from(width) * usize::from(height);
    if bytes.len() != expected || !width.is_multiple_of(2) {
        return Err(format!("{width}×{height} pixels are {expected} bytes, found {}", bytes.len()));
    }
    if width < 2 * height {
        return Ok(RecordedFrame { width, height, yuyv: bytes });
    }
    let rows = bytes.chunks_exact(2 * usize::from(width));
    Ok(RecordedFrame { width: width / 4 * 2, height, yuyv: rows.flat_map(square).collect() })
}

fn size(path: &Path) -> Option<(u16, u16)> {
    let (width, height) = path.file_stem()?.to_str()?.rsplit_once('_')?.1.split_once('x')?;
    Some((width.parse().ok().filter(|width| *width > 0)?, height.parse().ok()?))
}

/// Converts a row to half its width; an odd last pair is dropped.
fn square(row: &[u8]) -> impl Iterator<Item = u8> {
    row.as_chunks::<8>().0.iter().flat_map(|&[a0, ab, a1, ar, b0, bb, b1, br]| {
        [u8::midpoint(a0, a1), u8::midpoint(ab, bb), u8::midpoint(b0, b1), u8::midpoint(ar, br)]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn square_pixels_average_pairs_of_columns() {
        assert!(square(&[10, 50, 20, 90, 30, 70, 50, 100, 1, 2, 3, 4]).eq([15, 60, 40, 95]));
    }

    #[test]
    fn size_is_parsed_from_name() {
        assert_eq!(size(Path::new("a/b_1_640x240.yuyv")), Some((640, 240)));
        for name in ["640x240.yuyv", "a_640.yuyv", "a_0x240.yuyv", "a_640x-2.yuyv", "a_99999x2.yuyv"] {
            assert_eq!(size(Path::new(name)), None, "{name}");
        }
    }
}
