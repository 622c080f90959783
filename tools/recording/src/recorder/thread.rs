//! The thread that codes and writes.

use std::io;

use bica::Blob;

use super::output::Output;
use super::parts::Parts;
use super::queue::{BlobValues, CycleValues, Entry, KeptBlob, Queue};
use super::{Report, Sink};
use crate::blob::{BlobIndex, code};
use crate::digest::{RunningFingerprint, blobs_digest};
use crate::header::{Ending, Header, ImagePolicy};
use crate::image_codec::ImageCoder;
use crate::message::{Channel, Tick, TreeRecord};
use bica_wire::blobs::described;

/// A file that is being written.
pub(super) struct Writing<S> {
    output: Output<S>,
    header: Header,
    /// Active components and states after the last cycle, and their digest.
    tree: (TreeRecord, u32),
    /// Time of the last cycle, ns.
    last_time: u64,
    fingerprint: RunningFingerprint,
    coder: ImageCoder,
    /// Number of the last large data.
    last_blob: u32,
    /// Number of images that were dropped so far.
    dropped_images: u64,
    /// The parts, if the recording is split.
    parts: Option<Parts<S>>,
}

impl<S: Sink> Writing<S> {
    pub(super) fn new(sink: S, header: &Header, chunk_bytes: usize) -> io::Result<Self> {
        Ok(Self {
            output: Output::new(sink, header, chunk_bytes)?,
            header: header.clone(),
            tree: Default::default(),
            last_time: 0,
            fingerprint: RunningFingerprint::default(),
            coder: ImageCoder::default(),
            last_blob: 0,
            dropped_images: 0,
            parts: None,
        })
    }

    /// Continues in another file whenever a part has reached its limit.
    pub(super) fn in_parts(self, parts: Parts<S>) -> Self {
        Self { parts: Some(parts), ..self }
    }

    /// Writes until the run is over or writing fails.
    pub(super) fn run(mut self, queue: &Queue, on_end: &dyn Fn(&str)) -> Report {
        let (reason, ending) = loop {
            let batch = queue.take();
            self.dropped_images = batch.dropped_images;
            if let Err(error) = batch.entries.into_iter().try_for_each(|entry| self.entry(entry, queue)) {
                break (Some(format!("cannot write: {error}")), Ending::default());
            }
            if batch.overflow {
                let slow = || "the disk is too slow: the queue of cycles is full".to_owned();
                break (
                    Some(self.output.flush().map_or_else(|error| format!("cannot write: {error}"), |()| slow())),
                    Ending::default(),
                );
            }
            if let Some(ending) = batch.closing {
                break (None, ending);
            }
            if let Err(error) = self.output.flush_if_due() {
                break (Some(format!("cannot write: {error}")), Ending::default());
            }
        };
        let report = self.finish(reason, ending);
        if let Some(reason) = &report.reason {
            queue.end();
            on_end(reason);
        }
        report
    }

    fn finish(&mut self, reason: Option<String>, ending: Ending) -> Report {
        let (dropped_images, parts) = (self.dropped_images, self.parts.as_mut());
        let (bytes, dropped_before) = parts.as_ref().map_or((0, 0), |parts| (parts.bytes, parts.dropped_images));
        let reason = self.output.finish(reason, ending, dropped_images - dropped_before);
        let synced = parts.map_or(Ok(()), Parts::sync);
        Report {
            cycles: self.output.written_cycles,
            bytes: bytes + self.output.length(),
            dropped_images,
            reason: reason.or_else(|| synced.err().map(|error| format!("cannot write: {error}"))),
            parts: self.header.part.as_ref().map(|part| part.number),
        }
    }

    fn entry(&mut self, entry: Entry, queue: &Queue) -> io::Result<()> {
        match entry {
            Entry::Cycle(values) => self.cycle(values, queue)?,
            Entry::Event(event) => self.output.message(Channel::Events, event.at_ns, &event),
            Entry::Log(line) => self.output.message(Channel::Log, self.last_time, &line),
            Entry::Costs(costs) => self.output.message(Channel::Costs, self.last_time, &costs),
        }
        self.output.flush_if_large()?;
        self.output.flush_if_due()
    }

    fn cycle(&mut self, values: CycleValues, queue: &Queue) -> io::Result<()> {
        let CycleValues { instant, requests, message, sensor_bytes, blobs, outputs, tree } = values;
        let (sensors, command) = message.split_at(sensor_bytes);
        let time = self.header.nanoseconds(instant);
        self.last_time = time;
        if let Some(parts) = &mut self.parts {
            parts.advance(time, &mut self.output, &mut self.header, self.dropped_images)?;
            // The next part begins with the values that are in force there.
            for request in &requests {
                self.header.apply(request);
            }
        }
        for request in &requests {
            self.fingerprint.add_request(request);
            self.output.message(Channel::Requests, time, request);
        }
        let stores_values = self.header.images == ImagePolicy::All;
        if stores_values && let BlobValues::Kept(kept) = &blobs {
            self.output.begin_cycle(kept.len(), kept.iter().map(|blob| blob.bytes().len()).sum())?;
            self.blobs(time, sensors, kept);
        }
        let blobs_digest = match &blobs {
            BlobValues::None => 0,
            BlobValues::Kept(kept) => blobs_digest(kept.iter().map(KeptBlob::bytes)),
            BlobValues::Digest(hash) => {
                self.last_blob = self.last_blob.wrapping_add(1);
                hash.clone().finalize()
            }
        };
        queue.give_back(blobs);
        if stores_values {
            self.output.encoded(Channel::Sensors, time, sensors);
            self.output.encoded(Channel::Command, time, command);
        }
        if let Some(outputs) = &outputs {
            self.output.encoded(Channel::Outputs, time, outputs);
        }
        let is_changed = tree.is_some();
        if let Some(tree) = tree {
            let digest = tree.digest();
            self.tree = (tree, digest);
        }
        if is_changed || self.output.is_empty() {
            self.output.message(Channel::Tree, time, &self.tree.0);
        }
        let mut tick = Tick {
            cycle: self.output.cycles,
            instant,
            sensors: crc32fast::hash(sensors),
            blobs: blobs_digest,
            command: crc32fast::hash(command),
            tree: self.tree.1,
            fingerprint: 0,
        };
        tick.fingerprint = self.fingerprint.add_tick(&tick);
        self.output.message(Channel::Tick, time, &tick);
        self.output.end_cycle()
    }

    fn blobs(&mut self, time: u64, sensors: &[u8], kept: &[KeptBlob]) {
        let cycle = Some(self.output.cycles);
        for (part, blob) in (0..).zip(kept) {
            let (format, frame) = described(&sensors[blob.at..]);
            self.last_blob = self.last_blob.wrapping_add(1);
            let index = BlobIndex { id: self.last_blob, cycle, part };
            let output = &mut self.output;
            code(&Blob { bytes: blob.bytes(), format, frame }, index, &mut self.coder, |compression, record| {
                output.blob(compression, time, record);
            });
        }
    }
}
