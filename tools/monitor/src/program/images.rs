//! Images outside robots and recordings.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use bica_wire::model::Invalid;

/// A camera image.
#[derive(Clone, Debug)]
pub struct Image {
    /// Number in the session, from 0.
    pub number: u32,
    /// Time of the cycle that took it in, µs.
    pub time_us: u64,
    /// Name of the camera that took it; empty if it is unknown.
    pub camera: Arc<str>,
    /// Width, px.
    pub width: u16,
    /// Height, px.
    pub height: u16,
    /// YUYV 4:2:2.
    pub yuyv: Arc<[u8]>,
}

/// Files of images that a program can read, which are shown as a session.
pub trait ImageFiles: Send + Sync {
    /// Name of the session.
    fn name(&self) -> String;

    /// Lists the files, in order.
    ///
    /// # Errors
    /// If the folder cannot be read.
    fn list(&self) -> Result<Vec<PathBuf>, Invalid>;

    /// Reads a file: width, height, px, and the pixels in YUYV 4:2:2.
    ///
    /// # Errors
    /// Why it is skipped.
    fn read(&self, file: &Path) -> Result<(u16, u16, Vec<u8>), String>;
}
