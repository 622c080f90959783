//! The newest camera image.

use core::fmt;

use bica::prelude::*;
use bica_motion::joints::Joints;
use bica_motion::robot::{CameraId, Image};

/// Bytes of the largest image: 640×480 pixels in YUYV 4:2:2, 160×120 with the feature `small-frames`.
pub const IMAGE_BYTES: usize = if cfg!(feature = "small-frames") { 160 * 120 * 2 } else { 640 * 480 * 2 };

/// Memory of the pixels. With the feature `small-frames` it is borrowed ([`CameraInput::set_buffer`]): in the tree it
/// would also occupy flash, because the tree's initial value is stored there.
#[cfg(feature = "small-frames")]
type Buffer = &'static mut [u8];
#[cfg(not(feature = "small-frames"))]
type Buffer = [u8; IMAGE_BYTES];

/// The newest camera image, with the joint angles at which it was taken.
pub struct CameraInput {
    camera: CameraId,
    width: u16,
    height: u16,
    count: u32,
    angles: Joints<f32>,
    yuyv: Buffer,
}

/// Error: the image is larger than the buffer; the previous image was kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FrameTooLarge {
    /// Size of the rejected image, bytes.
    pub bytes: usize,
}

impl fmt::Display for FrameTooLarge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "an image has {} bytes, the buffer {IMAGE_BYTES}: select a smaller image size", self.bytes)
    }
}

impl core::error::Error for FrameTooLarge {}

#[component(budget_us = 1)]
impl CameraInput {
    /// Creates the component without an image.
    #[must_use]
    #[cfg_attr(
        not(feature = "small-frames"),
        expect(clippy::large_stack_arrays, reason = "const: trees are created in a static or a box")
    )]
    pub const fn new() -> Self {
        Self {
            camera: CameraId::Top,
            width: 0,
            height: 0,
            count: 0,
            angles: Joints([0.0; bica_motion::joints::JOINTS]),
            #[cfg(feature = "small-frames")]
            yuyv: &mut [],
            #[cfg(not(feature = "small-frames"))]
            yuyv: [0; IMAGE_BYTES],
        }
    }

    /// Sets the memory for images; without it no image fits.
    #[cfg(feature = "small-frames")]
    pub fn set_buffer(&mut self, buffer: &'static mut [u8; IMAGE_BYTES]) {
        self.yuyv = buffer;
    }

    /// Copies a new image and the joint angles (rad) at which it was taken.
    ///
    /// # Errors
    /// [`FrameTooLarge`] if it does not fit; the previous image is kept.
    pub fn receive(&mut self, image: &Image<'_>, angles: &Joints<f32>) -> Result<(), FrameTooLarge> {
        let bytes = image.yuyv.len();
        let buffer = self.yuyv.get_mut(..bytes).ok_or(FrameTooLarge { bytes })?;
        buffer.copy_from_slice(image.yuyv);
        (self.camera, self.width, self.height) = (image.camera, image.width, image.height);
        self.angles = *angles;
        self.count = self.count.wrapping_add(1);
        Ok(())
    }

    /// Number of images so far; it identifies the newest one.
    #[info]
    #[must_use]
    pub const fn count(&self) -> u32 {
        self.count
    }

    /// Camera that took the newest image.
    #[info]
    const fn camera(&self) -> CameraId {
        self.camera
    }

    /// Width and height of the newest image.
    #[info(unit = "px")]
    const fn size(&self) -> (u16, u16) {
        (self.width, self.height)
    }

    /// The joint angles when the image was taken, rad.
    #[must_use]
    pub const fn angles(&self) -> &Joints<f32> {
        &self.angles
    }

    /// The newest image; 0×0 before the first one.
    #[must_use]
    pub fn image(&self) -> Image<'_> {
        let bytes = 2 * usize::from(self.width) * usize::from(self.height);
        Image {
            camera: self.camera,
            width: self.width,
            height: self.height,
            yuyv: &self.yuyv[..bytes.min(self.yuyv.len())],
        }
    }
}
