//! Export for viewers: an MCAP file whose messages are Protocol Buffers in the schemas of Foxglove, and JSON for information, which
//! Foxglove, Lichtblick and Rerun show without knowledge of this program.

mod information;
mod numbers;
mod protobuf;

use std::collections::BTreeMap;
use std::io::{Read, Write};

use bica::{Blob, Format};

use crate::blob::StoredBlob;
use crate::error::Error;
use bica_wire::model::Description;

use crate::header::Header;
use crate::information::InformationRecord;
use crate::mcap::{ChannelRecord, Compression, SchemaRecord, Writer};
use crate::message::{Costs, TreeRecord};
use crate::recording::{RecordedCycle, Recording};
use crate::repair::Copied;
use information::InformationTopic;
use numbers::NumbersTopic;
use protobuf::{Field, Kind, Protobuf, descriptor_set};

/// Topic of an export.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Topic {
    Camera,
    Log,
    Tree,
    Costs,
}

impl Topic {
    const ALL: [Self; 4] = [Self::Camera, Self::Log, Self::Tree, Self::Costs];

    /// Returns topic and name of the schema.
    const fn names(self) -> (&'static str, &'static str) {
        match self {
            Self::Camera => ("/camera", "foxglove.RawImage"),
            Self::Log => ("/log", "foxglove.Log"),
            Self::Tree => ("/tree", "bica.Tree"),
            Self::Costs => ("/costs", "bica.Costs"),
        }
    }

    const fn id(self) -> u16 {
        self as u16 + 1
    }

    /// Returns the fields of the messages.
    fn fields(self, tree: &Description) -> Vec<Field> {
        let numbered = |names: Vec<String>, kind| {
            names.into_iter().zip(1..).map(|(name, number)| Field { name, number, kind }).collect()
        };
        let fixed = |fields: &[(&str, u32, Kind)]| {
            fields.iter().map(|&(name, number, kind)| Field { name: name.to_owned(), number, kind }).collect()
        };
        let components = || tree.components.iter().map(|component| identifier(&component.name)).collect();
        match self {
            Self::Camera => fixed(&[
                ("timestamp", 1, Kind::Timestamp),
                ("width", 2, Kind::Fixed32),
                ("height", 3, Kind::Fixed32),
                ("encoding", 4, Kind::Text),
                ("step", 5, Kind::Fixed32),
                ("data", 6, Kind::Bytes),
                ("frame_id", 7, Kind::Text),
            ]),
            Self::Log => fixed(&[
                ("timestamp", 1, Kind::Timestamp),
                ("level", 2, Kind::LogLevel),
                ("message", 3, Kind::Text),
                ("name", 4, Kind::Text),
                ("file", 5, Kind::Text),
                ("line", 6, Kind::Fixed32),
            ]),
            Self::Tree => numbered(components(), Kind::Int32),
            Self::Costs => numbered(components(), Kind::Float),
        }
    }
}

/// Returns a name that Protocol Buffers accept: generic components have brackets in theirs.
fn identifier(name: &str) -> String {
    name.chars().map(|letter| if letter.is_ascii_alphanumeric() { letter } else { '_' }).collect()
}

/// Writes a recording in standard schemas: images (`foxglove.RawImage`), events, requests, decisions and log lines
/// (`foxglove.Log`), one message with named numbers for each field of sensor values and command, for tree and costs, and JSON for
/// information. A cut or damaged file is exported up to there.
///
/// # Errors
/// If the source is no recording or the target cannot be written.
pub fn export(source: impl Read, target: impl Write) -> Result<Copied, Error> {
    let mut recording = Recording::new(source)?;
    let numbers = numbers::topics(recording.header(), Topic::ALL.len() as u16 + 1);
    let topics = information::topics(recording.header(), (Topic::ALL.len() + numbers.len()) as u16 + 1);
    let mut export = Export {
        writer: begin(target, &recording.header().tree, &numbers, &topics)?,
        header: recording.header().clone(),
        numbers,
        topics,
        last: TreeRecord::default(),
        time: 0,
    };
    let mut copied = Copied::default();
    loop {
        match recording.next_cycle() {
            Ok(Some(cycle)) => {
                export.time = recording.header().nanoseconds(cycle.tick.instant);
                export.cycle(&cycle, recording.blob_places().first().map_or(export.time, |place| place.time))?;
                copied.cycles += 1;
            }
            Ok(None) => break,
            Err(error @ (Error::CutOff { .. } | Error::Damaged { .. })) => {
                copied.damage.push(error.to_string());
                break;
            }
            Err(error) => return Err(error),
        }
    }
    export.words(recording.rest());
    export.writer.close()?;
    Ok(Copied { bytes: export.writer.length(), ..copied })
}

fn begin<W: Write>(
    target: W,
    tree: &Description,
    numbers: &[NumbersTopic],
    topics: &[InformationTopic],
) -> Result<Writer<W>, Error> {
    let mut schemas = BTreeMap::new();
    for topic in Topic::ALL {
        let (_, name) = topic.names();
        let id = schemas.len() as u16 + 1;
        schemas.entry(name).or_insert_with(|| SchemaRecord {
            id,
            name: name.to_owned(),
            encoding: "protobuf".to_owned(),
            data: descriptor_set(name, &topic.fields(tree)),
        });
    }
    let channel = |topic: Topic| {
        let (name, schema) = topic.names();
        let encoding = "protobuf".to_owned();
        ChannelRecord { id: topic.id(), schema: schemas[schema].id, topic: name.to_owned(), encoding }
    };
    let mut channels = Topic::ALL.map(channel).to_vec();
    let first = schemas.len() as u16 + 1;
    let (named, of_numbers): (Vec<_>, Vec<_>) = (first..).zip(numbers).map(|(id, topic)| topic.declare(id)).unzip();
    channels.extend(of_numbers);
    let json = SchemaRecord { id: first + named.len() as u16, ..information::schema() };
    channels.extend(topics.iter().map(|topic| topic.channel(json.id)));
    let mut schemas: Vec<_> = schemas.into_values().collect();
    schemas.sort_by_key(|schema| schema.id);
    schemas.extend(named);
    schemas.push(json);
    let mut writer = Writer::new(target, "")?;
    writer.declare(schemas, channels)?;
    Ok(writer)
}

/// Size of a chunk, bytes.
const CHUNK_BYTES: usize = 4 << 20;

struct Export<W> {
    writer: Writer<W>,
    header: Header,
    numbers: Vec<NumbersTopic>,
    topics: Vec<InformationTopic>,
    last: TreeRecord,
    /// Time of the cycle, ns.
    time: u64,
}

impl<W: Write> Export<W> {
    /// Writes a cycle, and its images with a time, ns.
    fn cycle(&mut self, cycle: &RecordedCycle, image_time: u64) -> Result<(), Error> {
        for request in &cycle.requests {
            let text = request.describe(&self.header.tree);
            self.log(2, "operator", &text);
        }
        cycle.blobs.iter().for_each(|blob| self.image(blob, image_time));
        for (id, message) in numbers::messages(&self.header, &self.numbers, cycle) {
            self.writer.message(Compression::Lz4, id, self.time, |out| out.extend_from_slice(&message.0));
        }
        if cycle.tree != self.last {
            self.tree(&cycle.tree);
            self.last.clone_from(&cycle.tree);
        }
        if let Some(information) = &cycle.information {
            self.information(information);
        }
        self.words(cycle);
        if self.writer.pending() >= CHUNK_BYTES {
            self.writer.flush()?;
        }
        Ok(())
    }

    /// Writes what a recording holds for people.
    fn words(&mut self, cycle: &RecordedCycle) {
        for event in &cycle.events {
            self.log(2, "event", format!("{} {}", event.kind, event.detail).trim_end());
        }
        for line in &cycle.log {
            self.log(line.level, "program", &line.text);
        }
        if let Some(costs) = &cycle.costs {
            self.costs(costs);
        }
    }

    fn message(&mut self, topic: Topic, message: &Protobuf) {
        let compression = if topic == Topic::Camera { Compression::None } else { Compression::Lz4 };
        self.writer.message(compression, topic.id(), self.time, |out| out.extend_from_slice(&message.0));
    }

    fn information(&mut self, information: &InformationRecord) {
        for value in &information.values {
            let topic = self.topics.iter().find(|topic| topic.is_of(value));
            let Some((id, json)) = topic.and_then(|topic| Some((topic.id, topic.json(value)?))) else { continue };
            self.writer.message(Compression::Lz4, id, self.time, |out| out.extend_from_slice(json.as_bytes()));
        }
    }

    /// Writes large data that is an image.
    fn image(&mut self, stored: &StoredBlob, time: u64) {
        let Blob { bytes, format, frame } = stored.blob();
        let (encoding, pixel, width, height) = match format {
            Format::Yuyv { width, height } => ("yuyv", 2, width, height),
            Format::Gray8 { width, height } => ("mono8", 1, width, height),
            Format::Rgb8 { width, height } => ("rgb8", 3, width, height),
            _ => return,
        };
        let mut message = Protobuf::default();
        message.timestamp(1, time).fixed32(2, width.into()).fixed32(3, height.into());
        message.text(4, encoding).fixed32(5, pixel * u32::from(width)).bytes(6, bytes).text(7, frame);
        self.message(Topic::Camera, &message);
    }

    fn log(&mut self, level: u8, name: &str, text: &str) {
        let mut message = Protobuf::default();
        message.timestamp(1, self.time).int(2, level.into()).text(3, text).text(4, name);
        self.message(Topic::Log, &message);
    }

    /// Writes the state of each component, 0 without a state machine, -1 for a latent one; and each change as text.
    fn tree(&mut self, tree: &TreeRecord) {
        let mut message = Protobuf::default();
        for index in 0..self.header.tree.components.len() {
            let value = if tree.is_active(index) { tree.state(index).unwrap_or(0) as i64 } else { -1 };
            message.int(index as u32 + 1, value);
            let before = (self.last.is_active(index), self.last.state(index));
            if before == (tree.is_active(index), tree.state(index)) {
                continue;
            }
            let component = self.header.tree.components[index].name.clone();
            let state = self.header.tree.state(index, tree.state(index)).unwrap_or("active");
            let text =
                if tree.is_active(index) { format!("{component}: {state}") } else { format!("{component}: latent") };
            self.log(2, &component, &text);
        }
        self.message(Topic::Tree, &message);
    }

    /// Writes the time of each component, µs.
    fn costs(&mut self, costs: &Costs) {
        let mut message = Protobuf::default();
        for (component, number) in costs.components.iter().zip(1..) {
            message.float(number, component.ns as f32 * 1e-3);
        }
        self.message(Topic::Costs, &message);
    }
}
