//! Records of MCAP: numbers, texts and maps.

use std::collections::BTreeMap;

/// First and last bytes of a file.
pub(super) const MAGIC: [u8; 8] = [0x89, b'M', b'C', b'A', b'P', b'0', b'\r', b'\n'];
/// Bytes before the content of a record: its kind and length.
pub(super) const PREFIX: usize = 9;

/// Kinds of records.
pub(super) mod opcode {
    pub(in crate::mcap) const HEADER: u8 = 0x01;
    pub(in crate::mcap) const FOOTER: u8 = 0x02;
    pub(in crate::mcap) const SCHEMA: u8 = 0x03;
    pub(in crate::mcap) const CHANNEL: u8 = 0x04;
    pub(in crate::mcap) const MESSAGE: u8 = 0x05;
    pub(in crate::mcap) const CHUNK: u8 = 0x06;
    pub(in crate::mcap) const MESSAGE_INDEX: u8 = 0x07;
    pub(in crate::mcap) const CHUNK_INDEX: u8 = 0x08;
    pub(in crate::mcap) const STATISTICS: u8 = 0x0B;
    pub(in crate::mcap) const METADATA: u8 = 0x0C;
    pub(in crate::mcap) const METADATA_INDEX: u8 = 0x0D;
    pub(in crate::mcap) const SUMMARY_OFFSET: u8 = 0x0E;
    pub(in crate::mcap) const DATA_END: u8 = 0x0F;
    /// Compressed metadata, a kind of this program; other programs ignore it.
    pub(in crate::mcap) const COMPRESSED_METADATA: u8 = 0x80;
}

/// Schema of messages.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SchemaRecord {
    /// Number, from 1.
    pub id: u16,
    /// Name.
    pub name: String,
    /// Language of the schema.
    pub encoding: String,
    /// The schema.
    pub data: Vec<u8>,
}

/// A channel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ChannelRecord {
    /// Number.
    pub id: u16,
    /// Number of the schema.
    pub schema: u16,
    /// Topic.
    pub topic: String,
    /// Encoding of the messages.
    pub encoding: String,
    /// Other properties, by name.
    pub metadata: BTreeMap<String, String>,
}

/// Builder of records.
#[derive(Debug, Default)]
pub(super) struct Encoder(pub(super) Vec<u8>);

impl Encoder {
    /// Appends a record whose content `fill` writes.
    pub(super) fn record(&mut self, opcode: u8, fill: impl FnOnce(&mut Self)) -> &mut Self {
        self.0.push(opcode);
        let length_at = self.0.len();
        self.0.extend([0; 8]);
        fill(self);
        let length = (self.0.len() - length_at - 8) as u64;
        self.0[length_at..length_at + 8].copy_from_slice(&length.to_le_bytes());
        self
    }

    pub(super) fn u16(&mut self, value: u16) -> &mut Self {
        self.0.extend(value.to_le_bytes());
        self
    }

    pub(super) fn u32(&mut self, value: u32) -> &mut Self {
        self.0.extend(value.to_le_bytes());
        self
    }

    pub(super) fn u64(&mut self, value: u64) -> &mut Self {
        self.0.extend(value.to_le_bytes());
        self
    }

    pub(super) fn bytes(&mut self, bytes: &[u8]) -> &mut Self {
        self.u32(bytes.len() as u32);
        self.0.extend_from_slice(bytes);
        self
    }

    pub(super) fn text(&mut self, text: &str) -> &mut Self {
        self.bytes(text.as_bytes())
    }

    pub(super) fn texts(&mut self, map: &BTreeMap<String, String>) -> &mut Self {
        let mut inner = Self::default();
        for (key, value) in map {
            inner.text(key).text(value);
        }
        self.bytes(&inner.0)
    }

    pub(super) fn schema(&mut self, schema: &SchemaRecord) -> &mut Self {
        self.record(opcode::SCHEMA, |out| {
            out.u16(schema.id).text(&schema.name).text(&schema.encoding).bytes(&schema.data);
        })
    }

    pub(super) fn channel(&mut self, channel: &ChannelRecord) -> &mut Self {
        self.record(opcode::CHANNEL, |out| {
            out.u16(channel.id)
                .u16(channel.schema)
                .text(&channel.topic)
                .text(&channel.encoding)
                .texts(&channel.metadata);
        })
    }
}

/// Reader of a record's content. `None`: the content is too short or no text.
#[derive(Clone, Copy, Debug)]
pub(super) struct Decoder<'a>(pub(super) &'a [u8]);

impl<'a> Decoder<'a> {
    pub(super) fn take(&mut self, count: usize) -> Option<&'a [u8]> {
        let (taken, rest) = self.0.split_at_checked(count)?;
        self.0 = rest;
        Some(taken)
    }

    fn array<const N: usize>(&mut self) -> Option<[u8; N]> {
        self.take(N)?.try_into().ok()
    }

    pub(super) fn u8(&mut self) -> Option<u8> {
        Some(self.array::<1>()?[0])
    }

    pub(super) fn u16(&mut self) -> Option<u16> {
        self.array().map(u16::from_le_bytes)
    }

    pub(super) fn u32(&mut self) -> Option<u32> {
        self.array().map(u32::from_le_bytes)
    }

    pub(super) fn u64(&mut self) -> Option<u64> {
        self.array().map(u64::from_le_bytes)
    }

    pub(super) fn bytes(&mut self) -> Option<&'a [u8]> {
        let length = self.u32()?;
        self.take(length as usize)
    }

    pub(super) fn text(&mut self) -> Option<String> {
        String::from_utf8(self.bytes()?.to_vec()).ok()
    }

    pub(super) fn texts(&mut self) -> Option<BTreeMap<String, String>> {
        let mut inner = Decoder(self.bytes()?);
        let mut map = BTreeMap::new();
        while !inner.0.is_empty() {
            map.insert(inner.text()?, inner.text()?);
        }
        Some(map)
    }
}
