//! Reader of MCAP files that trusts nothing in them.

use std::collections::BTreeMap;
use std::io::{self, Read};

use lz4_flex::frame::FrameDecoder;

use super::record::{ChannelRecord, Decoder, MAGIC, SchemaRecord, opcode};
use crate::error::Error;

/// Largest record, bytes: an image of the largest size fits.
const MAX_RECORD: u64 = 64 << 20;

/// A part of a file that a reader returns.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Item {
    /// Schema of messages.
    Schema(SchemaRecord),
    /// A channel.
    Channel(ChannelRecord),
    /// Metadata: position, name and fields.
    Metadata(u64, String, BTreeMap<String, String>),
    /// A complete chunk; its messages follow.
    Chunk {
        /// Position in the file, bytes.
        at: u64,
        /// Length in the file, bytes.
        length: u64,
        /// Sum of the lengths of its messages, bytes.
        uncompressed: u64,
    },
    /// A message.
    Message(Message),
    /// The end of a file that was closed.
    End,
}

/// A message.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Message {
    /// Number of the channel.
    pub channel: u16,
    /// Time, ns.
    pub time: u64,
    /// Content.
    pub data: Vec<u8>,
    /// Position of the chunk in the file, bytes.
    pub chunk_at: u64,
}

/// Reader of an MCAP file from its start to its end, with bounded memory: one chunk.
///
/// After an error about a single chunk ([`Error::Damaged`] by its checksum) the next call goes on behind it.
#[derive(Debug)]
pub struct Reader<R> {
    source: R,
    at: u64,
    chunk: Vec<u8>,
    /// Position within the open chunk.
    within: usize,
    chunk_at: u64,
    ended: bool,
}

impl<R: Read> Reader<R> {
    /// Opens a file.
    ///
    /// # Errors
    /// [`Error::NotMcap`], or that of the source.
    pub fn new(mut source: R) -> Result<Self, Error> {
        let mut magic = Vec::new();
        source.by_ref().take(MAGIC.len() as u64).read_to_end(&mut magic)?;
        if magic != MAGIC {
            return Err(Error::NotMcap);
        }
        Ok(Self { source, at: MAGIC.len() as u64, chunk: Vec::new(), within: 0, chunk_at: 0, ended: false })
    }

    /// Continues to read a file at the beginning of a record, at this position.
    pub const fn resume(source: R, at: u64) -> Self {
        Self { source, at, chunk: Vec::new(), within: 0, chunk_at: at, ended: false }
    }

    /// Returns the position behind the last complete record, bytes.
    pub const fn position(&self) -> u64 {
        self.at
    }

    /// Returns the next part of the file. [`Item::End`] is repeated.
    ///
    /// # Errors
    /// [`Error::CutOff`] if the file ends within a record or without a footer, [`Error::Damaged`],
    /// [`Error::Compression`], or that of the source.
    pub fn next_item(&mut self) -> Result<Item, Error> {
        loop {
            if self.within < self.chunk.len() {
                if let Some(item) = self.next_in_chunk()? {
                    return Ok(item);
                }
                continue;
            }
            if self.ended {
                return Ok(Item::End);
            }
            if let Some(item) = self.next_record()? {
                return Ok(item);
            }
        }
    }

    fn next_in_chunk(&mut self) -> Result<Option<Item>, Error> {
        let damaged = || Error::damaged(self.chunk_at, "a record in the chunk is too long");
        let mut rest = Decoder(&self.chunk[self.within..]);
        let kind = rest.u8().ok_or_else(damaged)?;
        let length = rest.u64().and_then(|length| usize::try_from(length).ok()).ok_or_else(damaged)?;
        let content = rest.take(length);
        let Some(content) = content else {
            let error = damaged();
            self.within = self.chunk.len();
            return Err(error);
        };
        let item = match kind {
            opcode::MESSAGE => message(content, self.chunk_at).map(Item::Message).map(Some),
            opcode::SCHEMA => schema(content).map(Item::Schema).map(Some),
            opcode::CHANNEL => channel(content).map(Item::Channel).map(Some),
            _ => Some(None),
        };
        self.within = self.chunk.len() - rest.0.len();
        item.ok_or_else(|| Error::damaged(self.chunk_at, "a record in the chunk is too short"))
    }

    fn next_record(&mut self) -> Result<Option<Item>, Error> {
        let start = self.at;
        let prefix = self.read(9, start)?;
        let mut prefix = Decoder(&prefix);
        let (kind, length) = prefix.u8().zip(prefix.u64()).ok_or(Error::CutOff { at: start })?;
        if length > MAX_RECORD {
            return Err(Error::damaged(start, format!("a record of {length} bytes")));
        }
        let content = self.read(length, start)?;
        self.at = start + 9 + length;
        let short = || Error::damaged(start, "the record is too short");
        match kind {
            opcode::SCHEMA => schema(&content).map(Item::Schema).map(Some).ok_or_else(short),
            opcode::CHANNEL => channel(&content).map(Item::Channel).map(Some).ok_or_else(short),
            opcode::MESSAGE => message(&content, start).map(Item::Message).map(Some).ok_or_else(short),
            opcode::METADATA => {
                let mut content = Decoder(&content);
                let found = content.text().zip(content.texts());
                found.map(|(name, fields)| Some(Item::Metadata(start, name, fields))).ok_or_else(short)
            }
            opcode::CHUNK => self.open_chunk(&content, start).map(Some),
            opcode::DATA_END => self.end().map(|()| Some(Item::End)),
            opcode::FOOTER => Err(Error::damaged(start, "the data have no end")),
            _ => Ok(None),
        }
    }

    /// Checks that the file was closed: the summary is skipped, the footer and the last bytes must be there.
    fn end(&mut self) -> Result<(), Error> {
        let data_end = self.at;
        loop {
            let prefix = self.read(9, data_end)?;
            let mut prefix = Decoder(&prefix);
            let (kind, length) = prefix.u8().zip(prefix.u64()).ok_or(Error::CutOff { at: data_end })?;
            if length > MAX_RECORD {
                return Err(Error::damaged(data_end, format!("a record of {length} bytes in the summary")));
            }
            self.read(length, data_end)?;
            self.at += 9 + length;
            if kind == opcode::FOOTER {
                break;
            }
        }
        if self.read(MAGIC.len() as u64, data_end)? != MAGIC {
            return Err(Error::damaged(self.at, "the last bytes are not those of an MCAP file"));
        }
        self.ended = true;
        Ok(())
    }

    fn open_chunk(&mut self, content: &[u8], at: u64) -> Result<Item, Error> {
        let short = || Error::damaged(at, "the chunk is too short");
        let mut rest = Decoder(content);
        rest.take(16).ok_or_else(short)?;
        let uncompressed = rest.u64().ok_or_else(short)?;
        let crc = rest.u32().ok_or_else(short)?;
        let compression = rest.text().ok_or_else(short)?;
        let size = rest.u64().and_then(|size| usize::try_from(size).ok()).ok_or_else(short)?;
        let stored = rest.take(size).ok_or_else(short)?;
        if uncompressed > MAX_RECORD {
            return Err(Error::damaged(at, format!("a chunk of {uncompressed} bytes")));
        }
        let mut records = Vec::new();
        match compression.as_str() {
            "" => records.extend_from_slice(stored),
            "lz4" => {
                // One byte more than expected shows that there is more.
                let decoded = FrameDecoder::new(stored).take(uncompressed + 1).read_to_end(&mut records);
                decoded.map_err(|error| Error::damaged(at, format!("the chunk cannot be decompressed: {error}")))?;
            }
            _ => return Err(Error::Compression(compression)),
        }
        if records.len() as u64 != uncompressed {
            return Err(Error::damaged(at, "the chunk has another length than it says"));
        }
        if crc != 0 && crc != crc32fast::hash(&records) {
            return Err(Error::damaged(at, "the checksum of the chunk is wrong"));
        }
        (self.chunk, self.within, self.chunk_at) = (records, 0, at);
        Ok(Item::Chunk { at, length: self.at - at, uncompressed })
    }

    /// Reads exactly `length` bytes; memory grows with what is there, not with what a length says.
    fn read(&mut self, length: u64, record_at: u64) -> Result<Vec<u8>, Error> {
        let mut bytes = Vec::new();
        let result = self.source.by_ref().take(length).read_to_end(&mut bytes);
        match result {
            Ok(count) if count as u64 == length => Ok(bytes),
            Ok(_) => Err(Error::CutOff { at: record_at }),
            Err(error) if error.kind() == io::ErrorKind::UnexpectedEof => Err(Error::CutOff { at: record_at }),
            Err(error) => Err(error.into()),
        }
    }
}

fn schema(content: &[u8]) -> Option<SchemaRecord> {
    let mut content = Decoder(content);
    let (id, name, encoding) = (content.u16()?, content.text()?, content.text()?);
    Some(SchemaRecord { id, name, encoding, data: content.bytes()?.to_vec() })
}

fn channel(content: &[u8]) -> Option<ChannelRecord> {
    let mut content = Decoder(content);
    Some(ChannelRecord {
        id: content.u16()?,
        schema: content.u16()?,
        topic: content.text()?,
        encoding: content.text()?,
    })
}

fn message(content: &[u8], chunk_at: u64) -> Option<Message> {
    let mut content = Decoder(content);
    let (channel, _) = (content.u16()?, content.u32()?);
    let (time, _) = (content.u64()?, content.u64()?);
    Some(Message { channel, time, data: content.0.to_vec(), chunk_at })
}
