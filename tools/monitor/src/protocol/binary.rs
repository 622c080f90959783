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

use bica_link::Image;
use bica_wire::truncate;

use super::SessionId;

/// Size of the head, bytes.
const HEAD_BYTES: usize = 32;

/// Content of the pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PixelKind {
    /// YUYV: 4 bytes for 2 pixels.
    Yuyv = 1,
    /// Index of the colour class, or 255 for none; one byte for each pixel.
    Classes = 2,
}

/// Returns the frame of an image of a session with these pixels; `id` is that of the request that it answers, 0 for a watched image.
#[must_use]
pub fn image_frame(session: SessionId, image: &Image, (kind, pixels): (PixelKind, &[u8]), id: u32) -> Vec<u8> {
    let camera = truncate(&image.camera, u8::MAX.into()).as_bytes();
    let mut frame = Vec::with_capacity(HEAD_BYTES + camera.len() + pixels.len());
    frame.extend([kind as u8, camera.len() as u8, 0, 0]);
    frame.extend(session.to_le_bytes());
    frame.extend(image.number.to_le_bytes());
    frame.extend(image.width.to_le_bytes());
    frame.extend(image.height.to_le_bytes());
    frame.extend(image.time_us.to_le_bytes());
    frame.extend(id.to_le_bytes());
    frame.extend([0; 4]);
    frame.extend(camera);
    frame.extend(pixels);
    frame
}
