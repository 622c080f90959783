//! Images, in pieces.

use crate::message::{Chunk, Picture};

/// Bytes of an image in one packet.
pub const CHUNK: usize = 1024;

/// The pieces of an image, in order.
pub fn chunks(image: u32, bytes: &[u8]) -> impl Iterator<Item = Chunk<'_>> {
    let number = move |(index, bytes)| Chunk { image, at: (index * CHUNK) as u32, bytes };
    bytes.chunks(CHUNK).enumerate().map(number)
}

/// Puts an image of up to `N` bytes together.
#[derive(Clone, Debug)]
pub struct Frame<const N: usize> {
    bytes: [u8; N],
    /// Its number.
    image: u32,
    /// Bytes that came; `None` if a piece is missing.
    filled: Option<usize>,
    torn: u32,
}

impl<const N: usize> Frame<N> {
    /// No image.
    #[must_use]
    pub const fn new() -> Self {
        Self { bytes: [0; N], image: 0, filled: None, torn: 0 }
    }

    /// Images of which something was missing when they were asked for.
    #[must_use]
    pub const fn torn(&self) -> u32 {
        self.torn
    }

    /// Takes a piece. One that is not the next one spoils its image.
    pub fn add(&mut self, chunk: &Chunk<'_>) {
        if chunk.at == 0 {
            (self.image, self.filled) = (chunk.image, Some(0));
        }
        let next = self.filled.filter(|&filled| self.image == chunk.image && filled == chunk.at as usize);
        self.filled = next.and_then(|from| {
            let to = from + chunk.bytes.len();
            self.bytes.get_mut(from..to)?.copy_from_slice(chunk.bytes);
            Some(to)
        });
    }

    /// The image, if it is whole: the pieces bear its number and make up just its size.
    pub fn take(&mut self, picture: &Picture) -> Option<&[u8]> {
        let size = 2 * usize::from(picture.width) * usize::from(picture.height);
        let whole = self.filled.take().is_some_and(|filled| filled == size && self.image == picture.image);
        if !whole {
            self.torn = self.torn.wrapping_add(1);
            return None;
        }
        self.bytes.get(..size)
    }
}

impl<const N: usize> Default for Frame<N> {
    fn default() -> Self {
        Self::new()
    }
}
