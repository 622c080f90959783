//! Transfer of images and other large data in chunks.

use crate::message::{BlobsInfo, ImageChunk};

/// Size of a chunk, bytes. The last chunk of an image may be shorter.
pub const CHUNK_BYTES: usize = 1024;

/// Splits an image into chunks, in order.
pub fn chunks(image_id: u32, bytes: &[u8]) -> impl Iterator<Item = ImageChunk<'_>> {
    let chunk = move |(index, bytes)| ImageChunk { image_id, offset: (index * CHUNK_BYTES) as u32, bytes };
    bytes.chunks(CHUNK_BYTES).enumerate().map(chunk)
}

/// Assembles an image from its chunks in memory of the caller: it can be the memory from which the image is read later.
///
/// All chunks of an image must be added to the same memory.
#[derive(Clone, Debug, Default)]
pub struct ImageAssembler {
    image_id: u32,
    /// Number of bytes received; `None` if a chunk is missing.
    filled: Option<usize>,
    incomplete: u32,
}

impl ImageAssembler {
    /// Creates an assembler without an image.
    #[must_use]
    pub const fn new() -> Self {
        Self { image_id: 0, filled: None, incomplete: 0 }
    }

    /// Returns the number of images that were incomplete when they were taken.
    #[must_use]
    pub const fn incomplete(&self) -> u32 {
        self.incomplete
    }

    /// Writes a chunk into `memory`. A chunk that does not continue the previous one, or does not fit, is not written and
    /// invalidates its image.
    pub fn add(&mut self, chunk: &ImageChunk<'_>, memory: &mut [u8]) {
        if chunk.offset == 0 {
            (self.image_id, self.filled) = (chunk.image_id, Some(0));
        }
        let next = self.filled.filter(|&filled| self.image_id == chunk.image_id && filled == chunk.offset as usize);
        self.filled = next.and_then(|from| {
            let to = from + chunk.bytes.len();
            memory.get_mut(from..to)?.copy_from_slice(chunk.bytes);
            Some(to)
        });
    }

    /// Returns the number of bytes of the image at the start of the memory if it is complete: its chunks carry its number and
    /// add up to its size. Ends the image in both cases.
    pub fn take(&mut self, info: &BlobsInfo) -> Option<usize> {
        let size = info.bytes as usize;
        let complete = self.filled.take().is_some_and(|filled| filled == size && self.image_id == info.id);
        if !complete {
            self.incomplete = self.incomplete.wrapping_add(1);
            return None;
        }
        Some(size)
    }
}

/// Assembles an image of up to `N` bytes from its chunks, in memory of its own.
#[derive(Clone, Debug)]
pub struct ImageBuffer<const N: usize> {
    bytes: [u8; N],
    assembler: ImageAssembler,
}

impl<const N: usize> ImageBuffer<N> {
    /// Creates a buffer without an image.
    #[must_use]
    pub const fn new() -> Self {
        Self { bytes: [0; N], assembler: ImageAssembler::new() }
    }

    /// Returns the number of images that were incomplete when they were taken.
    #[must_use]
    pub const fn incomplete(&self) -> u32 {
        self.assembler.incomplete()
    }

    /// Adds a chunk. A chunk that does not continue the previous one invalidates its image.
    pub fn add(&mut self, chunk: &ImageChunk<'_>) {
        self.assembler.add(chunk, &mut self.bytes);
    }

    /// Returns the image if it is complete: its chunks carry its number and add up to its size. Removes it from the
    /// buffer.
    pub fn take(&mut self, info: &BlobsInfo) -> Option<&[u8]> {
        let size = self.assembler.take(info)?;
        self.bytes.get(..size)
    }
}

impl<const N: usize> Default for ImageBuffer<N> {
    fn default() -> Self {
        Self::new()
    }
}
