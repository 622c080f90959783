//! Writer of a recording.

use std::collections::{BTreeMap, HashMap};
use std::io::{self, Write};

use postcard_schema::schema::owned::OwnedNamedType;

use crate::error::Error;
use crate::header::{Ending, Header};
use crate::layout::write_content;
use crate::mcap::{ChannelRecord, Compression, SchemaRecord, Writer};
use crate::message::{Channel, ENCODING, SCHEMA_KEY};
use crate::metadata::{ENDING_NAME, HEADER_NAME, of_ending, of_header};
use crate::ros::{CDR_LE, Event, Kind, Names, Quality, Topic};
use crate::topics::{Derived, Deriver};

/// Number of the first channel and schema of the topics: those of the recording have smaller ones.
const FIRST_TOPIC: u16 = 100;

/// Writer of a recording, with the topics that its header requests.
#[derive(Debug)]
pub(crate) struct RecordingWriter<W> {
    writer: Writer<W>,
    deriver: Option<Deriver>,
    topics: TopicTable,
}

/// Profile of MCAP: a bag of ROS 2.
pub(crate) const PROFILE: &str = "ros2";
/// Encoding of the definitions of messages.
const DEFINITION: &str = "ros2msg";
/// Key of the quality of service in the metadata of a channel.
const QUALITY_KEY: &str = "offered_qos_profiles";

/// Numbers of the channels and of the schemas of topics.
#[derive(Debug, Default)]
pub(crate) struct TopicTable {
    channels: HashMap<String, u16>,
    /// Number of the schema of each type of message, by its name.
    schemas: HashMap<String, u16>,
    /// Schemas and channels to declare before the next chunk.
    undeclared: (Vec<SchemaRecord>, Vec<ChannelRecord>),
}

impl TopicTable {
    /// Adds a message to a file. Its topic is declared before the next chunk, if it is new.
    pub(crate) fn message<W: Write>(&mut self, writer: &mut Writer<W>, topic: &Topic, time: u64, message: &Derived) {
        let channel = self.channel(topic);
        writer.message(message.compression, channel, time, |out| {
            out.extend(CDR_LE);
            out.extend_from_slice(&message.data);
        });
    }

    fn channel(&mut self, topic: &Topic) -> u16 {
        if let Some(id) = self.channels.get(&topic.name) {
            return *id;
        }
        let next = FIRST_TOPIC + self.schemas.len() as u16;
        let schema = *self.schemas.entry(topic.kind.full()).or_insert_with(|| {
            self.undeclared.0.push(schema_record(next, topic.kind));
            next
        });
        let id = FIRST_TOPIC + self.channels.len() as u16;
        let metadata = BTreeMap::from([(QUALITY_KEY.to_owned(), topic.quality.profile())]);
        let (topic, encoding) = (topic.name.clone(), ENCODING.to_owned());
        self.channels.insert(topic.clone(), id);
        self.undeclared.1.push(ChannelRecord { id, schema, topic, encoding, metadata });
        id
    }

    /// Declares new topics, and writes the messages so far.
    pub(crate) fn flush<W: Write>(&mut self, writer: &mut Writer<W>) -> io::Result<()> {
        let (schemas, channels) = std::mem::take(&mut self.undeclared);
        if !channels.is_empty() {
            writer.declare(schemas, channels)?;
        }
        writer.flush()
    }
}

fn schema_record(id: u16, kind: Kind) -> SchemaRecord {
    SchemaRecord { id, name: kind.full(), encoding: DEFINITION.to_owned(), data: kind.definition().into_bytes() }
}

/// Returns the schema and the channels of a recording. A recording of a monitor has no channels for sensor values and commands.
fn channels(header: &Header) -> (SchemaRecord, Vec<ChannelRecord>) {
    let messages = header.messages();
    let schema = |channel: Channel| match channel {
        Channel::Sensors => messages.map(|messages| messages.sensors.clone()),
        Channel::Command => messages.map(|messages| messages.command.clone()),
        _ => channel.schema().map(OwnedNamedType::from),
    };
    let event = schema_record(1, Kind::of::<Event>());
    let declare = |channel: Channel| {
        let text = serde_json::to_string(&schema(channel)?).unwrap_or_default();
        let quality = (QUALITY_KEY.to_owned(), Quality::Reliable.profile());
        let metadata = BTreeMap::from([quality, (SCHEMA_KEY.to_owned(), text)]);
        let (topic, encoding) = (channel.topic().to_owned(), ENCODING.to_owned());
        Some(ChannelRecord { id: channel.id(), schema: event.id, topic, encoding, metadata })
    };
    let channels = Channel::ALL.into_iter().filter_map(declare).collect();
    (event, channels)
}

impl<W: Write> RecordingWriter<W> {
    /// Begins a file: header, schemas and channels, and the header again, compressed.
    pub(crate) fn new(target: W, header: &Header) -> io::Result<Self> {
        let (schema, channels) = channels(header);
        let fields = of_header(header).map_err(io_error)?;
        let invalid = |invalid| io::Error::new(io::ErrorKind::InvalidInput, invalid);
        let names = Names::new(&header.tree, "").map_err(invalid)?;
        let deriver = Deriver::new(header, names).map_err(invalid)?;
        let mut writer = Writer::new(target, PROFILE)?;
        writer.metadata(HEADER_NAME, &fields)?;
        writer.declare(vec![schema], channels)?;
        writer.compressed_metadata(HEADER_NAME, &fields)?;
        Ok(Self { writer, deriver, topics: TopicTable::default() })
    }

    /// Adds a message, and the messages of topics that are derived from it.
    pub(crate) fn message(&mut self, channel: Channel, compression: Compression, time: u64, data: &[u8]) {
        self.writer.message(compression, channel.id(), time, |out| write_content(out, data));
        let Some(deriver) = &mut self.deriver else { return };
        for derived in deriver.derive(channel, time, data) {
            self.topics.message(&mut self.writer, deriver.topic(derived.topic), time, &derived);
        }
    }

    /// Writes the messages so far.
    pub(crate) fn flush(&mut self) -> io::Result<()> {
        self.topics.flush(&mut self.writer)
    }

    /// Drops the messages that are not written yet.
    pub(crate) fn discard(&mut self) {
        self.topics.undeclared = Default::default();
        self.writer.discard();
    }

    /// Writes the ending, twice, and the summary.
    pub(crate) fn close(&mut self, ending: &Ending) -> io::Result<()> {
        let fields = of_ending(ending).map_err(io_error)?;
        self.flush()?;
        self.writer.metadata(ENDING_NAME, &fields)?;
        self.writer.metadata(ENDING_NAME, &fields)?;
        self.writer.close()
    }

    /// Returns the length of the file so far, bytes.
    pub(crate) const fn length(&self) -> u64 {
        self.writer.length()
    }

    /// Returns the number of bytes that wait for [`flush`](Self::flush).
    pub(crate) fn pending(&self) -> usize {
        self.writer.pending()
    }

    /// Returns the target.
    pub(crate) const fn target_mut(&mut self) -> &mut W {
        self.writer.target_mut()
    }
}

fn io_error(error: Error) -> io::Error {
    match error {
        Error::Io(error) => error,
        other => io::Error::other(other),
    }
}
