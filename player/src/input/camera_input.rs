//! The newest camera image.

use core::fmt;

use bica::prelude::*;
use bica_motion::health::Glimpse;
use bica_motion::joints::Joints;
use bica_motion::robot::{CameraId, Image};

/// Bytes of the largest image: 640×480 pixels in YUYV 4:2:2, 160×120 with the feature `small-frames`, 320×240 with `medium-frames`.
pub const IMAGE_BYTES: usize = if cfg!(feature = "medium-frames") {
    320 * 240 * 2
} else if cfg!(feature = "small-frames") {
    160 * 120 * 2
} else {
    640 * 480 * 2
};

/// Memory of the pixels. With the feature `small-frames` it is lent ([`CameraInput::set_image`]), so that a new image
/// can be written into it without a copy. It is empty while the program has it.
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

    /// Sets a new image, which was written into `memory`, and the joint angles (rad) at which it was taken. Returns the
    /// memory of the previous image; empty if it was taken before.
    #[cfg(feature = "small-frames")]
    #[must_use = "the memory is lost if nobody keeps it"]
    pub const fn set_image(
        &mut self,
        memory: &'static mut [u8],
        camera: CameraId,
        (width, height): (u16, u16),
        angles: &Joints<f32>,
    ) -> &'static mut [u8] {
        (self.camera, self.width, self.height) = (camera, width, height);
        self.angles = *angles;
        self.count = self.count.wrapping_add(1);
        core::mem::replace(&mut self.yuyv, memory)
    }

    /// Takes the memory of the image, for the next one. Until [`Self::set_image`] there is no image: its size is 0×0,
    /// its number stays, and components that have not processed it never will.
    #[cfg(feature = "small-frames")]
    #[must_use = "the memory is lost if nobody keeps it"]
    pub const fn take_memory(&mut self) -> &'static mut [u8] {
        (self.width, self.height) = (0, 0);
        core::mem::replace(&mut self.yuyv, &mut [])
    }

    /// Whether the newest image can still be processed: its memory was not taken.
    pub(crate) const fn has_image(&self) -> bool {
        !self.yuyv.is_empty()
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
    #[output]
    #[must_use]
    pub const fn count(&self) -> u32 {
        self.count
    }

    /// What the health monitor compares of the newest image; `None` while there is none.
    #[must_use]
    pub(crate) fn glimpse(&self) -> Option<Glimpse> {
        Glimpse::of(self.image().yuyv)
    }

    /// Camera that took the newest image.
    #[output]
    const fn camera(&self) -> CameraId {
        self.camera
    }

    /// Width and height of the newest image.
    #[output(unit = "px")]
    const fn size(&self) -> (u16, u16) {
        (self.width, self.height)
    }

    /// The joint angles when the image was taken, rad.
    #[must_use]
    pub const fn angles(&self) -> &Joints<f32> {
        &self.angles
    }

    /// The newest image; 0×0 before the first one, and while its memory is taken for the next one.
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

#[cfg(all(test, feature = "small-frames"))]
mod tests {
    extern crate std;

    use std::boxed::Box;

    use bica_motion::joints::JOINTS;

    use super::*;

    const ANGLES: Joints<f32> = Joints([0.5; JOINTS]);

    fn memory(value: u8) -> &'static mut [u8] {
        Box::leak(Box::new([value; IMAGE_BYTES]))
    }

    #[test]
    fn image_is_absent_while_its_memory_is_taken() {
        let mut input = CameraInput::new();
        assert!(input.set_image(memory(1), CameraId::Bottom, (16, 12), &ANGLES).is_empty());
        assert_eq!((input.count(), input.size(), input.has_image()), (1, (16, 12), true));
        assert_eq!((input.image().camera, input.image().yuyv), (CameraId::Bottom, &[1; 2 * 16 * 12][..]));

        let taken = input.take_memory();
        assert_eq!((input.count(), input.size(), input.has_image()), (1, (0, 0), false));
        assert!(input.image().yuyv.is_empty());

        taken.fill(2);
        assert!(input.set_image(taken, CameraId::Top, (16, 12), &ANGLES).is_empty());
        assert_eq!((input.count(), input.image().yuyv), (2, &[2; 2 * 16 * 12][..]));
        let previous = input.set_image(memory(3), CameraId::Top, (8, 6), &ANGLES);
        assert_eq!(previous[0], 2, "the memory of the previous image");
        assert_eq!((input.count(), input.image().yuyv), (3, &[3; 2 * 8 * 6][..]));
    }
}
