//! Contents of a recording.

use std::collections::BTreeMap;
use std::io::Read;

use serde::Serialize;

use crate::error::Error;
use crate::header::{ENDING_NAME, Ending, HEADER_NAME, Header, from_metadata, header_of};
use crate::mcap::{Item, Message, Reader};
use crate::message::{Channel, RefereeEvent, Tick};
use crate::recording::decode;
use crate::request::RequestRecord;

/// Contents of a recording.
#[derive(Clone, Debug, Serialize)]
pub struct Info {
    /// The header.
    pub header: Header,
    /// The ending of a file that was closed.
    pub ending: Option<Ending>,
    /// Number of cycles.
    pub cycles: u64,
    /// Time between the first and the last cycle, s.
    pub seconds: f64,
    /// Fingerprint after the last cycle, hexadecimal; empty if a monitor made the recording.
    pub fingerprint: String,
    /// Length of the intact file, bytes.
    pub bytes: u64,
    /// Number of chunks.
    pub chunks: u64,
    /// What is wrong with the file; none if it is complete.
    pub damage: Option<String>,
    /// Channels with messages.
    pub channels: Vec<ChannelInfo>,
    /// Events of the referee.
    pub events: Vec<EventInfo>,
    /// Requests of operators.
    pub requests: Vec<RequestInfo>,
}

/// Contents of a channel.
#[derive(Clone, Debug, Default, Serialize)]
pub struct ChannelInfo {
    /// Topic.
    pub topic: String,
    /// Number of messages.
    pub messages: u64,
    /// Sum of their lengths before compression, bytes.
    pub bytes: u64,
}

/// An event of the referee.
#[derive(Clone, Debug, Serialize)]
pub struct EventInfo {
    /// Time, s.
    pub t: f64,
    /// Kind.
    pub event: String,
    /// Details.
    pub detail: String,
}

/// A request of an operator.
#[derive(Clone, Debug, Serialize)]
pub struct RequestInfo {
    /// Time, s.
    pub t: f64,
    /// The request, as text.
    pub request: String,
}

/// Most bytes of events, requests and names of channels. A game has some kilobytes, a damaged file may have any number.
const MAX_LISTED_BYTES: usize = 64 << 20;

impl Info {
    /// Reads a whole recording without decoding its images. A cut or damaged file is described up to there.
    ///
    /// # Errors
    /// If the source cannot be read or is no recording.
    pub fn read(source: impl Read) -> Result<Self, Error> {
        let mut reading =
            Reading { reader: Reader::new(source)?, channels: BTreeMap::new(), ticks: None, info: None, listed: 0 };
        let damage = loop {
            match reading.step() {
                Ok(true) => {}
                Ok(false) => break None,
                Err(error) if reading.info.is_some() && !matches!(error, Error::Io(_)) => {
                    break Some(error.to_string());
                }
                Err(error) => return Err(error),
            }
        };
        reading.finish(damage)
    }
}

struct Reading<R> {
    reader: Reader<R>,
    channels: BTreeMap<u16, ChannelInfo>,
    /// First and last.
    ticks: Option<(Tick, Tick)>,
    info: Option<Info>,
    /// Number of bytes of events, requests and names of channels.
    listed: usize,
}

impl<R: Read> Reading<R> {
    /// Takes in the next part; returns whether there may be more.
    fn step(&mut self) -> Result<bool, Error> {
        match self.reader.next_item()? {
            Item::End => return Ok(false),
            Item::Channel(channel) => {
                self.list(channel.topic.len(), self.reader.position())?;
                self.channels
                    .entry(channel.id)
                    .or_insert(ChannelInfo { topic: channel.topic, ..ChannelInfo::default() });
            }
            Item::Metadata(at, name, fields) if name == HEADER_NAME => self.info = Some(empty(header_of(&fields, at)?)),
            Item::Metadata(at, name, fields) if name == ENDING_NAME => {
                self.info()?.ending = Some(from_metadata(&fields, at)?);
            }
            Item::Chunk { .. } => self.info()?.chunks += 1,
            Item::Message(message) => self.message(&message)?,
            Item::Metadata(..) | Item::Schema(_) => {}
        }
        Ok(true)
    }

    /// Counts what is listed.
    fn list(&mut self, bytes: usize, at: u64) -> Result<(), Error> {
        self.listed += bytes;
        if self.listed > MAX_LISTED_BYTES {
            return Err(Error::damaged(at, "too many events, requests or channels"));
        }
        Ok(())
    }

    fn info(&mut self) -> Result<&mut Info, Error> {
        self.info.as_mut().ok_or(Error::NotARecording)
    }

    fn message(&mut self, message: &Message) -> Result<(), Error> {
        let t = message.time as f64 * 1e-9;
        if let Some(channel) = self.channels.get_mut(&message.channel) {
            channel.messages += 1;
            channel.bytes += message.data.len() as u64;
        }
        let topic = self.channels.get(&message.channel).map(|channel| channel.topic.clone()).unwrap_or_default();
        if topic == Channel::Tick.topic() {
            let tick = decode(message)?;
            self.ticks = Some((self.ticks.map_or(tick, |(first, _)| first), tick));
            self.info()?.cycles += 1;
        } else if topic == Channel::Events.topic() {
            self.list(message.data.len(), message.chunk_at)?;
            let RefereeEvent { kind, detail, .. } = decode(message)?;
            self.info()?.events.push(EventInfo { t, event: kind, detail });
        } else if topic == Channel::Requests.topic() {
            self.list(message.data.len(), message.chunk_at)?;
            let request: RequestRecord = decode(message)?;
            let info = self.info()?;
            info.requests.push(RequestInfo { t, request: request.describe(&info.header.tree) });
        }
        Ok(())
    }

    fn finish(self, damage: Option<String>) -> Result<Info, Error> {
        let info = self.info.ok_or(Error::NotARecording)?;
        let span = self.ticks.map_or((0, 0), |(first, last)| (first.instant, last.instant));
        let seconds = info.header.nanoseconds(span.1).saturating_sub(info.header.nanoseconds(span.0)) as f64 * 1e-9;
        Ok(Info {
            damage,
            seconds,
            fingerprint: self.ticks.filter(|_| info.header.monitor.is_none()).map_or_else(String::new, fingerprint),
            bytes: self.reader.position(),
            channels: self.channels.into_values().filter(|channel| channel.messages > 0).collect(),
            ..info
        })
    }
}

fn fingerprint((_, last): (Tick, Tick)) -> String {
    format!("{:016x}", last.fingerprint)
}

fn empty(header: Header) -> Info {
    Info {
        header,
        ending: None,
        cycles: 0,
        seconds: 0.0,
        fingerprint: String::new(),
        bytes: 0,
        chunks: 0,
        damage: None,
        channels: Vec::new(),
        events: Vec::new(),
        requests: Vec::new(),
    }
}
