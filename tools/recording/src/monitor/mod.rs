//! Recordings that a monitor makes of a robot behind a link.

mod header;

use std::io;

use bica::{Blob, Format};
use bica_wire::message::ComponentState;

use crate::blob::{BlobIndex, code};
use crate::header::{Ending, Header};
use crate::image_codec::ImageCoder;
use crate::layout::MAX_BLOBS;
use crate::message::{Channel, HoldsRecord, Tick, TreeRecord};
use crate::outputs::OutputRecord;
use crate::recorder::{Output, Report, Sink};
use crate::recording::RecordedCycle;

/// Size of a chunk before compression, bytes.
const CHUNK_BYTES: usize = 1 << 20;
/// Maximum number of images in a chunk: a reader keeps twice as many until it has read their cycles.
const CHUNK_IMAGES: usize = MAX_BLOBS / 2;

impl RecordedCycle {
    /// Creates a cycle that a monitor has received: its number, its instant, µs, and the states of all components after it.
    #[must_use]
    pub fn received(number: u64, time_us: u64, states: impl Iterator<Item = ComponentState>) -> Self {
        let (mut tree, mut holds) = (TreeRecord::default(), HoldsRecord::default());
        for (index, ComponentState { active, held, state, hz }) in states.enumerate() {
            if index % 8 == 0 {
                tree.active.push(0);
            }
            tree.active[index / 8] |= u8::from(active) << (index % 8);
            tree.states.push(state.and_then(|state| u8::try_from(state).ok()).unwrap_or(u8::MAX));
            holds.holds.push(held);
            holds.rates.push(hz);
        }
        let tick = Tick { cycle: number, instant: time_us, ..Tick::default() };
        Self { tick, tree, holds: Some(holds), ..Self::default() }
    }

    /// Adds the value of an output in postcard's format; none if it is too large.
    pub fn add_output(&mut self, component: usize, index: usize, value: Option<&[u8]>) {
        let (component, index) = (component as u16, index as u16);
        let value = value.unwrap_or_default().to_vec();
        self.outputs.get_or_insert_default().values.push(OutputRecord { component, index, value });
    }
}

/// Writer of the data that a monitor has received.
///
/// Values are written when a chunk is full, and by [`write_if_due`](Self::write_if_due) at the latest after 0.3 s; every 0.5 s the
/// operating system is asked to bring them to the disk.
#[derive(Debug)]
pub struct MonitorRecorder<S> {
    output: Output<S>,
    tree: Option<TreeRecord>,
    tree_digest: u32,
    holds: Option<HoldsRecord>,
    coder: ImageCoder,
    /// Number of images of the open chunk.
    images: usize,
}

impl<S: Sink> MonitorRecorder<S> {
    /// Begins a file with a header that [`Header::of_monitor`] made.
    ///
    /// # Errors
    /// If the header cannot be written.
    pub fn new(sink: S, header: &Header) -> io::Result<Self> {
        let output = Output::new(sink, header, CHUNK_BYTES)?;
        Ok(Self { output, tree: None, tree_digest: 0, holds: None, coder: ImageCoder::default(), images: 0 })
    }

    /// Returns the length of the file, bytes.
    pub const fn length(&self) -> u64 {
        self.output.length()
    }

    /// Adds an image, before its cycle or after it: its number, from 0, the time of the cycle that received it, µs, and its pixels.
    /// An image with too few or too many pixels is omitted.
    ///
    /// # Errors
    /// If a chunk cannot be written; then [`finish`](Self::finish) keeps what is complete.
    pub fn image(&mut self, number: u32, time_us: u64, blob: &Blob<'_>) -> io::Result<()> {
        if let Format::Yuyv { width, height } = blob.format
            && blob.bytes.len() != 2 * usize::from(width) * usize::from(height)
        {
            return Ok(());
        }
        let (output, time) = (&mut self.output, time_us.saturating_mul(1000));
        let index = BlobIndex { id: number.wrapping_add(1), cycle: None, part: 0 };
        code(blob, index, &mut self.coder, |compression, record| output.blob(compression, time, record));
        self.images += 1;
        if self.images >= CHUNK_IMAGES { self.flush() } else { self.output.flush_if_large() }
    }

    /// Adds a cycle: number and instant (µs) of its tick, tree, holds, requests, events, log lines and outputs. Cycles come in
    /// the order of their instants; some may be missing.
    ///
    /// # Errors
    /// As [`image`](Self::image).
    pub fn cycle(&mut self, cycle: &RecordedCycle) -> io::Result<()> {
        let Tick { cycle: number, instant, .. } = cycle.tick;
        let (output, time) = (&mut self.output, instant.saturating_mul(1000));
        cycle.requests.iter().for_each(|request| output.message(Channel::Requests, time, request));
        cycle.events.iter().for_each(|event| output.message(Channel::Events, time, event));
        cycle.log.iter().for_each(|line| output.message(Channel::Log, time, line));
        if let Some(outputs) = &cycle.outputs {
            output.message(Channel::Outputs, time, outputs);
        }
        if let Some(holds) = cycle.holds.as_ref().filter(|holds| self.holds.as_ref() != Some(holds)) {
            output.message(Channel::Holds, time, holds);
            self.holds = Some(holds.clone());
        }
        if self.tree.as_ref() != Some(&cycle.tree) {
            output.message(Channel::Tree, time, &cycle.tree);
            self.tree_digest = cycle.tree.digest();
            self.tree = Some(cycle.tree.clone());
        }
        // Digests of data that were not received are 0.
        let tick = Tick { cycle: number, instant, tree: self.tree_digest, ..Tick::default() };
        output.message(Channel::Tick, time, &tick);
        output.cycles += 1;
        output.flush_if_large()
    }

    /// Writes the messages if they have waited long enough. Called at least every 0.1 s while a robot is recorded.
    ///
    /// # Errors
    /// As [`image`](Self::image).
    pub fn write_if_due(&mut self) -> io::Result<()> {
        self.output.flush_if_due()
    }

    fn flush(&mut self) -> io::Result<()> {
        self.images = 0;
        self.output.flush()
    }

    /// Closes the file. `reason` is why the recording ends early; if it is a failure of the disk, the file keeps all complete chunks.
    #[must_use]
    pub fn finish(mut self, reason: Option<String>, dropped_images: u64) -> Report {
        let reason = self.output.finish(reason, Ending::default(), dropped_images);
        Report { cycles: self.output.written_cycles, bytes: self.output.length(), dropped_images, reason, parts: None }
    }
}
