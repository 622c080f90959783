//! Images of a folder as the camera gave them.

use std::fs;
use std::path::{Path, PathBuf};

use bica_motion::robot::{CameraId, Image};

use crate::program::ending::Failure;
use crate::program::picture::png::{self, Picture};

/// The PNG files of a folder in the order of their names.
pub(crate) fn list(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let mend = "name a folder with PNG images";
    let entries = fs::read_dir(folder).map_err(|error| Failure::of_path("look into", folder, &error, mend))?;
    let is_png = |path: &PathBuf| path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("png"));
    let mut files: Vec<PathBuf> = entries.filter_map(|entry| Some(entry.ok()?.path())).filter(is_png).collect();
    if files.is_empty() {
        return Err(Failure::new(format!("there is no PNG image in `{}`", folder.display()), mend));
    }
    files.sort();
    Ok(files)
}

/// An image as a camera gives it.
pub(crate) struct Recorded {
    width: u16,
    height: u16,
    yuyv: Vec<u8>,
}

impl Recorded {
    /// Reads a PNG file.
    pub(crate) fn read(path: &Path) -> Result<Self, String> {
        let picture = png::read(path).map_err(|error| format!("broken: {error}"))?;
        let size = u16::try_from(picture.width).ok().zip(u16::try_from(picture.height).ok());
        let (width, height) =
            size.ok_or_else(|| format!("{}×{} pixels are too many", picture.width, picture.height))?;
        Ok(Self { width, height, yuyv: yuyv(&picture) })
    }

    /// The image.
    pub(crate) fn image(&self) -> Image<'_> {
        Image { camera: CameraId::Top, width: self.width, height: self.height, yuyv: &self.yuyv }
    }
}

/// Full-range BT.601, two pixels with the mean of their colours; a last odd column is left out.
fn yuyv(picture: &Picture) -> Vec<u8> {
    let rows = picture.rgb.chunks_exact(picture.width.max(1));
    rows.flat_map(|row| row.as_chunks::<2>().0)
        .flat_map(|&[left, right]| {
            let (a, b) = (ycc(left), ycc(right));
            [a[0], 0.5 * (a[1] + b[1]), b[0], 0.5 * (a[2] + b[2])].map(|value| value.round() as u8)
        })
        .collect()
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
    fn colours_come_back_as_the_camera_gave_them() {
        let (y, cb, cr) = (120.0_f32, 90.0_f32, 170.0_f32);
        let (b, r) = (cb - 128.0, cr - 128.0);
        let rgb = [y + 1.402 * r, y - 0.344_136 * b - 0.714_136 * r, y + 1.772 * b].map(|v| v.round() as u8);
        let back = yuyv(&Picture { width: 2, height: 1, rgb: vec![rgb; 2] });
        for (value, wanted) in back.iter().zip([120_u8, 90, 120, 170]) {
            assert!(value.abs_diff(wanted) <= 1, "{back:?}");
        }
    }
}
