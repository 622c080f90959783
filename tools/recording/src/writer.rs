//! Writer of a recording.

use std::collections::{BTreeMap, HashMap};
use std::io::{self, Write};

use bica_wire::model::Description;
use postcard_schema::schema::owned::OwnedNamedType;

use crate::error::Error;
use crate::header::{Ending, Header};
use crate::mcap::{ChannelRecord, Compression, SchemaRecord, Writer};
use crate::message::{Channel, ENCODING};
use crate::metadata::{ENDING_NAME, HEADER_NAME, of_ending, of_header};
use crate::topics::{Derived, Deriver, Schema};

/// Number of the first channel and schema of the topics: those of the recording have smaller ones.
const FIRST_TOPIC: u16 = 100;

/// Writer of a recording, with the topics that its header requests.
#[derive(Debug)]
pub(crate) struct RecordingWriter<W> {
    writer: Writer<W>,
    header: Header,
    deriver: Option<Deriver>,
    topics: TopicTable,
}

/// Numbers of the channels and of the schemas of topics.
#[derive(Debug, Default)]
pub(crate) struct TopicTable {
    channels: HashMap<String, u16>,
    /// Of each robot, by its number.
    schemas: HashMap<(usize, Schema), u16>,
    /// What is declared before the next chunk.
    undeclared: (Vec<SchemaRecord>, Vec<ChannelRecord>),
}

impl TopicTable {
    /// Returns the channel of a topic; its schema is that of a robot with a number and a tree.
    pub(crate) fn channel(&mut self, topic: String, schema: (usize, Schema), tree: &Description) -> u16 {
        if let Some(id) = self.channels.get(&topic) {
            return *id;
        }
        let next = FIRST_TOPIC + self.schemas.len() as u16;
        let schema_id = *self.schemas.entry(schema).or_insert_with(|| {
            let (name, encoding, data) = schema.1.describe(tree);
            self.undeclared.0.push(SchemaRecord { id: next, name, encoding: encoding.to_owned(), data });
            next
        });
        let id = FIRST_TOPIC + self.channels.len() as u16;
        let (encoding, metadata) = (schema.1.encoding().to_owned(), BTreeMap::new());
        self.undeclared.1.push(ChannelRecord { id, schema: schema_id, topic: topic.clone(), encoding, metadata });
        self.channels.insert(topic, id);
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

/// Returns schemas and channels of a recording. What a monitor records has no messages of a robot.
fn channels(header: &Header) -> (Vec<SchemaRecord>, Vec<ChannelRecord>) {
    let messages = header.messages();
    let schema = |channel: Channel| match channel {
        Channel::Sensors => messages.map(|messages| messages.sensors.clone()),
        Channel::Command => messages.map(|messages| messages.command.clone()),
        _ => channel.schema().map(OwnedNamedType::from),
    };
    let declare = |channel: Channel| {
        let (id, schema) = (channel.id(), schema(channel)?);
        let data = serde_json::to_vec(&schema).unwrap_or_default();
        let record =
            SchemaRecord { id, name: format!("bica.{}", schema.name), encoding: "postcard-schema".to_owned(), data };
        let topic = channel.topic().to_owned();
        Some((
            record,
            ChannelRecord { id, schema: id, topic, encoding: ENCODING.to_owned(), metadata: BTreeMap::new() },
        ))
    };
    Channel::ALL.into_iter().filter_map(declare).unzip()
}

impl<W: Write> RecordingWriter<W> {
    /// Begins a file: header, schemas and channels, and the header again, compressed.
    pub(crate) fn new(target: W, header: &Header) -> io::Result<Self> {
        let (schemas, channels) = channels(header);
        let fields = of_header(header).map_err(io_error)?;
        let invalid = |invalid| io::Error::new(io::ErrorKind::InvalidInput, invalid);
        let deriver = Deriver::new(header).map_err(invalid)?;
        let mut writer = Writer::new(target, "bica")?;
        writer.metadata(HEADER_NAME, &fields)?;
        writer.declare(schemas, channels)?;
        writer.compressed_metadata(HEADER_NAME, &fields)?;
        Ok(Self { writer, header: header.clone(), deriver, topics: TopicTable::default() })
    }

    /// Adds a message, and what follows from it for the topics.
    pub(crate) fn message(&mut self, channel: Channel, compression: Compression, time: u64, data: &[u8]) {
        self.writer.message(compression, channel.id(), time, |out| out.extend_from_slice(data));
        let derived = self.deriver.as_mut().map(|deriver| deriver.derive(channel, time, data));
        for Derived { topic, schema, compression, data } in derived.into_iter().flatten() {
            let id = self.topics.channel(topic, (0, schema), &self.header.tree);
            self.writer.message(compression, id, time, |out| out.extend_from_slice(&data));
        }
    }

    /// Writes the messages so far.
    pub(crate) fn flush(&mut self) -> io::Result<()> {
        self.topics.flush(&mut self.writer)
    }

    /// Forgets the messages that are not written yet.
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

    /// Length of the file so far, bytes.
    pub(crate) const fn length(&self) -> u64 {
        self.writer.length()
    }

    /// Number of bytes that wait for [`flush`](Self::flush).
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
