//! Messages of a recording with their channels, wherever MCAP allows their records to be.

use std::collections::{BTreeMap, HashMap};
use std::io::Read;

use crate::error::Error;
use crate::header::{Ending, Header};
use crate::layout::Layout;
use crate::mcap::{Item, Message, Reader};
use crate::message::Channel;
use crate::metadata::{ENDING_NAME, HEADER_NAME, ending_of, header_of};

/// Part of a recording.
pub(crate) enum Part {
    /// A message.
    Message(Channel, Message),
    /// A complete chunk; its messages follow.
    Chunk,
    /// The end of a file that was closed.
    End,
}

/// Reader of the messages of a recording. Any damage is an error.
#[derive(Debug)]
pub(crate) struct Contents<R> {
    reader: Reader<R>,
    layout: Layout,
    pub(crate) header: Header,
    /// Channel for each channel number of the file.
    channels: HashMap<u16, Channel>,
    pub(crate) ending: Option<Ending>,
    cycles: u64,
}

impl<R: Read> Contents<R> {
    /// Reads the header, which precedes all messages.
    pub(crate) fn new(source: R) -> Result<Self, Error> {
        Self::of(source, Layout::Present)
    }

    /// As [`new`](Self::new), for a file with a layout. The header is converted to the present format.
    pub(crate) fn of(source: R, layout: Layout) -> Result<Self, Error> {
        let (mut reader, mut channels) = (Reader::new(source)?, HashMap::new());
        let header = loop {
            match reader.next_item()? {
                Item::Metadata(at, name, fields) if name == HEADER_NAME => break header_of(&fields, at, layout)?,
                Item::Channel(channel) => channels.extend(layout.channel(&channel)),
                Item::Schema(_) | Item::Metadata(..) => {}
                Item::Chunk { .. } | Item::Message(_) | Item::End => return Err(Error::NotARecording),
            }
        };
        Ok(Self { reader, layout, header, channels, ending: None, cycles: 0 })
    }

    /// Returns the number of bytes read so far.
    pub(crate) const fn position(&self) -> u64 {
        self.reader.position()
    }

    /// Returns the next part. [`Part::End`] is repeated.
    pub(crate) fn next(&mut self) -> Result<Part, Error> {
        loop {
            match self.reader.next_item()? {
                Item::Channel(channel) => self.channels.extend(self.layout.channel(&channel)),
                Item::Message(message) => {
                    let Some(channel) = self.channels.get(&message.channel) else { continue };
                    self.cycles += u64::from(*channel == Channel::Tick);
                    return Ok(Part::Message(*channel, self.layout.content(message)?));
                }
                Item::Metadata(at, name, fields) => self.metadata(at, &name, &fields)?,
                Item::Chunk { .. } => return Ok(Part::Chunk),
                Item::Schema(_) => {}
                Item::End => return self.end(),
            }
        }
    }

    /// Stores the ending. Copies of header and ending have to be equal.
    fn metadata(&mut self, at: u64, name: &str, fields: &BTreeMap<String, String>) -> Result<(), Error> {
        let is_equal = match name {
            HEADER_NAME => header_of(fields, at, self.layout)? == self.header,
            ENDING_NAME => {
                let ending = ending_of(fields, at)?;
                *self.ending.get_or_insert_with(|| ending.clone()) == ending
            }
            _ => true,
        };
        if is_equal { Ok(()) } else { Err(Error::damaged(at, format!("two records `{name}` differ"))) }
    }

    fn end(&self) -> Result<Part, Error> {
        match &self.ending {
            Some(ending) if ending.cycles != self.cycles => {
                let what = format!("the recording had {} cycles, the file has {}", ending.cycles, self.cycles);
                Err(Error::damaged(self.position(), what))
            }
            _ => Ok(Part::End),
        }
    }
}
