//! What a camera's thread needs of a device.

use std::io;
use std::time::Duration;

/// Width of the images, px.
pub(crate) const WIDTH: u16 = 640;
/// Height of the images, px.
pub(crate) const HEIGHT: u16 = 480;
/// Bytes of an image, YUYV 4:2:2.
pub(crate) const BYTES: usize = 2 * WIDTH as usize * HEIGHT as usize;
/// Time without a usable image after which a camera is closed and opened again.
pub(crate) const STALL: Duration = Duration::from_millis(500);

/// Opened camera. After an error it is not used any more: the caller closes it, and opens it again.
pub(crate) trait Device {
    /// Waits for the next image, at most [`STALL`], and copies it.
    ///
    /// # Errors
    /// If there is no image in this time, or the device fails.
    fn next(&mut self) -> io::Result<Picture>;
}

/// Image as the device gives it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Picture {
    /// When it was taken, of `CLOCK_MONOTONIC`.
    pub(crate) taken: Duration,
    /// Whether the driver has found an error in the pixels.
    pub(crate) is_damaged: bool,
    /// YUYV 4:2:2.
    pub(crate) pixels: Vec<u8>,
}

impl Picture {
    /// Whether it has the expected size, and no error.
    pub(crate) const fn is_usable(&self) -> bool {
        !self.is_damaged && self.pixels.len() == BYTES
    }
}
