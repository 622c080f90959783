//! Camera images on their way from a robot to its monitors.

use std::sync::Arc;

/// A camera image.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Image {
    /// Number of the image since the start of the run, from 0.
    pub number: u32,
    /// Instant of the cycle that received it, µs.
    pub time_us: u64,
    /// Name of its camera; empty if it is unknown.
    pub camera: Arc<str>,
    /// Width, px.
    pub width: u16,
    /// Height, px.
    pub height: u16,
    /// Pixels in YUYV 4:2:2, 2 bytes for each.
    pub yuyv: Arc<Vec<u8>>,
}

impl Image {
    /// Returns the number of bytes of an image with this width and height.
    pub(crate) fn size(&self) -> usize {
        2 * usize::from(self.width) * usize::from(self.height)
    }
}
