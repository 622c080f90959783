//! Images and other large data.

use postcard_schema::Schema;
use serde::{Deserialize, Serialize};

/// A part of an image, or of other large data.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct ImageChunk<'a> {
    /// Number of the data.
    pub image_id: u32,
    /// Position of the first byte in the data, bytes. Chunks are sent in order; offset 0 starts new data.
    pub offset: u32,
    /// The bytes.
    pub bytes: &'a [u8],
}

/// All large data of one message, concatenated. The chunks were sent before.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct BlobsInfo {
    /// Number of the data, as in the chunks.
    pub id: u32,
    /// Number of bytes.
    pub bytes: u32,
}
