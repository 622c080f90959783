//! The file of a recording that is being made.

use std::io;
use std::time::{Duration, Instant};

use serde::Serialize;

use super::Sink;
use super::syncer::Syncer;
use crate::blob::BlobRecord;
use crate::encode::encode;
use crate::header::{Ending, Header};
use crate::layout::{MAX_BLOBS, MAX_CYCLE_BYTES};
use crate::mcap::Compression;
use crate::message::Channel;
use crate::writer::RecordingWriter;

/// Longest time that values wait in memory.
const FLUSH_AFTER: Duration = Duration::from_millis(300);
/// Maximum time after which the operating system is asked to bring everything to the disk.
const SYNC_AFTER: Duration = Duration::from_millis(500);

/// The file of a recording. Its chunks are complete soon after their values have arrived.
#[derive(Debug)]
pub(crate) struct Output<S> {
    writer: RecordingWriter<S>,
    /// Memory of a message.
    message: Vec<u8>,
    syncer: Syncer,
    chunk_bytes: usize,
    /// Number and bytes of the large data that wait in memory.
    blobs: (usize, usize),
    /// Number of the first cycle of the file.
    first_cycle: u64,
    /// Number of cycles of the run so far.
    pub(crate) cycles: u64,
    /// Number of those that are written.
    pub(crate) written_cycles: u64,
    flushed: Instant,
    synced: Instant,
}

impl<S: Sink> Output<S> {
    /// Begins a file with a header.
    pub(crate) fn new(sink: S, header: &Header, chunk_bytes: usize) -> io::Result<Self> {
        Self::from_cycle(sink, header, chunk_bytes, 0)
    }

    /// Begins the file with the next part of the run.
    pub(super) fn next(&self, sink: S, header: &Header) -> io::Result<Self> {
        Self::from_cycle(sink, header, self.chunk_bytes, self.cycles)
    }

    fn from_cycle(sink: S, header: &Header, chunk_bytes: usize, first_cycle: u64) -> io::Result<Self> {
        let syncer = Syncer::start(sink.syncing()?)?;
        let (writer, now) = (RecordingWriter::new(sink, header)?, Instant::now());
        let (message, blobs, cycles, written_cycles) = (Vec::new(), (0, 0), first_cycle, first_cycle);
        Ok(Self {
            writer,
            message,
            syncer,
            chunk_bytes,
            blobs,
            first_cycle,
            cycles,
            written_cycles,
            flushed: now,
            synced: now,
        })
    }

    /// Returns whether the file has no cycle.
    pub(super) const fn is_empty(&self) -> bool {
        self.cycles == self.first_cycle
    }

    /// Returns the number of bytes that wait in memory.
    pub(super) fn pending(&self) -> usize {
        self.writer.pending()
    }

    /// Returns the length of the file, bytes.
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
        let (count, bytes) = self.blobs;
        self.blobs = (count + 1, bytes + self.message.len());
    }

    fn add(&mut self, channel: Channel, compression: Compression, time: u64, value: &impl Serialize) {
        self.message.clear();
        encode(&mut self.message, value);
        self.writer.message(channel, compression, time, &self.message);
    }

    /// Begins a cycle with a number of large data and their size before they are coded, bytes. Writes the cycles so far if their
    /// large data and those of this cycle might exceed the limits of a reader.
    pub(crate) fn begin_cycle(&mut self, blobs: usize, bytes: usize) -> io::Result<()> {
        // Topics and codes may need more room than the data.
        let has_room = self.writer.pending().saturating_add(bytes.saturating_mul(4)) <= MAX_CYCLE_BYTES;
        if has_room && self.blobs.0 + blobs <= MAX_BLOBS { Ok(()) } else { self.flush() }
    }

    /// Ends a cycle.
    ///
    /// # Errors
    /// If a reader would refuse it.
    pub(crate) fn end_cycle(&mut self) -> io::Result<()> {
        let (cycle, (blobs, bytes)) = (self.cycles, self.blobs);
        if blobs > MAX_BLOBS || bytes > MAX_CYCLE_BYTES {
            let what = format!(
                "cycle {cycle} has {bytes} bytes of {blobs} images or other large data; a recording holds at most \
                 {MAX_CYCLE_BYTES} bytes of {MAX_BLOBS} in a cycle"
            );
            return Err(io::Error::new(io::ErrorKind::FileTooLarge, what));
        }
        self.cycles += 1;
        Ok(())
    }

    /// Writes everything.
    pub(crate) fn flush(&mut self) -> io::Result<()> {
        self.writer.flush()?;
        self.blobs = (0, 0);
        self.written_cycles = self.cycles;
        self.flushed = Instant::now();
        Ok(())
    }

    /// Writes the chunk if it is large enough.
    pub(crate) fn flush_if_large(&mut self) -> io::Result<()> {
        if self.writer.pending() >= self.chunk_bytes { self.flush() } else { Ok(()) }
    }

    /// Writes the chunk and requests a sync, each if it is due.
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

    /// Closes the file with the result in `ending` and waits until it is on the disk; returns why the recording ended early. A file that
    /// cannot be closed keeps its complete chunks.
    pub(crate) fn finish(&mut self, reason: Option<String>, ending: Ending, dropped_images: u64) -> Option<String> {
        let failed = self.close(reason, ending, dropped_images);
        let synced = self.sync().err();
        failed.or_else(|| synced.as_ref().map(end_failed))
    }

    /// Closes the file as [`finish`](Self::finish) does, without waiting for the disk.
    pub(super) fn close(&mut self, reason: Option<String>, ending: Ending, dropped_images: u64) -> Option<String> {
        let mut failed = reason;
        if failed.is_none() {
            failed = self.flush().err().map(|error| format!("cannot write: {error}"));
        }
        if failed.is_some() {
            self.writer.discard();
            self.truncate();
        }
        let (cycles, reason) = (self.written_cycles - self.first_cycle, failed.clone().unwrap_or_default());
        let closed = self.writer.close(&Ending { cycles, dropped_images, reason, ..ending });
        let closed = closed.and_then(|()| self.syncer.request());
        if let Err(error) = closed {
            self.truncate();
            failed = failed.or_else(|| Some(end_failed(&error)));
        }
        failed
    }

    /// Waits until everything written is on the disk.
    pub(super) fn sync(&mut self) -> io::Result<()> {
        self.syncer.finish()
    }

    /// Removes what an incomplete write has left behind: it would make the rest unreadable.
    fn truncate(&mut self) {
        let length = self.writer.length();
        let _ = self.writer.target_mut().truncate(length);
    }
}

fn end_failed(error: &io::Error) -> String {
    format!("cannot write the end of the file: {error}")
}
