//! Writer of MCAP files.

use std::collections::BTreeMap;
use std::io::{self, Write};

use lz4_flex::frame::{BlockMode, BlockSize, FrameEncoder, FrameInfo};

use super::MAX_RECORD;
use super::record::{ChannelRecord, Encoder, MAGIC, PREFIX, SchemaRecord, opcode};

/// Size of the messages of a chunk, bytes, above which the last one moves to another chunk: the record of a chunk has some bytes
/// more.
const FULL: usize = MAX_RECORD as usize - (1 << 16);

/// Compression of a chunk.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Compression {
    /// Stored as it is.
    None,
    /// LZ4 frames.
    Lz4,
}

/// A chunk of the file, for the summary.
#[derive(Debug)]
struct ChunkIndex {
    start_time: u64,
    end_time: u64,
    at: u64,
    length: u64,
    /// Channel and position of each message index.
    indexes: BTreeMap<u16, u64>,
    indexes_length: u64,
    compression: &'static str,
    compressed: u64,
    uncompressed: u64,
}

/// Messages that are not written yet.
#[derive(Debug, Default)]
struct OpenChunk {
    records: Encoder,
    /// Time and position of the messages of each channel.
    indexes: BTreeMap<u16, Vec<(u64, u64)>>,
    start_time: u64,
    end_time: u64,
}

/// Writer of an MCAP file.
///
/// Messages are collected in a chunk for each kind of [`Compression`]; [`flush`](Self::flush) writes these chunks. Each write
/// to the target is one call with complete records, and [`length`](Self::length) counts what succeeded.
#[derive(Debug)]
pub struct Writer<W> {
    target: W,
    length: u64,
    /// Checksum of everything written.
    data: crc32fast::Hasher,
    schemas: Vec<SchemaRecord>,
    channels: Vec<ChannelRecord>,
    /// Chunks to be stored as they are, and to be compressed.
    open: [OpenChunk; 2],
    /// Full chunks, which are written before the open ones.
    full: Vec<(Compression, OpenChunk)>,
    chunks: Vec<ChunkIndex>,
    metadata: Vec<(u64, u64, String)>,
    counts: BTreeMap<u16, u64>,
    times: Option<(u64, u64)>,
}

impl<W: Write> Writer<W> {
    /// Begins a file.
    ///
    /// # Errors
    /// If the target cannot be written.
    pub fn new(target: W, profile: &str) -> io::Result<Self> {
        let mut start = Encoder(MAGIC.to_vec());
        start.record(opcode::HEADER, |out| {
            out.text(profile).text(concat!("bica-recording ", env!("CARGO_PKG_VERSION")));
        });
        let mut writer = Self {
            target,
            length: 0,
            data: crc32fast::Hasher::new(),
            schemas: Vec::new(),
            channels: Vec::new(),
            open: Default::default(),
            full: Vec::new(),
            chunks: Vec::new(),
            metadata: Vec::new(),
            counts: BTreeMap::new(),
            times: None,
        };
        writer.write(&start.0)?;
        Ok(writer)
    }

    /// Writes schemas and channels, each before its first message.
    ///
    /// # Errors
    /// If the target cannot be written.
    pub fn declare(&mut self, schemas: Vec<SchemaRecord>, channels: Vec<ChannelRecord>) -> io::Result<()> {
        let mut records = Encoder::default();
        for schema in &schemas {
            records.schema(schema);
        }
        for channel in &channels {
            records.channel(channel);
        }
        self.schemas.extend(schemas);
        self.channels.extend(channels);
        self.write(&records.0)
    }

    /// Returns the length of the file so far, bytes: all records up to there are complete.
    pub const fn length(&self) -> u64 {
        self.length
    }

    /// Returns the number of bytes that wait for [`flush`](Self::flush).
    pub fn pending(&self) -> usize {
        self.full.iter().map(|(_, chunk)| chunk).chain(&self.open).map(|chunk| chunk.records.0.len()).sum()
    }

    /// Drops the messages that are not written yet.
    pub fn discard(&mut self) {
        (self.open, self.full) = Default::default();
    }

    /// Returns the target.
    pub const fn target_mut(&mut self) -> &mut W {
        &mut self.target
    }

    /// Writes a metadata record.
    ///
    /// # Errors
    /// If the target cannot be written.
    pub fn metadata(&mut self, name: &str, fields: &BTreeMap<String, String>) -> io::Result<()> {
        let mut record = Encoder::default();
        record.record(opcode::METADATA, |out| _ = out.text(name).texts(fields));
        let at = self.length;
        self.write(&record.0)?;
        self.metadata.push((at, record.0.len() as u64, name.to_owned()));
        Ok(())
    }

    /// Writes metadata that other programs ignore, compressed.
    ///
    /// # Errors
    /// If the target cannot be written.
    pub fn compressed_metadata(&mut self, name: &str, fields: &BTreeMap<String, String>) -> io::Result<()> {
        let (mut content, mut record) = (Encoder::default(), Encoder::default());
        content.text(name).texts(fields);
        let compressed = lz4(&content.0)?;
        record.record(opcode::COMPRESSED_METADATA, |out| {
            out.u32(crc32fast::hash(&content.0)).0.extend_from_slice(&compressed);
        });
        self.write(&record.0)
    }

    /// Adds a message to the open chunk of a compression. `time` is in ns, `data` writes the content.
    pub fn message(&mut self, compression: Compression, channel: u16, time: u64, data: impl FnOnce(&mut Vec<u8>)) {
        let sequence = self.counts.entry(channel).or_default();
        let number = *sequence as u32;
        *sequence += 1;
        let chunk = &mut self.open[compression as usize];
        if chunk.indexes.is_empty() {
            (chunk.start_time, chunk.end_time) = (time, time);
        }
        chunk.start_time = chunk.start_time.min(time);
        chunk.end_time = chunk.end_time.max(time);
        let start = chunk.records.0.len();
        chunk.indexes.entry(channel).or_default().push((time, start as u64));
        chunk.records.record(opcode::MESSAGE, |out| {
            out.u16(channel).u32(number).u64(time).u64(time);
            data(&mut out.0);
        });
        if start > 0 && chunk.records.0.len() > FULL {
            let next = chunk.split_last(channel, start);
            self.full.push((compression, std::mem::replace(chunk, next)));
        }
        let (start, end) = self.times.unwrap_or((time, time));
        self.times = Some((start.min(time), end.max(time)));
    }

    /// Writes the open chunks, that without compression first.
    ///
    /// # Errors
    /// If the target cannot be written.
    pub fn flush(&mut self) -> io::Result<()> {
        for (compression, chunk) in std::mem::take(&mut self.full) {
            self.write_chunk(compression, &chunk)?;
        }
        for compression in [Compression::None, Compression::Lz4] {
            let chunk = std::mem::take(&mut self.open[compression as usize]);
            if !chunk.indexes.is_empty() {
                self.write_chunk(compression, &chunk)?;
            }
        }
        Ok(())
    }

    fn write_chunk(&mut self, compression: Compression, chunk: &OpenChunk) -> io::Result<()> {
        let (name, compressed) = match compression {
            Compression::None => ("", None),
            Compression::Lz4 => ("lz4", Some(lz4(&chunk.records.0)?)),
        };
        let stored = compressed.as_deref().unwrap_or(&chunk.records.0);
        let mut out = Encoder(Vec::with_capacity(stored.len() + 1024));
        out.record(opcode::CHUNK, |out| {
            out.u64(chunk.start_time).u64(chunk.end_time).u64(chunk.records.0.len() as u64);
            out.u32(crc32fast::hash(&chunk.records.0)).text(name).u64(stored.len() as u64);
            out.0.extend_from_slice(stored);
        });
        let length = out.0.len() as u64;
        let largest = chunk.records.0.len().max(out.0.len() - PREFIX) as u64;
        if largest > MAX_RECORD {
            let what = format!("a chunk has {largest} bytes, a file holds at most {MAX_RECORD} in one");
            return Err(io::Error::new(io::ErrorKind::FileTooLarge, what));
        }
        let mut indexes = BTreeMap::new();
        for (channel, messages) in &chunk.indexes {
            indexes.insert(*channel, self.length + out.0.len() as u64);
            out.record(opcode::MESSAGE_INDEX, |out| {
                out.u16(*channel).u32((16 * messages.len()) as u32);
                for (time, at) in messages {
                    out.u64(*time).u64(*at);
                }
            });
        }
        let at = self.length;
        self.write(&out.0)?;
        self.chunks.push(ChunkIndex {
            start_time: chunk.start_time,
            end_time: chunk.end_time,
            at,
            length,
            indexes,
            indexes_length: out.0.len() as u64 - length,
            compression: name,
            compressed: stored.len() as u64,
            uncompressed: chunk.records.0.len() as u64,
        });
        Ok(())
    }

    /// Writes the open chunks and the summary; returns the target.
    ///
    /// # Errors
    /// If the target cannot be written.
    pub fn finish(mut self) -> io::Result<W> {
        self.close()?;
        Ok(self.target)
    }

    /// Writes the open chunks and the summary, in one call to the target.
    ///
    /// # Errors
    /// If the target cannot be written.
    pub fn close(&mut self) -> io::Result<()> {
        self.flush()?;
        let end = self.summary();
        self.write(&end)?;
        self.target.flush()
    }

    /// Returns everything after the last chunk.
    fn summary(&self) -> Vec<u8> {
        let mut out = Encoder::default();
        out.record(opcode::DATA_END, |out| _ = out.u32(self.data.clone().finalize()));
        let data_end = out.0.len();
        let start = self.length + data_end as u64;
        let mut groups = Vec::new();
        let mut group = |out: &mut Encoder, kind: u8, fill: &mut dyn FnMut(&mut Encoder)| {
            let from = out.0.len();
            fill(out);
            let length = out.0.len() - from;
            if length > 0 {
                groups.push((kind, self.length + from as u64, length as u64));
            }
        };
        group(&mut out, opcode::SCHEMA, &mut |out| {
            for schema in &self.schemas {
                out.schema(schema);
            }
        });
        group(&mut out, opcode::CHANNEL, &mut |out| {
            for channel in &self.channels {
                out.channel(channel);
            }
        });
        group(&mut out, opcode::STATISTICS, &mut |out| self.statistics(out));
        group(&mut out, opcode::CHUNK_INDEX, &mut |out| {
            for chunk in &self.chunks {
                chunk.write(out);
            }
        });
        group(&mut out, opcode::METADATA_INDEX, &mut |out| {
            for (at, length, name) in &self.metadata {
                out.record(opcode::METADATA_INDEX, |out| _ = out.u64(*at).u64(*length).text(name));
            }
        });
        let offsets = self.length + out.0.len() as u64;
        for (kind, from, length) in groups {
            out.record(opcode::SUMMARY_OFFSET, |out| {
                out.0.push(kind);
                out.u64(from).u64(length);
            });
        }
        out.record(opcode::FOOTER, |out| {
            out.u64(start).u64(offsets);
            // The CRC covers the summary and the footer up to here; the footer's length is filled in later.
            let mut covered = out.0[data_end..].to_vec();
            let length_at = covered.len() - 16 - PREFIX + 1;
            covered[length_at..length_at + 8].copy_from_slice(&20_u64.to_le_bytes());
            out.u32(crc32fast::hash(&covered));
        });
        out.0.extend(MAGIC);
        out.0
    }

    fn statistics(&self, out: &mut Encoder) {
        let (start, end) = self.times.unwrap_or((0, 0));
        out.record(opcode::STATISTICS, |out| {
            out.u64(self.counts.values().sum()).u16(self.schemas.len() as u16).u32(self.channels.len() as u32);
            out.u32(0).u32(self.metadata.len() as u32).u32(self.chunks.len() as u32).u64(start).u64(end);
            out.u32((10 * self.counts.len()) as u32);
            for (channel, count) in &self.counts {
                out.u16(*channel).u64(*count);
            }
        });
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.target.write_all(bytes)?;
        self.data.update(bytes);
        self.length += bytes.len() as u64;
        Ok(())
    }
}

impl OpenChunk {
    /// Moves the last message, of a channel and at a position, to a chunk of its own.
    fn split_last(&mut self, channel: u16, start: usize) -> Self {
        let records = Encoder(self.records.0.split_off(start));
        let messages = self.indexes.entry(channel).or_default();
        let time = messages.pop().map_or(self.end_time, |(time, _)| time);
        if messages.is_empty() {
            self.indexes.remove(&channel);
        }
        Self { records, indexes: BTreeMap::from([(channel, vec![(time, 0)])]), start_time: time, end_time: time }
    }
}

impl ChunkIndex {
    fn write(&self, out: &mut Encoder) {
        out.record(opcode::CHUNK_INDEX, |out| {
            out.u64(self.start_time).u64(self.end_time).u64(self.at).u64(self.length);
            out.u32((10 * self.indexes.len()) as u32);
            for (channel, at) in &self.indexes {
                out.u16(*channel).u64(*at);
            }
            out.u64(self.indexes_length).text(self.compression).u64(self.compressed).u64(self.uncompressed);
        });
    }
}

fn lz4(bytes: &[u8]) -> io::Result<Vec<u8>> {
    // A reader fills a buffer of a block's size with zeros, however small the chunk is.
    let block = match bytes.len() {
        ..=0x1_0000 => BlockSize::Max64KB,
        0x1_0001..=0x4_0000 => BlockSize::Max256KB,
        _ => BlockSize::Max1MB,
    };
    let frame = FrameInfo::new().block_size(block).block_mode(BlockMode::Linked);
    let mut encoder = FrameEncoder::with_frame_info(frame, Vec::with_capacity(bytes.len() / 2));
    encoder.write_all(bytes)?;
    encoder.finish().map_err(io::Error::from)
}
