//! Images of a recording, in its file.

use std::path::{Path, PathBuf};

use bica::{Blob, Format};
use bica_recording::BlobPlace;

use crate::program::Image;
use crate::protocol::Failed;

/// Index of the images of a recording, which stay in its file.
#[derive(Debug, Default)]
pub(super) struct Recorded {
    pub(super) path: PathBuf,
    /// Number of the image, time of its cycle, µs, and place; in order of time.
    pub(super) places: Vec<(u32, u64, BlobPlace)>,
}

impl Recorded {
    /// Returns number, time and place of the last image that is not later than a time, µs.
    pub(super) fn at(&self, time_us: u64) -> Option<(u32, u64, BlobPlace)> {
        let end = self.places.partition_point(|(_, time, _)| *time <= time_us);
        self.places.get(end.checked_sub(1)?).copied()
    }

    pub(super) fn get(&self, number: u32) -> Option<(u32, u64, BlobPlace)> {
        let index = self.places.binary_search_by_key(&number, |(number, ..)| *number).ok()?;
        self.places.get(index).copied()
    }
}

/// Reads an image from the file of a recording.
pub(super) fn read_image(path: &Path, (number, time_us, place): (u32, u64, BlobPlace)) -> Result<Image, Failed> {
    let read = place.read(path);
    let image = read.map_err(|error| Failed::new(format!("image {number}: {error}"), error.help()))?;
    let Blob { format: Format::Yuyv { width, height }, frame, .. } = image.blob() else {
        return Err(Failed::new(format!("image {number} is not in YUYV"), "export the recording to look at it"));
    };
    if image.bytes.len() != 2 * usize::from(width) * usize::from(height) {
        return Err(Failed::new(format!("image {number} does not have the pixels of its size"), "record it again"));
    }
    Ok(Image { number, time_us, camera: frame.into(), width, height, yuyv: image.bytes.into() })
}
