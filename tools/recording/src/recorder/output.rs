//! The file of a recording that is being made.

use std::io;
use std::time::{Duration, Instant};

use serde::Serialize;

use super::Sink;
use super::syncer::Syncer;
use crate::blob::BlobRecord;
use crate::encode::encode;
use crate::header::{Ending, Header};
use crate::mcap::Compression;
use crate::message::Channel;
use crate::writer::RecordingWriter;

/// Longest time that values wait in memory.
const FLUSH_AFTER: Duration = Duration::from_millis(300);
/// Longest time after which the operating system is asked to bring everything to the disk.
const SYNC_AFTER: Duration = Duration::from_millis(500);

/// The file of a recording: chunks that are complete soon after their values came.
#[derive(Debug)]
pub(crate) struct Output<S> {
    writer: RecordingWriter<S>,
    /// Memory of a message.
    message: Vec<u8>,
    syncer: Syncer,
    chunk_bytes: usize,
    /// Number of cycles so far.
    pub(crate) cycles: u64,
    /// Number of cycles in the file.
    pub(crate) written_cycles: u64,
    flushed: Instant,
    synced: Instant,
}

impl<S: Sink> Output<S> {
    /// Begins a file with a header.
    pub(crate) fn new(sink: S, header: &Header, chunk_bytes: usize) -> io::Result<Self> {
        let syncer = Syncer::start(sink.syncing()?)?;
        let (writer, now) = (RecordingWriter::new(sink, header)?, Instant::now());
        let (cycles, written_cycles) = (0, 0);
        Ok(Self { writer, message: Vec::new(), syncer, chunk_bytes, cycles, written_cycles, flushed: now, synced: now })
    }

    /// Length of the file, bytes.
    pub(crate) const fn length(&self) -> u64 {
        self.writer.length()
    }

    /// Adds a message.
    pub(crate) fn message(&mut self, channel: Channel, time: u64, value: &impl Serialize) {
        self.add(channel, Compression::Lz4, time, value);
    }

    /// Adds a message that is encoded already.
    pub(crate) fn encoded(&mut self, channel: Channel, time: u64, bytes: &[u8]) {
        self.writer.message(channel, Compression::Lz4, time, bytes);
    }

    /// Adds large data.
    pub(crate) fn blob(&mut self, compression: Compression, time: u64, record: &BlobRecord<'_>) {
        self.add(Channel::Blobs, compression, time, record);
    }

    fn add(&mut self, channel: Channel, compression: Compression, time: u64, value: &impl Serialize) {
        self.message.clear();
        encode(&mut self.message, value);
        self.writer.message(channel, compression, time, &self.message);
    }

    /// Writes everything.
    pub(crate) fn flush(&mut self) -> io::Result<()> {
        self.writer.flush()?;
        self.written_cycles = self.cycles;
        self.flushed = Instant::now();
        Ok(())
    }

    /// Writes a chunk that is large enough.
    pub(crate) fn flush_if_large(&mut self) -> io::Result<()> {
        if self.writer.pending() >= self.chunk_bytes { self.flush() } else { Ok(()) }
    }

    /// Writes what has waited long enough.
    pub(crate) fn flush_if_due(&mut self) -> io::Result<()> {
        if self.flushed.elapsed() >= FLUSH_AFTER {
            self.flush()?;
        }
        if self.synced.elapsed() >= SYNC_AFTER {
            self.syncer.request()?;
            self.synced = Instant::now();
        }
        Ok(())
    }

    /// Closes the file with the result in `ending`; returns why the recording ended early. A file that cannot be closed keeps its complete
    /// chunks.
    pub(crate) fn finish(&mut self, reason: Option<String>, ending: Ending, dropped_images: u64) -> Option<String> {
        let mut failed = reason;
        if failed.is_none() {
            failed = self.flush().err().map(|error| format!("cannot write: {error}"));
        }
        if failed.is_some() {
            self.writer.discard();
            // What an incomplete write left behind would make the rest unreadable.
            let length = self.writer.length();
            let _ = self.writer.target_mut().truncate(length);
        }
        let reason = failed.clone().unwrap_or_default();
        let ending = Ending { cycles: self.written_cycles, dropped_images, reason, ..ending };
        let closed = self.writer.close(&ending).and_then(|()| self.syncer.finish());
        if let Err(error) = closed {
            let length = self.writer.length();
            let _ = self.writer.target_mut().truncate(length);
            failed = failed.or_else(|| Some(format!("cannot write the end of the file: {error}")));
        }
        failed
    }
}
