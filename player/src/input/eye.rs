//! The camera image.

use core::fmt;

use bica::prelude::*;
use bica_motion::joints::Joints;
use bica_motion::robot::{CameraId, Image};

/// Bytes that the largest image takes: 640×480 pixels in YUYV 4:2:2, 160×120 with the feature `small-frames`.
pub const EYE_BYTES: usize = if cfg!(feature = "small-frames") { 160 * 120 * 2 } else { 640 * 480 * 2 };

/// Where the pixels lie: with the feature `small-frames` in memory that somebody lends ([`Eye::lend`]), since a
/// microcontroller that held them in the tree would keep their zeros in its program too.
#[cfg(feature = "small-frames")]
type Room = &'static mut [u8];
#[cfg(not(feature = "small-frames"))]
type Room = [u8; EYE_BYTES];

/// The newest camera image, with the joint angles at which it was taken.
pub struct Eye {
    camera: CameraId,
    width: u16,
    height: u16,
    count: u32,
    angles: Joints<f32>,
    yuyv: Room,
}

/// An image was larger than the eye's memory; the one before it was kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FrameTooLarge {
    /// Bytes that came.
    pub bytes: usize,
}

impl fmt::Display for FrameTooLarge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "an image of {} bytes came, the eye holds {EYE_BYTES}: ask the camera for a smaller one", self.bytes)
    }
}

impl core::error::Error for FrameTooLarge {}

#[component(budget_us = 1)]
impl Eye {
    /// An eye that has seen nothing yet.
    #[must_use]
    #[cfg_attr(
        not(feature = "small-frames"),
        expect(clippy::large_stack_arrays, reason = "const: trees are built in a static or a box")
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
            yuyv: [0; EYE_BYTES],
        }
    }

    /// Gives the eye memory for its images, [`EYE_BYTES`] of it; without, no image fits.
    #[cfg(feature = "small-frames")]
    pub fn lend(&mut self, room: &'static mut [u8; EYE_BYTES]) {
        self.yuyv = room;
    }

    /// Takes a new image and the joint angles of its moment.
    ///
    /// # Errors
    /// [`FrameTooLarge`] if it does not fit; the last image stays.
    pub fn see(&mut self, image: &Image<'_>, angles: &Joints<f32>) -> Result<(), FrameTooLarge> {
        let bytes = image.yuyv.len();
        let room = self.yuyv.get_mut(..bytes).ok_or(FrameTooLarge { bytes })?;
        room.copy_from_slice(image.yuyv);
        (self.camera, self.width, self.height) = (image.camera, image.width, image.height);
        self.angles = *angles;
        self.count = self.count.wrapping_add(1);
        Ok(())
    }

    /// How many images came so far: tells a new one from one already looked at.
    #[must_use]
    pub const fn count(&self) -> u32 {
        self.count
    }

    /// The joint angles when the image was taken, rad.
    #[must_use]
    pub const fn angles(&self) -> &Joints<f32> {
        &self.angles
    }

    /// The image; 0×0 before the first one came.
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
