//! The thread that codes and writes.

use std::io;

use bica_wire::message::ImageInfo;
use serde::Serialize;

use super::output::Output;
use super::queue::{CycleValues, Entry, ImageValues, Queue};
use super::{Report, Sink};
use crate::digest::{RunningFingerprint, command_digest, image_digest, sensors_digest};
use crate::error::Error;
use crate::header::{ENDING_NAME, Ending, HEADER_NAME, Header, ImagePolicy, to_metadata};
use crate::image_codec::ImageCoder;
use crate::mcap::{ChannelRecord, Compression, SchemaRecord, Writer};
use crate::message::{Channel, CommandRecord, ENCODING, ImageRecord, Tick};

/// A file that is being written.
pub(super) struct Writing<S> {
    output: Output<S>,
    header: Header,
    tree_digest: u32,
    /// Time of the last cycle, ns.
    last_time: u64,
    fingerprint: RunningFingerprint,
    coder: ImageCoder,
}

/// Returns schemas and channels of a recording.
pub(crate) fn channels() -> (Vec<SchemaRecord>, Vec<ChannelRecord>) {
    let schema = |channel: Channel| SchemaRecord {
        id: channel.id(),
        name: format!("bica.{}", channel.schema().name),
        encoding: "postcard-schema".to_owned(),
        data: serde_json::to_vec(channel.schema()).unwrap_or_default(),
    };
    let channel = |channel: Channel| ChannelRecord {
        id: channel.id(),
        schema: channel.id(),
        topic: channel.topic().to_owned(),
        encoding: ENCODING.to_owned(),
    };
    (Channel::ALL.map(schema).to_vec(), Channel::ALL.map(channel).to_vec())
}

/// Begins a file: header, schemas and channels, and the header again.
pub(crate) fn begin<W: io::Write>(target: W, header: &Header) -> io::Result<Writer<W>> {
    let (schemas, channels) = channels();
    let fields = to_metadata(header).map_err(io_error)?;
    let mut writer = Writer::new(target, "bica")?;
    writer.metadata(HEADER_NAME, &fields)?;
    writer.declare(schemas, channels)?;
    writer.metadata(HEADER_NAME, &fields)?;
    Ok(writer)
}

/// Writes the ending of a recording, twice.
pub(crate) fn write_ending<W: io::Write>(writer: &mut Writer<W>, ending: &Ending) -> io::Result<()> {
    let fields = to_metadata(ending).map_err(io_error)?;
    writer.metadata(ENDING_NAME, &fields)?;
    writer.metadata(ENDING_NAME, &fields)
}

fn io_error(error: Error) -> io::Error {
    match error {
        Error::Io(error) => error,
        other => io::Error::other(other),
    }
}

/// Returns the chunk in which the messages of a channel are stored: coded images cannot be compressed further.
pub(crate) const fn compression(channel: Channel) -> Compression {
    if matches!(channel, Channel::Images) { Compression::None } else { Compression::Lz4 }
}

impl<S: Sink> Writing<S> {
    pub(super) fn new(sink: S, header: &Header, chunk_bytes: usize) -> io::Result<Self> {
        Ok(Self {
            output: Output::new(sink, header, chunk_bytes)?,
            header: header.clone(),
            tree_digest: 0,
            last_time: 0,
            fingerprint: RunningFingerprint::default(),
            coder: ImageCoder::default(),
        })
    }

    /// Writes until the run is over or writing fails.
    pub(super) fn run(mut self, queue: &Queue, on_end: &dyn Fn(&str)) -> Report {
        let mut dropped_images;
        let (reason, result) = loop {
            let batch = queue.take();
            dropped_images = batch.dropped_images;
            if let Err(error) = batch.entries.into_iter().try_for_each(|entry| self.entry(entry, queue)) {
                break (Some(format!("cannot write: {error}")), String::new());
            }
            if batch.overflow {
                let slow = || "the disk is too slow: the queue of cycles is full".to_owned();
                break (
                    Some(self.output.flush().map_or_else(|error| format!("cannot write: {error}"), |()| slow())),
                    String::new(),
                );
            }
            if let Some(result) = batch.closing {
                break (None, result);
            }
            if let Err(error) = self.output.flush_if_due() {
                break (Some(format!("cannot write: {error}")), String::new());
            }
        };
        let reason = self.output.finish(reason, result, dropped_images);
        if let Some(reason) = &reason {
            queue.end();
            on_end(reason);
        }
        Report { cycles: self.output.written_cycles, bytes: self.output.length(), dropped_images, reason }
    }

    fn entry(&mut self, entry: Entry, queue: &Queue) -> io::Result<()> {
        match entry {
            Entry::Cycle(values) => self.cycle(values, queue),
            Entry::Event(event) => self.output.message(Channel::Events, event.at_ns, &event),
            Entry::Log(line) => self.output.message(Channel::Log, self.last_time, &line),
            Entry::Costs(costs) => self.output.message(Channel::Costs, self.last_time, &costs),
        }
        self.output.flush_if_large()?;
        self.output.flush_if_due()
    }

    fn cycle(&mut self, values: CycleValues, queue: &Queue) {
        let CycleValues { instant, requests, sensors, image, command, information, tree } = values;
        let time = self.header.nanoseconds(instant);
        self.last_time = time;
        for request in &requests {
            self.fingerprint.add_request(request);
            self.output.message(Channel::Requests, time, request);
        }
        let stores_values = self.header.images == ImagePolicy::All;
        let pixels = match &image {
            ImageValues::Pixels(pixels) => Some(pixels),
            ImageValues::Shared(pixels) => Some(&**pixels),
            ImageValues::None | ImageValues::Digest(_) => None,
        };
        let digest = sensors.image.zip(pixels).map(|(info, pixels)| {
            if stores_values {
                self.image(time, &info, pixels);
            }
            image_digest(info.bottom_camera, info.width, info.height, pixels)
        });
        let image_digest = match &image {
            ImageValues::Digest(digest) => *digest,
            _ => digest.unwrap_or(0),
        };
        queue.give_back(image);
        if stores_values {
            self.output.message(Channel::Sensors, time, &sensors);
            self.output.message(Channel::Command, time, &CommandRecord { command });
        }
        if let Some(information) = &information {
            self.output.encoded(Channel::Information, time, information);
        }
        if let Some(tree) = &tree {
            self.tree_digest = tree.digest();
            self.output.message(Channel::Tree, time, tree);
        }
        let mut tick = Tick {
            cycle: self.output.cycles,
            instant,
            sensors: sensors_digest(&sensors),
            image: image_digest,
            command: command_digest(&command),
            tree: self.tree_digest,
            fingerprint: 0,
        };
        tick.fingerprint = self.fingerprint.add_tick(&tick);
        self.output.message(Channel::Tick, time, &tick);
        self.output.cycles += 1;
    }

    fn image(&mut self, time: u64, info: &ImageInfo, pixels: &[u8]) {
        let ImageInfo { id, bottom_camera, width, height } = *info;
        let mut coded = Vec::with_capacity(pixels.len() / 2);
        if self.coder.encode(pixels, width.into(), height.into(), &mut coded).is_ok() {
            self.output.message(Channel::Images, time, &ImageRecord { id, bottom_camera, width, height, coded });
        }
    }
}

/// Appends a value in postcard.
pub(crate) fn encode(out: &mut Vec<u8>, value: &impl Serialize) {
    // Writing into a vector does not fail, and no message has a type that postcard refuses.
    if let Ok(bytes) = postcard::to_extend(value, std::mem::take(out)) {
        *out = bytes;
    }
}
