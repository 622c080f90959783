//! Reading of a recording, cycle by cycle.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{BufReader, Read, Seek as _, SeekFrom};
use std::path::Path;

use bica::Format;
use serde::Deserialize;

use crate::blob::{BlobRecord, StoredBlob};
use crate::contents::{Contents, Part};
use crate::error::Error;
use crate::header::{Ending, Header};
use crate::image_codec::ImageCoder;
use crate::layout::{Layout, MAX_BLOBS, MAX_CYCLE_BYTES};
use crate::mcap::{Item, Message, Reader};
use crate::message::{Channel, Costs, HoldsRecord, LogLine, RunEvent, Tick, TreeRecord};
use crate::outputs::OutputsRecord;
use crate::request::RequestRecord;

/// Recorded data of a cycle.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RecordedCycle {
    /// Instant and digests.
    pub tick: Tick,
    /// Requests that were applied before it.
    pub requests: Vec<RequestRecord>,
    /// Sensor values, encoded without their large data, if they are stored.
    pub sensors: Option<Vec<u8>>,
    /// Large data of the sensor values, if it is stored.
    pub blobs: Vec<StoredBlob>,
    /// Command, encoded, if it is stored.
    pub command: Option<Vec<u8>>,
    /// Active components and states.
    pub tree: TreeRecord,
    /// Events since the last cycle.
    pub events: Vec<RunEvent>,
    /// Lines of text since the last cycle.
    pub log: Vec<LogLine>,
    /// Time of the components.
    pub costs: Option<Costs>,
    /// Values of outputs, in some cycles.
    pub outputs: Option<OutputsRecord>,
    /// Holds and rates, if they changed and a monitor made the recording.
    pub holds: Option<HoldsRecord>,
}

impl RecordedCycle {
    /// Returns the large data, concatenated, as [`Recordable::decode_sensors`](bica_wire::Recordable::decode_sensors) expects it.
    #[must_use]
    pub fn blob_bytes(&self) -> Cow<'_, [u8]> {
        match &self.blobs[..] {
            [] => Cow::Borrowed(&[]),
            [blob] => Cow::Borrowed(&blob.bytes),
            blobs => Cow::Owned(blobs.iter().flat_map(|blob| &blob.bytes).copied().collect()),
        }
    }

    /// Returns whether the cycle had large data that was dropped while recording.
    #[must_use]
    pub fn is_gap(&self) -> bool {
        self.sensors.is_some() && self.tick.blobs != 0 && self.blobs.is_empty()
    }
}

/// Recording that is being read.
#[derive(Debug)]
pub struct Recording<R> {
    contents: Contents<R>,
    /// Large data that waits for its cycle, by its number.
    blobs: BTreeMap<u32, WaitingBlob>,
    /// Whether large data is decoded.
    decodes: bool,
    places: Vec<BlobPlace>,
    coder: ImageCoder,
    next: RecordedCycle,
    /// Number of bytes of the messages since the last cycle.
    next_bytes: usize,
}

/// Large data that was read before its cycle.
#[derive(Debug)]
struct WaitingBlob {
    message: Message,
    cycle: Option<u64>,
    part: u16,
    is_image: bool,
}

/// Opens a file for reading. A pipe or a device is refused, because opening it may wait without end.
///
/// # Errors
/// [`Error::NotAFile`], or that of the operating system.
pub fn open(path: &Path) -> Result<BufReader<File>, Error> {
    if !fs::metadata(path)?.is_file() {
        return Err(Error::NotAFile);
    }
    Ok(BufReader::with_capacity(1 << 16, File::open(path)?))
}

impl Recording<BufReader<File>> {
    /// Opens a file and reads its header.
    ///
    /// # Errors
    /// If the file cannot be read or is no recording.
    pub fn open(path: &Path) -> Result<Self, Error> {
        Self::new(open(path)?)
    }
}

impl<R: Read> Recording<R> {
    /// Reads the header.
    ///
    /// # Errors
    /// If the source cannot be read or is no recording.
    pub fn new(source: R) -> Result<Self, Error> {
        Ok(Self {
            contents: Contents::new(source)?,
            blobs: BTreeMap::new(),
            decodes: true,
            places: Vec::new(),
            coder: ImageCoder::default(),
            next: RecordedCycle::default(),
            next_bytes: 0,
        })
    }

    /// Leaves large data in the file: cycles have only its [places](Self::blob_places).
    #[must_use]
    pub fn without_blobs(self) -> Self {
        Self { decodes: false, ..self }
    }

    /// Returns the places of the large data of the last cycle.
    pub fn blob_places(&self) -> &[BlobPlace] {
        &self.places
    }

    /// Returns the header.
    pub const fn header(&self) -> &Header {
        &self.contents.header
    }

    /// Returns the ending, once it has been read: the last record of a file that was closed.
    pub const fn ending(&self) -> Option<&Ending> {
        self.contents.ending.as_ref()
    }

    /// Returns the data recorded after the last complete cycle: events of that cycle, such as a goal that ended the game.
    pub const fn rest(&self) -> &RecordedCycle {
        &self.next
    }

    /// Returns the number of bytes read so far.
    pub const fn position(&self) -> u64 {
        self.contents.position()
    }

    /// Returns the next cycle; none at the end of a file that was closed.
    ///
    /// # Errors
    /// As [`Reader::next_item`]; [`Error::Damaged`] if a message cannot be read.
    pub fn next_cycle(&mut self) -> Result<Option<RecordedCycle>, Error> {
        loop {
            match self.contents.next()? {
                Part::Message(channel, message) if self.message(channel, &message)? => {
                    let next = RecordedCycle { tree: self.next.tree.clone(), ..RecordedCycle::default() };
                    return Ok(Some(std::mem::replace(&mut self.next, next)));
                }
                Part::End => return Ok(None),
                Part::Message(..) | Part::Chunk => {}
            }
        }
    }

    /// Processes a message; returns whether the cycle is complete.
    fn message(&mut self, channel: Channel, message: &Message) -> Result<bool, Error> {
        let next = &mut self.next;
        // The large data of up to a second precedes its cycles.
        self.next_bytes += if channel == Channel::Blobs { 0 } else { message.data.len() };
        if self.next_bytes > MAX_CYCLE_BYTES {
            return Err(Error::damaged(message.chunk_at, "too many messages without a cycle"));
        }
        match channel {
            Channel::Requests => next.requests.push(decode(message)?),
            Channel::Sensors => next.sensors = Some(message.data.clone()),
            Channel::Command => next.command = Some(message.data.clone()),
            Channel::Tree => next.tree = decode(message)?,
            Channel::Events => next.events.push(decode(message)?),
            Channel::Log => next.log.push(decode(message)?),
            Channel::Costs => next.costs = Some(decode(message)?),
            Channel::Outputs => next.outputs = Some(decode(message)?),
            Channel::Holds => next.holds = Some(decode(message)?),
            Channel::Blobs => self.wait(message)?,
            Channel::Tick => {
                next.tick = decode(message)?;
                self.next_bytes = 0;
                self.take_blobs()?;
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Stores large data, which precedes its cycle.
    fn wait(&mut self, message: &Message) -> Result<(), Error> {
        let BlobRecord { id, cycle, part, format, .. } = decode(message)?;
        let is_image = matches!(format, Format::Yuyv { .. });
        self.blobs.insert(id, WaitingBlob { message: message.clone(), cycle, part, is_image });
        let mut bytes: usize = self.blobs.values().map(|blob| blob.message.data.len()).sum();
        while self.blobs.len() > MAX_BLOBS || bytes > MAX_CYCLE_BYTES {
            bytes -= self.blobs.pop_first().map_or(bytes, |(_, blob)| blob.message.data.len());
        }
        Ok(())
    }

    /// Takes the large data of the next cycle, which is complete. A monitor may receive an image after its cycle; then the image
    /// comes with a later cycle.
    fn take_blobs(&mut self) -> Result<(), Error> {
        self.places.clear();
        let (number, of_monitor) = (self.next.tick.cycle, self.contents.header.monitor.is_some());
        let end = self.contents.header.nanoseconds(self.next.tick.instant);
        let is_of_cycle = |blob: &WaitingBlob| match blob.cycle {
            Some(cycle) => cycle == number,
            None => of_monitor && blob.message.time <= end,
        };
        let ids: Vec<u32> = self.blobs.iter().filter(|(_, blob)| is_of_cycle(blob)).map(|(id, _)| *id).collect();
        // In a recording of a monitor, each cycle takes at most one image.
        let ids = if of_monitor { &ids[..ids.len().min(1)] } else { &ids[..] };
        let mut taken: Vec<_> = ids.iter().filter_map(|id| Some((*id, self.blobs.remove(id)?))).collect();
        taken.sort_by_key(|(_, blob)| blob.part);
        for (id, WaitingBlob { message, is_image, .. }) in &taken {
            let &Message { channel, time, chunk_at, .. } = message;
            self.places.push(BlobPlace { id: *id, channel, time, chunk_at, is_image: *is_image });
            if self.decodes {
                self.next.blobs.push(decode_blob(&mut self.coder, message)?);
            }
        }
        Ok(())
    }
}

fn decode_blob(coder: &mut ImageCoder, message: &Message) -> Result<StoredBlob, Error> {
    let record: BlobRecord<'_> = decode(message)?;
    let unreadable = || Error::damaged(message.chunk_at, format!("image {} cannot be decoded", record.id));
    record.decode(coder).ok_or_else(unreadable)
}

/// Place of large data in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BlobPlace {
    /// Number in the recording, from 1.
    pub id: u32,
    /// Number of the channel in the file.
    pub channel: u16,
    /// Time of the cycle that received it, ns since the start of the run's clock.
    pub time: u64,
    /// Position of its chunk, bytes.
    pub chunk_at: u64,
    /// Whether it is an image in YUYV.
    pub is_image: bool,
}

impl BlobPlace {
    /// Reads the data from its file.
    ///
    /// # Errors
    /// If the file cannot be read, or has no such data there any more.
    pub fn read(&self, path: &Path) -> Result<StoredBlob, Error> {
        let mut file = open(path)?;
        file.seek(SeekFrom::Start(self.chunk_at))?;
        let mut reader = Reader::resume(file, self.chunk_at);
        let gone = || Error::damaged(self.chunk_at, format!("image {} is not there", self.id));
        let mut chunks = 0;
        while chunks < 2 {
            match reader.next_item()? {
                Item::Message(message) if message.channel == self.channel => {
                    let message = Layout::Present.content(message)?;
                    if decode::<BlobRecord<'_>>(&message)?.id == self.id {
                        return decode_blob(&mut ImageCoder::default(), &message);
                    }
                }
                Item::Chunk { .. } => chunks += 1,
                Item::End => break,
                _ => {}
            }
        }
        Err(gone())
    }
}

/// Returns the value of a message.
pub(crate) fn decode<'a, T: Deserialize<'a>>(message: &'a Message) -> Result<T, Error> {
    let read = postcard::from_bytes(&message.data);
    read.map_err(|error| {
        Error::damaged(message.chunk_at, format!("a message of channel {} cannot be read: {error}", message.channel))
    })
}
