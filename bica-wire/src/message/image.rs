//! Images.

use postcard_schema::Schema;
use serde::{Deserialize, Serialize};

/// A part of an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct ImageChunk<'a> {
    /// Number of the image.
    pub image_id: u32,
    /// Position of the first byte in the image, bytes. Chunks are sent in order; offset 0 starts an image.
    pub offset: u32,
    /// The bytes.
    pub bytes: &'a [u8],
}

/// Size and source of the image whose chunks were sent before.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct ImageInfo {
    /// Number of the image.
    pub id: u32,
    /// Whether the bottom camera took the image.
    pub bottom_camera: bool,
    /// Width, px.
    pub width: u16,
    /// Height, px.
    pub height: u16,
}
