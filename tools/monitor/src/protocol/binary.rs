//! Binary frames from the server: an image, or the classes of its pixels.
//!
//! | bytes | field, little-endian |
//! |---|---|
//! | 0 | kind: 1 image in YUYV, 2 classes, one byte a pixel |
//! | 1 | length of the name of the camera, n, bytes |
//! | 2–3 | 0 |
//! | 4–7 | session, `u32` |
//! | 8–11 | number of the image in the session, `u32` |
//! | 12–13 | width, px, `u16` |
//! | 14–15 | height, px, `u16` |
//! | 16–23 | time of the cycle that received the image, µs, `u64` |
//! | 24–27 | `id` of the answered request, `u32`; 0 for a watched image |
//! | 28–31 | 0 |
//! | 32–31+n | name of the camera, UTF-8; empty if it is unknown |
//! | 32+n– | pixels |

use bica_wire::truncate;

use super::SessionId;

/// Size of the head, bytes.
pub const HEAD_BYTES: usize = 32;

/// Content of the pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PixelKind {
    /// YUYV: 4 bytes for 2 pixels.
    Yuyv = 1,
    /// Index of the colour class, or 255 for none; one byte for each pixel.
    Classes = 2,
}

/// Head of a binary frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ImageHead<'a> {
    /// Content of the pixels.
    pub kind: PixelKind,
    /// Name of the camera, of which at most 255 bytes are sent; empty if it is unknown.
    pub camera: &'a str,
    /// Session.
    pub session: SessionId,
    /// Number of the image in the session, from 0.
    pub number: u32,
    /// Width, px.
    pub width: u16,
    /// Height, px.
    pub height: u16,
    /// Time of the cycle that received the image, µs.
    pub time_us: u64,
    /// `id` of the request that the frame answers; 0 for a watched image.
    pub id: u32,
}

impl ImageHead<'_> {
    /// Returns the frame: the head, then the pixels.
    #[must_use]
    pub fn frame(&self, pixels: &[u8]) -> Vec<u8> {
        let camera = truncate(self.camera, u8::MAX.into()).as_bytes();
        let mut frame = Vec::with_capacity(HEAD_BYTES + camera.len() + pixels.len());
        frame.extend([self.kind as u8, camera.len() as u8, 0, 0]);
        frame.extend(self.session.to_le_bytes());
        frame.extend(self.number.to_le_bytes());
        frame.extend(self.width.to_le_bytes());
        frame.extend(self.height.to_le_bytes());
        frame.extend(self.time_us.to_le_bytes());
        frame.extend(self.id.to_le_bytes());
        frame.extend([0; 4]);
        frame.extend(camera);
        frame.extend(pixels);
        frame
    }
}
