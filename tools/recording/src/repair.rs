//! Mending and cutting of files.

use std::io::{Read, Write};

use crate::error::Error;
use crate::header::{ENDING_NAME, Ending, HEADER_NAME, Header, from_metadata, header_of, to_metadata};
use crate::mcap::{Item, Message, Reader, Writer};
use crate::message::{Channel, Tick};
use crate::recorder::{begin, compression};
use crate::recording::decode;

/// What a new file contains.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Copied {
    /// Number of cycles.
    pub cycles: u64,
    /// Length of the new file, bytes.
    pub bytes: u64,
    /// Number of chunks of the old file that were read.
    pub chunks: u64,
    /// What was wrong with the old file; empty if it is complete.
    pub damage: Vec<String>,
}

/// Copies all complete chunks of a recording to a new file. A cut or damaged end is left out, a chunk with a wrong checksum
/// is skipped.
///
/// # Errors
/// If the source cannot be read, has no header, or the target cannot be written.
pub fn recover(source: impl Read, target: impl Write) -> Result<Copied, Error> {
    copy(source, target, |_| true, true)
}

/// Copies the cycles of a span of time to a new file; `from` and `until` are in ns since the start of the run's clock.
///
/// # Errors
/// As [`recover`], and if the source is damaged.
pub fn trim(source: impl Read, target: impl Write, from: u64, until: u64) -> Result<Copied, Error> {
    copy(source, target, |time| (from..=until).contains(&time), false)
}

/// Copies the messages for whose time `keeps` is true.
fn copy(source: impl Read, target: impl Write, keeps: impl Fn(u64) -> bool, tolerant: bool) -> Result<Copied, Error> {
    let mut reader = Reader::new(source)?;
    let header = read_header(&mut reader)?;
    let mut copy = Copy { writer: begin(target, &header)?, copied: Copied::default(), ending: None, last: Vec::new() };
    loop {
        let position = reader.position();
        match reader.next_item() {
            Ok(Item::End) => break,
            Ok(item) => copy.item(item, &keeps)?,
            Err(error @ (Error::Damaged { .. } | Error::CutOff { .. })) if tolerant => {
                let is_cut = matches!(error, Error::CutOff { .. });
                copy.copied.damage.push(error.to_string());
                if is_cut || reader.position() == position {
                    break;
                }
            }
            Err(error) => return Err(error),
        }
    }
    copy.finish()
}

fn read_header<R: Read>(reader: &mut Reader<R>) -> Result<Header, Error> {
    loop {
        match reader.next_item()? {
            Item::Metadata(at, name, fields) if name == HEADER_NAME => return header_of(&fields, at),
            Item::Schema(_) | Item::Channel(_) | Item::Metadata(..) => {}
            Item::Chunk { .. } | Item::Message(_) | Item::End => return Err(Error::NotARecording),
        }
    }
}

struct Copy<W> {
    writer: Writer<W>,
    copied: Copied,
    ending: Option<Ending>,
    /// The newest message of each channel that holds only changes, as long as it was not copied.
    last: Vec<(Channel, Message)>,
}

impl<W: Write> Copy<W> {
    fn item(&mut self, item: Item, keeps: &impl Fn(u64) -> bool) -> Result<(), Error> {
        match item {
            Item::Message(message) => self.message(message, keeps)?,
            Item::Chunk { .. } => {
                self.copied.chunks += 1;
                self.writer.flush()?;
            }
            Item::Metadata(at, name, fields) if name == ENDING_NAME => self.ending = Some(from_metadata(&fields, at)?),
            _ => {}
        }
        Ok(())
    }

    fn message(&mut self, message: Message, keeps: &impl Fn(u64) -> bool) -> Result<(), Error> {
        let Some(channel) = Channel::of_id(message.channel) else { return Ok(()) };
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
                self.write(of, message.time, &change.data);
            }
            decode::<Tick>(&message)?;
            self.copied.cycles += 1;
        }
        self.write(channel, message.time, &message.data);
        Ok(())
    }

    fn write(&mut self, channel: Channel, time: u64, data: &[u8]) {
        self.writer.message(compression(channel), channel.id(), time, |out| out.extend_from_slice(data));
    }

    fn finish(mut self) -> Result<Copied, Error> {
        self.writer.flush()?;
        let before = self.ending.unwrap_or_default();
        let reason = if self.copied.damage.is_empty() { before.reason } else { self.copied.damage.join("; ") };
        let ending = Ending { cycles: self.copied.cycles, reason, ..before };
        self.writer.metadata(ENDING_NAME, &to_metadata(&ending)?)?;
        self.writer.close()?;
        Ok(Copied { bytes: self.writer.length(), ..self.copied })
    }
}
