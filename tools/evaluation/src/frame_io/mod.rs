//! Recorded images: files of a folder, converted to YUYV frames.

mod jpeg;
mod raw;

use std::fs;
use std::path::{Path, PathBuf};

use bica_app::Failure;
use bica_drawing::png::{self, Picture};
use bica_motion::robot::{CameraId, Image};

/// Lists the images of a folder in the order of their names.
///
/// # Errors
/// If the folder cannot be read or holds no image.
pub fn list(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let help = "name a folder with PNG, JPEG or raw images (NAME_WxH.yuyv)";
    let entries = fs::read_dir(folder).map_err(|error| Failure::of_path("read the folder", folder, &error, help))?;
    let is_image = |path: &PathBuf| Format::of(path).is_some();
    let mut files: Vec<PathBuf> = entries.filter_map(|entry| Some(entry.ok()?.path())).filter(is_image).collect();
    if files.is_empty() {
        return Err(Failure::new(format!("there is no image in `{}`", folder.display()), help));
    }
    files.sort();
    Ok(files)
}

/// Returns the name of an image as in files of poses and labels: without folder and extension and, for a raw image,
/// without the size.
#[must_use]
pub fn stem(name: &str) -> &str {
    let name = name.rsplit('/').next().unwrap_or(name);
    let (stem, ending) = name.rsplit_once('.').unwrap_or((name, ""));
    let sized = stem.rsplit_once('_').filter(|_| ending.eq_ignore_ascii_case("yuyv"));
    sized.map_or(stem, |(stem, _)| stem)
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Format {
    Png,
    Jpeg,
    Raw,
}

impl Format {
    fn of(path: &Path) -> Option<Self> {
        Some(match path.extension()?.to_ascii_lowercase().to_str()? {
            "png" => Self::Png,
            "jpg" | "jpeg" => Self::Jpeg,
            "yuyv" => Self::Raw,
            _ => return None,
        })
    }
}

/// Recorded image.
#[derive(Debug)]
pub struct RecordedFrame {
    width: u16,
    height: u16,
    yuyv: Vec<u8>,
}

impl RecordedFrame {
    /// Reads a file; its extension determines the format.
    ///
    /// # Errors
    /// The reason why the file cannot be read, as a text that follows "skipped,".
    pub fn read(path: &Path) -> Result<Self, String> {
        let picture = match Format::of(path) {
            Some(Format::Raw) => return raw::read(path),
            Some(Format::Jpeg) => jpeg::read(path)?,
            Some(Format::Png) | None => png::read(path).map_err(|error| format!("broken: {error}"))?,
        };
        let size = u16::try_from(picture.width).ok().zip(u16::try_from(picture.height).ok());
        let (width, height) =
            size.ok_or_else(|| format!("{}×{} pixels are too many", picture.width, picture.height))?;
        Ok(Self { width, height, yuyv: yuyv(&picture) })
    }

    /// Returns the image as sensor input.
    #[must_use]
    pub fn image(&self) -> Image<'_> {
        Image { camera: CameraId::Top, width: self.width, height: self.height, yuyv: &self.yuyv }
    }
}

/// Converts to full-range BT.601; two pixels share their mean chroma, and an odd last column is dropped.
fn yuyv(picture: &Picture) -> Vec<u8> {
    let rows = picture.rgb.chunks_exact(picture.width.max(1));
    let pairs = rows.flat_map(|row| row.as_chunks::<2>().0).map(|&[left, right]| {
        let (a, b) = (ycc(left), ycc(right));
        [a[0], 0.5 * (a[1] + b[1]), b[0], 0.5 * (a[2] + b[2])].map(|value| value.round() as u8)
    });
    pairs.collect::<Vec<_>>().into_flattened()
}

fn ycc(rgb: [u8; 3]) -> [f32; 3] {
    let [r, g, b] = rgb.map(f32::from);
    let y = 0.299 * r + 0.587 * g + 0.114 * b;
    [y, (b - y) / 1.772 + 128.0, (r - y) / 1.402 + 128.0]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rgb_of_yuyv_colour_converts_back_to_it() {
        let (y, cb, cr) = (120.0_f32, 90.0_f32, 170.0_f32);
        let (b, r) = (cb - 128.0, cr - 128.0);
        let rgb = [y + 1.402 * r, y - 0.344_136 * b - 0.714_136 * r, y + 1.772 * b].map(|v| v.round() as u8);
        let back = yuyv(&Picture { width: 2, height: 1, rgb: vec![rgb; 2] });
        for (value, expected) in back.iter().zip([120_u8, 90, 120, 170]) {
            assert!(value.abs_diff(expected) <= 1, "{back:?}");
        }
    }

    #[test]
    fn stem_has_no_folder_extension_or_size() {
        let names = ["a/008.png", "008_640x240.yuyv", "008.jpeg", "hall_2.png", "a.b.png", "x"];
        assert_eq!(names.map(stem), ["008", "008", "008", "hall_2", "a.b", "x"]);
    }
}
