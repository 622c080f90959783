//! Reception of images, in the memory in which the tree processes them.

use bica_motion::joints::Joints;
use bica_motion::robot::CameraId;
use bica_player::input::{CameraInput, IMAGE_BYTES};
use bica_wire::ImageAssembler;
use bica_wire::message::{BlobsInfo, ImageChunk};
use static_cell::ConstStaticCell;

static MEMORY: ConstStaticCell<[u8; IMAGE_BYTES]> = ConstStaticCell::new([0; IMAGE_BYTES]);
/// Memory of a second image, so that the tree keeps one while the next one is received. Two images of 320×240 would
/// leave too little memory for the rest.
#[cfg(not(feature = "medium-frames"))]
static SECOND_MEMORY: ConstStaticCell<[u8; IMAGE_BYTES]> = ConstStaticCell::new([0; IMAGE_BYTES]);

/// Receiver of images. The memory of an incomplete image is here, and the memory of a complete one is in
/// [`CameraInput`], so no component can process an incomplete image.
pub(crate) struct ImageReceiver {
    assembler: ImageAssembler,
    /// Memory of the next image; empty while [`CameraInput`] has it.
    memory: &'static mut [u8],
    /// Unused memory; empty from the first image on, and always if there is memory for one image.
    spare: &'static mut [u8],
}

impl ImageReceiver {
    /// Creates a receiver. Called once.
    ///
    /// # Panics
    /// If it is called twice.
    pub(crate) fn new() -> Self {
        #[cfg(not(feature = "medium-frames"))]
        let spare = SECOND_MEMORY.take();
        #[cfg(feature = "medium-frames")]
        let spare: &'static mut [u8] = &mut [];
        Self { assembler: ImageAssembler::new(), memory: MEMORY.take(), spare }
    }

    /// Returns the number of incomplete images.
    pub(crate) const fn incomplete(&self) -> u32 {
        self.assembler.incomplete()
    }

    /// Receives a part of an image. With memory for one image the first part ends the previous image.
    pub(crate) fn add(&mut self, chunk: &ImageChunk<'_>, input: &mut CameraInput) {
        if self.memory.is_empty() && chunk.offset == 0 {
            self.memory = input.take_memory();
        }
        self.assembler.add(chunk, self.memory);
    }

    /// Ends an image; returns its bytes if it is complete.
    pub(crate) fn take(&mut self, info: &BlobsInfo) -> &[u8] {
        let size = self.assembler.take(info).unwrap_or(0);
        self.memory.get(..size).unwrap_or_default()
    }

    /// Passes the complete image to the tree, with the joint angles (rad) at which it was taken.
    pub(crate) fn finish(&mut self, camera: CameraId, size: (u16, u16), angles: &Joints<f32>, input: &mut CameraInput) {
        let memory = core::mem::take(&mut self.memory);
        self.memory = input.set_image(memory, camera, size, angles);
        if self.memory.is_empty() {
            self.memory = core::mem::take(&mut self.spare);
        }
    }
}
