//! Reader of MCAP files that trusts nothing in them.

use std::collections::BTreeMap;
use std::io::{self, Read, Seek, SeekFrom};
use std::ops::Range;

use lz4_flex::frame::FrameDecoder;

use super::MAX_RECORD;
use super::record::{ChannelRecord, Decoder, MAGIC, PREFIX, SchemaRecord, opcode};
use crate::error::Error;

/// Size of the positions in a footer, before its checksum, bytes.
const FOOTER_POSITIONS: usize = 16;

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
/// Checks all checksums that the file has: of chunks, of the data and of the summary.
#[derive(Debug)]
pub struct Reader<R> {
    source: R,
    at: u64,
    /// Checksum of everything so far; none if reading began within the file.
    data: Option<crc32fast::Hasher>,
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
        let mut data = crc32fast::Hasher::new();
        data.update(&MAGIC);
        Ok(Self { data: Some(data), ..Self::resume(source, MAGIC.len() as u64) })
    }

    /// Continues to read a file at the beginning of a record, at this position.
    pub const fn resume(source: R, at: u64) -> Self {
        Self { source, at, data: None, chunk: Vec::new(), within: 0, chunk_at: at, ended: false }
    }

    /// Returns the position after the last complete record, bytes.
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
        let (prefix, kind, content) = self.read_record(start)?;
        self.at = start + (prefix.len() + content.len()) as u64;
        if let Some(data) = self.data.as_mut().filter(|_| kind != opcode::DATA_END) {
            data.update(&prefix);
            data.update(&content);
        }
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
            opcode::COMPRESSED_METADATA => {
                let content = compressed_metadata(&content, start)?;
                let mut content = Decoder(&content);
                let found = content.text().zip(content.texts());
                found.map(|(name, fields)| Some(Item::Metadata(start, name, fields))).ok_or_else(short)
            }
            opcode::CHUNK => self.open_chunk(&content, start).map(Some),
            opcode::DATA_END => self.end(&content, start).map(|()| Some(Item::End)),
            opcode::FOOTER => Err(Error::damaged(start, "the data have no end")),
            _ => Ok(None),
        }
    }

    /// Checks that the file was closed, and its checksums. `content` is that of the record that ends the data.
    fn end(&mut self, content: &[u8], data_end: u64) -> Result<(), Error> {
        let expected = Decoder(content).u32().ok_or_else(|| Error::damaged(data_end, "the record is too short"))?;
        if let Some(data) = self.data.take() {
            check(expected, data.finalize(), data_end, "the checksum of the data is wrong")?;
        }
        let (summary_at, mut summary) = (self.at, crc32fast::Hasher::new());
        loop {
            let (prefix, kind, content) = self.read_record(summary_at)?;
            self.at += (prefix.len() + content.len()) as u64;
            summary.update(&prefix);
            if kind == opcode::FOOTER {
                let mut rest = Decoder(&content);
                let fields = rest.take(FOOTER_POSITIONS).zip(rest.u32());
                let (positions, expected) = fields.ok_or_else(|| Error::damaged(self.at, "the footer is too short"))?;
                summary.update(positions);
                check(expected, summary.finalize(), summary_at, "the checksum of the summary is wrong")?;
                break;
            }
            summary.update(&content);
        }
        if self.read(MAGIC.len() as u64, summary_at)? != MAGIC {
            return Err(Error::damaged(self.at, "the last bytes are not those of an MCAP file"));
        }
        if self.source.by_ref().take(1).read_to_end(&mut Vec::new())? > 0 {
            return Err(Error::damaged(self.at, "there are bytes after the end"));
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
        if !rest.0.is_empty() {
            return Err(Error::damaged(at, "the chunk is too long"));
        }
        if uncompressed > MAX_RECORD {
            return Err(Error::damaged(at, format!("a chunk of {uncompressed} bytes")));
        }
        let records = match compression.as_str() {
            "" => stored.to_vec(),
            "lz4" => decompressed(stored, uncompressed, at)?,
            "zstd" => return Err(Error::Compression(compression)),
            _ => return Err(Error::damaged(at, format!("unknown compression `{compression}`"))),
        };
        if records.len() as u64 != uncompressed {
            return Err(Error::damaged(at, "the chunk has another length than it says"));
        }
        check(crc, crc32fast::hash(&records), at, "the checksum of the chunk is wrong")?;
        (self.chunk, self.within, self.chunk_at) = (records, 0, at);
        Ok(Item::Chunk { at, length: self.at - at, uncompressed })
    }

    /// Reads a record: its prefix, its kind and its content. `cut_at` is the length of the intact file if it ends before.
    fn read_record(&mut self, cut_at: u64) -> Result<(Vec<u8>, u8, Vec<u8>), Error> {
        let prefix = self.read(PREFIX as u64, cut_at)?;
        let mut fields = Decoder(&prefix);
        let (kind, length) = fields.u8().zip(fields.u64()).ok_or(Error::CutOff { at: cut_at })?;
        if length > MAX_RECORD {
            return Err(Error::damaged(self.at, format!("a record of {length} bytes")));
        }
        let content = self.read(length, cut_at)?;
        Ok((prefix, kind, content))
    }

    /// Reads exactly `length` bytes; memory grows with the bytes that exist, not with the length.
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

/// Decompresses data of LZ4; returns at most one byte more than expected.
fn decompressed(stored: &[u8], expected: u64, at: u64) -> Result<Vec<u8>, Error> {
    let mut records = Vec::new();
    let decoded = FrameDecoder::new(stored).take(expected + 1).read_to_end(&mut records);
    decoded.map_err(|error| Error::damaged(at, format!("a record cannot be decompressed: {error}")))?;
    Ok(records)
}

/// Returns the content of a compressed metadata record.
fn compressed_metadata(content: &[u8], at: u64) -> Result<Vec<u8>, Error> {
    let mut stored = Decoder(content);
    let crc = stored.u32().ok_or_else(|| Error::damaged(at, "the record is too short"))?;
    let content = decompressed(stored.0, MAX_RECORD, at)?;
    check(crc, crc32fast::hash(&content), at, "the checksum of the metadata is wrong")?;
    Ok(content)
}

/// Checks a checksum of the file; 0 means that it has none.
fn check(expected: u32, found: u32, at: u64, wrong: &str) -> Result<(), Error> {
    if expected == 0 || expected == found { Ok(()) } else { Err(Error::damaged(at, wrong)) }
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
        metadata: content.texts()?,
    })
}

/// Number of bytes that are searched at once.
const WINDOW: usize = 1 << 20;

/// Returns the position of the first intact chunk or metadata record that begins in a range; `accepts` may refuse it.
///
/// # Errors
/// If the source cannot be read.
pub(crate) fn find_intact(
    source: &mut (impl Read + Seek),
    range: Range<u64>,
    accepts: impl Fn(&Item) -> bool,
) -> Result<Option<u64>, Error> {
    let (mut start, mut window) = (range.start, Vec::new());
    loop {
        source.seek(SeekFrom::Start(start))?;
        window.clear();
        source.by_ref().take(WINDOW as u64).read_to_end(&mut window)?;
        for (offset, prefix) in window.windows(PREFIX).enumerate() {
            let mut fields = Decoder(prefix);
            let is_kind = matches!(fields.u8(), Some(opcode::CHUNK | opcode::METADATA | opcode::COMPRESSED_METADATA));
            if !is_kind || fields.u64().is_none_or(|length| length > MAX_RECORD) {
                continue;
            }
            let at = start + offset as u64;
            source.seek(SeekFrom::Start(at))?;
            if Reader::resume(&mut *source, at).next_item().is_ok_and(|item| accepts(&item)) {
                return Ok(Some(at));
            }
        }
        start += (WINDOW - PREFIX + 1) as u64;
        if window.len() < WINDOW || start >= range.end {
            return Ok(None);
        }
    }
}

fn message(content: &[u8], chunk_at: u64) -> Option<Message> {
    let mut content = Decoder(content);
    let (channel, _) = (content.u16()?, content.u32()?);
    let (time, _) = (content.u64()?, content.u64()?);
    Some(Message { channel, time, data: content.0.to_vec(), chunk_at })
}
