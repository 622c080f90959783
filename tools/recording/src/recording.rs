//! Reading of a recording, cycle by cycle.

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{BufReader, Read, Seek as _, SeekFrom};
use std::path::Path;

use bica_wire::message::{Command, Sensors};
use serde::Deserialize;

use crate::contents::{Contents, Part};
use crate::digest::image_digest;
use crate::error::Error;
use crate::header::{Ending, Header};
use crate::image_codec::ImageCoder;
use crate::information::InformationRecord;
use crate::mcap::{Item, Message, Reader};
use crate::message::{
    Channel, CommandRecord, Costs, HoldsRecord, ImageRecord, LogLine, RefereeEvent, Tick, TreeRecord,
};
use crate::request::RequestRecord;

/// Most images that wait for their cycle.
const MAX_WAITING_IMAGES: usize = 64;
/// Most bytes of messages of one cycle, and of images that wait for theirs. A loop cannot produce more, a damaged file can.
const MAX_WAITING_BYTES: usize = 64 << 20;

/// Everything that is recorded of a cycle.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RecordedCycle {
    /// Instant and digests.
    pub tick: Tick,
    /// Requests that were applied before it.
    pub requests: Vec<RequestRecord>,
    /// Sensor values, if they are stored.
    pub sensors: Option<Sensors>,
    /// Image, if there was one and it is stored.
    pub image: Option<OwnedImage>,
    /// Command, if it is stored.
    pub command: Option<Command>,
    /// Active components and states.
    pub tree: TreeRecord,
    /// Events since the last cycle.
    pub events: Vec<RefereeEvent>,
    /// Lines of text since the last cycle.
    pub log: Vec<LogLine>,
    /// Time of the components.
    pub costs: Option<Costs>,
    /// Values of information, in some cycles.
    pub information: Option<InformationRecord>,
    /// Holds and rates, if they changed and a monitor made the recording.
    pub holds: Option<HoldsRecord>,
}

/// An image in memory of its own.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct OwnedImage {
    /// Whether the bottom camera took it.
    pub bottom_camera: bool,
    /// Width, px.
    pub width: u16,
    /// Height, px.
    pub height: u16,
    /// YUYV 4:2:2.
    pub yuyv: Vec<u8>,
}

impl OwnedImage {
    /// Returns its digest, as in [`Tick::image`].
    #[must_use]
    pub fn digest(&self) -> u32 {
        image_digest(self.bottom_camera, self.width, self.height, &self.yuyv)
    }
}

/// Recording that is being read.
#[derive(Debug)]
pub struct Recording<R> {
    contents: Contents<R>,
    /// Images that wait for their cycle.
    images: BTreeMap<u32, WaitingImage>,
    /// Whether images are decoded.
    decodes: bool,
    place: Option<ImagePlace>,
    coder: ImageCoder,
    next: RecordedCycle,
    /// Number of bytes of the messages since the last cycle.
    next_bytes: usize,
}

/// An image that was read before its cycle.
#[derive(Debug)]
struct WaitingImage {
    record: ImageRecord,
    /// Number of its channel.
    channel: u16,
    /// Time of the image, ns.
    time: u64,
    /// Position of its chunk, bytes.
    chunk_at: u64,
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
            images: BTreeMap::new(),
            decodes: true,
            place: None,
            coder: ImageCoder::default(),
            next: RecordedCycle::default(),
            next_bytes: 0,
        })
    }

    /// Leaves images in the file: cycles have only their [places](Self::image_place).
    #[must_use]
    pub fn without_images(self) -> Self {
        Self { decodes: false, ..self }
    }

    /// Returns the place of the image of the last cycle, if it had one that is stored.
    pub const fn image_place(&self) -> Option<ImagePlace> {
        self.place
    }

    /// Returns the header.
    pub const fn header(&self) -> &Header {
        &self.contents.header
    }

    /// Returns the ending, once it has been read: the last record of a file that was closed.
    pub const fn ending(&self) -> Option<&Ending> {
        self.contents.ending.as_ref()
    }

    /// Returns what was recorded after the last complete cycle: events of that cycle, as a goal that ended the game.
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

    /// Takes a message in; returns whether the cycle is complete.
    fn message(&mut self, channel: Channel, message: &Message) -> Result<bool, Error> {
        let next = &mut self.next;
        // The images of up to a second precede their cycles.
        self.next_bytes += if channel == Channel::Images { 0 } else { message.data.len() };
        if self.next_bytes > MAX_WAITING_BYTES {
            return Err(Error::damaged(message.chunk_at, "too many messages without a cycle"));
        }
        match channel {
            Channel::Requests => next.requests.push(decode(message)?),
            Channel::Sensors => next.sensors = Some(decode(message)?),
            Channel::Command => next.command = Some(decode::<CommandRecord>(message)?.command),
            Channel::Tree => next.tree = decode(message)?,
            Channel::Events => next.events.push(decode(message)?),
            Channel::Log => next.log.push(decode(message)?),
            Channel::Costs => next.costs = Some(decode(message)?),
            Channel::Information => next.information = Some(decode(message)?),
            Channel::Holds => next.holds = Some(decode(message)?),
            Channel::Images => {
                let record: ImageRecord = decode(message)?;
                let &Message { channel, time, chunk_at, .. } = message;
                self.images.insert(record.id, WaitingImage { record, channel, time, chunk_at });
                let mut bytes: usize = self.images.values().map(|image| image.record.coded.len()).sum();
                while self.images.len() > MAX_WAITING_IMAGES || bytes > MAX_WAITING_BYTES {
                    bytes -= self.images.pop_first().map_or(bytes, |(_, image)| image.record.coded.len());
                }
            }
            Channel::Tick => {
                next.tick = decode(message)?;
                self.next_bytes = 0;
                self.place = None;
                if let Some(WaitingImage { record, channel, time, chunk_at }) = self.image_of_cycle() {
                    let ImageRecord { id, bottom_camera, width, height, .. } = record;
                    self.place = Some(ImagePlace { id, channel, time, chunk_at, bottom_camera, width, height });
                    if self.decodes {
                        self.next.image = Some(decode_image(&mut self.coder, &record, chunk_at)?);
                    }
                }
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Takes the image of the next cycle, which is complete: the sensor values name it. A monitor may receive an image later than its
    /// cycle; then it comes with a later one.
    fn image_of_cycle(&mut self) -> Option<WaitingImage> {
        if self.contents.header.monitor.is_none() {
            return self.images.remove(&self.next.sensors?.image?.id);
        }
        let end = self.contents.header.nanoseconds(self.next.tick.instant);
        let first = self.images.first_entry().filter(|first| first.get().time <= end)?;
        Some(first.remove())
    }
}

fn decode_image(coder: &mut ImageCoder, coded: &ImageRecord, at: u64) -> Result<OwnedImage, Error> {
    let ImageRecord { bottom_camera, width, height, .. } = *coded;
    let mut yuyv = Vec::new();
    let decoded = coder.decode(&coded.coded, width.into(), height.into(), &mut yuyv);
    decoded.map_err(|_| Error::damaged(at, format!("image {} cannot be decoded", coded.id)))?;
    Ok(OwnedImage { bottom_camera, width, height, yuyv })
}

/// Place of an image in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ImagePlace {
    /// Number of the image, as in the sensor values.
    pub id: u32,
    /// Number of the channel of images in the file.
    pub channel: u16,
    /// Time of the cycle that took it in, ns since the start of the run's clock.
    pub time: u64,
    /// Position of its chunk, bytes.
    pub chunk_at: u64,
    /// Whether the bottom camera took it.
    pub bottom_camera: bool,
    /// Width, px.
    pub width: u16,
    /// Height, px.
    pub height: u16,
}

impl ImagePlace {
    /// Reads the image from its file.
    ///
    /// # Errors
    /// If the file cannot be read, or has no such image there any more.
    pub fn read(&self, path: &Path) -> Result<OwnedImage, Error> {
        let mut file = open(path)?;
        file.seek(SeekFrom::Start(self.chunk_at))?;
        let mut reader = Reader::resume(file, self.chunk_at);
        let gone = || Error::damaged(self.chunk_at, format!("image {} is not there", self.id));
        let mut chunks = 0;
        while chunks < 2 {
            match reader.next_item()? {
                Item::Message(message) if message.channel == self.channel => {
                    let image: ImageRecord = decode(&message)?;
                    if image.id == self.id {
                        return decode_image(&mut ImageCoder::default(), &image, self.chunk_at);
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
