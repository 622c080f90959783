//! Camera images, and image files of a program.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use bica_wire::model::Invalid;

/// A camera image.
#[derive(Clone, Debug)]
pub struct Image {
    /// Number in the session, from 0.
    pub number: u32,
    /// Time of the cycle that received the image, µs.
    pub time_us: u64,
    /// Name of the camera; empty if it is unknown.
    pub camera: Arc<str>,
    /// Width, px.
    pub width: u16,
    /// Height, px.
    pub height: u16,
    /// Pixels in YUYV 4:2:2.
    pub yuyv: Arc<[u8]>,
}

/// Image files that a program can read. They are shown as a session.
pub trait ImageFiles: Send + Sync {
    /// Name of the session.
    fn name(&self) -> String;

    /// Lists the files, in order.
    ///
    /// # Errors
    /// If the folder cannot be read.
    fn list(&self) -> Result<Vec<PathBuf>, Invalid>;

    /// Reads a file. Returns width and height, px, and the pixels in YUYV 4:2:2.
    ///
    /// # Errors
    /// The reason why the file is skipped.
    fn read(&self, file: &Path) -> Result<(u16, u16, Vec<u8>), String>;
}
