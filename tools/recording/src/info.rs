//! Contents of a recording.

use std::collections::BTreeMap;
use std::io::Read;

use bica::JobEnd;
use bica_link::JobEvent;
use serde::Serialize;

use crate::contents::{Contents, Part};
use crate::error::Error;
use crate::header::{Ending, Header};
use crate::mcap::Message;
use crate::message::{Channel, RunEvent, Tick};
use crate::recording::decode;
use crate::request::{RequestRecord, work_name};

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
    /// Damage of the file; none if it is complete.
    pub damage: Option<String>,
    /// Channels with messages.
    pub channels: Vec<ChannelInfo>,
    /// Events of the run.
    pub events: Vec<EventInfo>,
    /// Requests of operators.
    pub requests: Vec<RequestInfo>,
    /// Jobs beside the loop, by component and function.
    pub jobs: BTreeMap<String, JobCounts>,
}

/// Numbers of jobs of one component.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct JobCounts {
    /// Begun.
    pub begun: u64,
    /// Ended with a result, at the latest in the first cycle at or after the due time.
    pub on_time: u64,
    /// Ended with a result in a later cycle.
    pub late: u64,
    /// Ended without a result.
    pub failed: u64,
}

impl JobCounts {
    fn add(&mut self, event: JobEvent) {
        *match event {
            JobEvent::Begun(_) => &mut self.begun,
            JobEvent::Ended(JobEnd::OnTime) => &mut self.on_time,
            JobEvent::Ended(JobEnd::Late) => &mut self.late,
            JobEvent::Ended(JobEnd::Failed) => &mut self.failed,
        } += 1;
    }
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

/// An event of the run.
#[derive(Clone, Debug, Serialize)]
pub struct EventInfo {
    /// Time since the first cycle, s.
    pub t: f64,
    /// Kind.
    pub event: String,
    /// Details.
    pub detail: String,
}

/// A request of an operator.
#[derive(Clone, Debug, Serialize)]
pub struct RequestInfo {
    /// Time since the first cycle, s.
    pub t: f64,
    /// The request, as text.
    pub request: String,
}

/// Maximum size of events and requests, bytes. A game has some kilobytes, a damaged file may have any number.
const MAX_LISTED_BYTES: usize = 64 << 20;

impl Info {
    /// Reads a whole recording without decoding its images. A cut or damaged file is described up to the damage.
    ///
    /// # Errors
    /// If the source cannot be read or is no recording.
    pub fn read(source: impl Read) -> Result<Self, Error> {
        let mut contents = Contents::new(source)?;
        let mut reading =
            Reading { info: empty(contents.header.clone()), ticks: None, times: Default::default(), listed: 0 };
        reading.info.damage = loop {
            let step = contents.next().and_then(|part| reading.part(part));
            match step {
                Ok(true) => {}
                Ok(false) => break None,
                Err(Error::Io(error)) => return Err(error.into()),
                Err(error) => break Some(error.to_string()),
            }
        };
        (reading.info.ending, reading.info.bytes) = (contents.ending.take(), contents.position());
        Ok(reading.finish())
    }
}

struct Reading {
    info: Info,
    /// First and last tick.
    ticks: Option<(Tick, Tick)>,
    /// Times of the events and of the requests, ns.
    times: [Vec<u64>; 2],
    /// Number of bytes of events and requests.
    listed: usize,
}

impl Reading {
    /// Processes a part; returns whether there may be more.
    fn part(&mut self, part: Part) -> Result<bool, Error> {
        match part {
            Part::End => return Ok(false),
            Part::Chunk => self.info.chunks += 1,
            Part::Message(channel, message) => self.message(channel, &message)?,
        }
        Ok(true)
    }

    fn message(&mut self, channel: Channel, message: &Message) -> Result<(), Error> {
        let (t, info) = (0.0, &mut self.info);
        let counts = &mut info.channels[usize::from(channel.id()) - 1];
        counts.messages += 1;
        counts.bytes += message.data.len() as u64;
        if matches!(channel, Channel::Events | Channel::Requests) {
            self.listed += message.data.len();
            if self.listed > MAX_LISTED_BYTES {
                return Err(Error::damaged(message.chunk_at, "too many events or requests"));
            }
        }
        match channel {
            Channel::Tick => {
                let tick = decode(message)?;
                self.ticks = Some((self.ticks.map_or(tick, |(first, _)| first), tick));
                info.cycles += 1;
            }
            Channel::Events => {
                let RunEvent { kind, detail, .. } = decode(message)?;
                if let Some((name, event)) = JobEvent::read(&kind, &detail) {
                    info.jobs.entry(name.to_owned()).or_default().add(event);
                }
                self.times[0].push(message.time);
                info.events.push(EventInfo { t, event: kind, detail });
            }
            Channel::Requests => {
                let request: RequestRecord = decode(message)?;
                if let RequestRecord::Ended { component, end } = request {
                    let name = work_name(&info.header.tree, component);
                    info.jobs.entry(name).or_default().add(JobEvent::Ended(end));
                }
                self.times[1].push(message.time);
                info.requests.push(RequestInfo { t, request: request.describe(&info.header.tree) });
            }
            _ => {}
        }
        Ok(())
    }

    fn finish(self) -> Info {
        let mut info = self.info;
        let (first, last) = self.ticks.map_or((0, 0), |(first, last)| (first.instant, last.instant));
        info.seconds = info.header.seconds_since(first, last);
        let start = info.header.nanoseconds(first);
        let since = |time: u64| (i128::from(time) - i128::from(start)) as f64 / 1e9;
        info.events.iter_mut().zip(&self.times[0]).for_each(|(event, time)| event.t = since(*time));
        info.requests.iter_mut().zip(&self.times[1]).for_each(|(request, time)| request.t = since(*time));
        info.fingerprint = self.ticks.filter(|_| info.header.monitor.is_none()).map_or_else(String::new, fingerprint);
        info.channels.retain(|channel| channel.messages > 0);
        info
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
        channels: Channel::ALL
            .map(|channel| ChannelInfo { topic: channel.name().to_owned(), ..ChannelInfo::default() })
            .to_vec(),
        events: Vec::new(),
        requests: Vec::new(),
        jobs: BTreeMap::new(),
    }
}
