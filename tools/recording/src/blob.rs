//! Large data of a recording: images, scans, point clouds.

use bica::{Blob, Format};
use bica_wire::blobs;
use postcard_schema::Schema;
use serde::{Deserialize, Serialize, Serializer};

use crate::image_codec::ImageCoder;
use crate::mcap::Compression;

/// Coding of the stored bytes of large data.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub enum Coding {
    /// Unchanged bytes.
    Plain,
    /// By [`crate::image_codec`].
    Yuyv,
}

/// Large data in the sensor values of a cycle.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct BlobRecord<'a> {
    /// Number in the recording, from 1.
    pub id: u32,
    /// Number of its cycle; none in a recording of a monitor, which knows only the time.
    pub cycle: Option<u64>,
    /// Position among the large data of its cycle, from 0.
    pub part: u16,
    /// Format of the data.
    #[serde(borrow)]
    pub format: Format<'a>,
    /// Name of the coordinate frame in which it was measured.
    pub frame: &'a str,
    /// Coding of the stored bytes.
    pub coding: Coding,
    /// The stored bytes.
    #[serde(serialize_with = "as_bytes")]
    pub stored: &'a [u8],
}

/// Serde's slices are sequences, of which each byte would be written alone.
fn as_bytes<S: Serializer>(bytes: &[u8], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_bytes(bytes)
}

/// Large data in memory of its own.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct StoredBlob {
    /// Number in the recording, from 1.
    pub id: u32,
    /// Format and frame in postcard's format.
    head: Vec<u8>,
    /// The data.
    pub bytes: Vec<u8>,
}

/// Position of large data in a recording.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BlobIndex {
    pub(crate) id: u32,
    pub(crate) cycle: Option<u64>,
    pub(crate) part: u16,
}

impl BlobRecord<'_> {
    /// Returns the compression of the record's chunk: coded data cannot be compressed further.
    pub(crate) fn compression(&self) -> Compression {
        let is_compressed = self.coding == Coding::Yuyv || self.format == Format::Jpeg;
        if is_compressed { Compression::None } else { Compression::Lz4 }
    }

    /// Decodes the data; `None` if the stored bytes are damaged.
    pub(crate) fn decode(&self, coder: &mut ImageCoder) -> Option<StoredBlob> {
        let bytes = match (self.coding, self.format) {
            (Coding::Plain, _) => self.stored.to_vec(),
            (Coding::Yuyv, Format::Yuyv { width, height }) => {
                let mut yuyv = Vec::new();
                coder.decode(self.stored, width.into(), height.into(), &mut yuyv).ok()?;
                yuyv
            }
            (Coding::Yuyv, _) => return None,
        };
        Some(StoredBlob { id: self.id, head: postcard::to_stdvec(&(self.format, self.frame)).ok()?, bytes })
    }
}

impl StoredBlob {
    /// Returns the data with its format.
    #[must_use]
    pub fn blob(&self) -> Blob<'_> {
        let (format, frame) = blobs::described(&self.head);
        Blob { bytes: &self.bytes, format, frame }
    }
}

/// Codes large data and passes the record to `write`, with the compression of its chunk.
pub(crate) fn code(
    blob: &Blob<'_>,
    BlobIndex { id, cycle, part }: BlobIndex,
    coder: &mut ImageCoder,
    write: impl FnOnce(Compression, &BlobRecord<'_>),
) {
    let &Blob { bytes, format, frame } = blob;
    let mut coded = Vec::new();
    let is_coded = match format {
        Format::Yuyv { width, height } => {
            coded.reserve(bytes.len() / 2);
            coder.encode(bytes, width.into(), height.into(), &mut coded).is_ok()
        }
        _ => false,
    };
    let (coding, stored) = if is_coded { (Coding::Yuyv, &coded[..]) } else { (Coding::Plain, bytes) };
    let record = BlobRecord { id, cycle, part, format, frame, coding, stored };
    write(record.compression(), &record);
}
