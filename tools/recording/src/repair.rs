//! Mending and cutting of files.

use std::collections::HashMap;
use std::io::{Read, Seek, SeekFrom, Write};

use crate::blob::BlobRecord;
use crate::contents::{Contents, Part};
use crate::error::Error;
use crate::header::{Ending, Header, Topics};
use crate::layout::Layout;
use crate::mcap::{Compression, Item, Message, Reader, find_intact};
use crate::message::{Channel, Tick};
use crate::metadata::{ENDING_NAME, HEADER_NAME, ending_of, header_of};
use crate::recording::decode;
use crate::writer::RecordingWriter;

/// Contents of a new file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Copied {
    /// Number of cycles.
    pub cycles: u64,
    /// Length of the new file, bytes.
    pub bytes: u64,
    /// Number of chunks of the old file that were read.
    pub chunks: u64,
    /// Damage of the old file; empty if it is complete.
    pub damage: Vec<String>,
}

/// Size of the beginning of a damaged file that is searched for a copy of the header, bytes.
const HEADER_WITHIN: u64 = 16 << 20;

/// Copies all complete chunks of a recording to a new file. Damaged chunks are omitted; if the header is damaged, its copy is
/// used.
///
/// # Errors
/// If the source cannot be read, has no intact header or no intact cycle, or the target cannot be written.
pub fn recover(mut source: impl Read + Seek, target: impl Write, topics: Option<Topics>) -> Result<Copied, Error> {
    let mut damage = Vec::new();
    let header = match Contents::new(&mut source) {
        Ok(contents) => contents.header,
        Err(error @ (Error::Io(_) | Error::Format(_) | Error::Former(_) | Error::NotARecording)) => return Err(error),
        Err(error) => {
            damage.push(error.to_string());
            header_copy(&mut source)?.ok_or(if matches!(error, Error::NotMcap) { error } else { Error::NoHeader })?
        }
    };
    let mut copy = Copy::new(target, header, topics)?;
    copy.copied.damage = damage;
    source.rewind()?;
    let mut reader = match Reader::new(&mut source) {
        Err(Error::Io(error)) => return Err(error.into()),
        Err(_) => resume(&mut source, 0)?,
        Ok(reader) => reader,
    };
    loop {
        let position = reader.position();
        let error = match reader.next_item() {
            Ok(Item::End) => break,
            Ok(item) => match copy.item(item) {
                Ok(()) => continue,
                Err(Error::Io(error)) => return Err(error.into()),
                Err(error) => {
                    copy.damage(&error);
                    continue;
                }
            },
            Err(Error::Io(error)) => return Err(error.into()),
            Err(error) => error,
        };
        copy.damage(&error);
        let is_useful = |item: &Item| match item {
            Item::Chunk { .. } => true,
            Item::Metadata(at, name, fields) => name == ENDING_NAME && ending_of(fields, *at).is_ok(),
            _ => false,
        };
        let Some(next) = find_intact(&mut source, position..u64::MAX, is_useful)? else { break };
        reader = resume(&mut source, next)?;
    }
    if copy.copied.cycles == 0 {
        return Err(Error::NoCycle(copy.copied.damage.join("; ")));
    }
    copy.finish()
}

fn resume<S: Read + Seek>(source: &mut S, at: u64) -> Result<Reader<&mut S>, Error> {
    source.seek(SeekFrom::Start(at))?;
    Ok(Reader::resume(source, at))
}

/// Returns the first intact header.
fn header_copy(source: &mut (impl Read + Seek)) -> Result<Option<Header>, Error> {
    let found = |item: &Item| match item {
        Item::Metadata(at, name, fields) if name == HEADER_NAME => header_of(fields, *at, Layout::Present).ok(),
        _ => None,
    };
    let at = find_intact(source, 0..HEADER_WITHIN, |item| found(item).is_some())?;
    at.map_or(Ok(None), |at| Ok(found(&resume(source, at)?.next_item()?)))
}

/// Copies the cycles of a span of time to a new file; `from` and `until` are in ns since the first cycle. `u64::MAX` is the end of the
/// recording.
///
/// # Errors
/// If the source cannot be read, is damaged, has no cycle in the span or ends before it, or the target cannot be written.
pub fn trim(
    mut source: impl Read + Seek,
    target: impl Write,
    from: u64,
    until: u64,
    topics: Option<Topics>,
) -> Result<Copied, Error> {
    let first = first_time(&mut source)?;
    source.rewind()?;
    let mut contents = Contents::new(source)?;
    let mut copy = Copy::new(target, contents.header.clone(), topics)?;
    let (from, last, mut end) = (first.saturating_add(from), first.saturating_add(until), first);
    loop {
        match contents.next()? {
            Part::End => break,
            Part::Chunk => copy.chunk()?,
            Part::Message(channel, message) => {
                end = end.max(if channel == Channel::Tick { message.time } else { 0 });
                copy.message(channel, message, |time| (from..=last).contains(&time))?;
            }
        }
    }
    if copy.copied.cycles == 0 || (until < u64::MAX && last > end.saturating_add(contents.header.period())) {
        return Err(Error::Span { end: end - first });
    }
    copy.ending = contents.ending;
    copy.finish()
}

/// Returns the time of the first cycle, ns since the start of the run's clock: large data of later cycles may precede it.
pub(crate) fn first_time(source: &mut impl Read) -> Result<u64, Error> {
    let mut contents = Contents::new(source)?;
    loop {
        match contents.next()? {
            Part::Message(Channel::Tick, message) => return Ok(message.time),
            Part::End => return Err(Error::NoCycle(String::new())),
            Part::Message(..) | Part::Chunk => {}
        }
    }
}

/// A new file with the cycles of others.
pub(crate) struct Copy<W> {
    writer: RecordingWriter<W>,
    pub(crate) copied: Copied,
    pub(crate) ending: Option<Ending>,
    /// Channels of a damaged file, by their numbers.
    channels: HashMap<u16, Channel>,
    /// The newest message of each channel that holds only changes, as long as it was not copied.
    last: Vec<(Channel, Message)>,
}

impl<W: Write> Copy<W> {
    /// Begins a copy; `topics` replaces the topics of its header.
    pub(crate) fn new(target: W, header: Header, topics: Option<Topics>) -> Result<Self, Error> {
        let header = Header { topics: topics.unwrap_or(header.topics), ..header };
        let (writer, copied) = (RecordingWriter::new(target, &header)?, Copied::default());
        Ok(Self { writer, copied, ending: None, channels: HashMap::new(), last: Vec::new() })
    }

    /// Copies a part of a damaged file. A channel whose record is damaged has the number that this program gives it.
    fn item(&mut self, item: Item) -> Result<(), Error> {
        match item {
            Item::Message(message) => {
                let channel = self.channels.get(&message.channel).copied();
                let channel = channel.or_else(|| Channel::of_id(message.channel));
                channel.map_or(Ok(()), |channel| self.message(channel, Layout::Present.content(message)?, |_| true))
            }
            Item::Chunk { .. } => self.chunk(),
            Item::Channel(channel) => {
                self.channels.extend(Layout::Present.channel(&channel));
                Ok(())
            }
            Item::Metadata(at, name, fields) if name == ENDING_NAME => {
                self.ending = Some(ending_of(&fields, at)?);
                Ok(())
            }
            Item::Metadata(at, name, fields) if name == HEADER_NAME => {
                header_of(&fields, at, Layout::Present).map(drop)
            }
            _ => Ok(()),
        }
    }

    /// Adds damage of the old file to the list.
    pub(crate) fn damage(&mut self, error: &Error) {
        let text = error.to_string();
        if !self.copied.damage.contains(&text) {
            self.copied.damage.push(text);
        }
    }

    /// Ends a chunk.
    pub(crate) fn chunk(&mut self) -> Result<(), Error> {
        self.copied.chunks += 1;
        Ok(self.writer.flush()?)
    }

    /// Copies a message if `keeps` returns true for its time.
    pub(crate) fn message(
        &mut self,
        channel: Channel,
        message: Message,
        keeps: impl Fn(u64) -> bool,
    ) -> Result<(), Error> {
        let is_change = matches!(channel, Channel::Tree | Channel::Holds);
        if is_change {
            self.last.retain(|(of, _)| *of != channel);
        }
        if !keeps(message.time) {
            if is_change {
                self.last.push((channel, message));
            }
            return Ok(());
        }
        if channel == Channel::Tick {
            // The first cycle needs the last changes before it.
            for (of, change) in std::mem::take(&mut self.last) {
                self.write(of, Compression::Lz4, message.time, &change.data);
            }
            decode::<Tick>(&message)?;
            self.copied.cycles += 1;
        }
        let compression = match channel {
            Channel::Blobs => decode::<BlobRecord<'_>>(&message)?.compression(),
            _ => Compression::Lz4,
        };
        self.write(channel, compression, message.time, &message.data);
        Ok(())
    }

    fn write(&mut self, channel: Channel, compression: Compression, time: u64, data: &[u8]) {
        self.writer.message(channel, compression, time, data);
    }

    /// Closes the file.
    pub(crate) fn finish(mut self) -> Result<Copied, Error> {
        self.writer.flush()?;
        let before = self.ending.unwrap_or_default();
        let reason = if self.copied.damage.is_empty() { before.reason } else { self.copied.damage.join("; ") };
        let ending = Ending { cycles: self.copied.cycles, reason, ..before };
        self.writer.close(&ending)?;
        Ok(Copied { bytes: self.writer.length(), ..self.copied })
    }
}
