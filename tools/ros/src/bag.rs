//! Recordings as bags of ROS 2.

use std::collections::{BTreeMap, BTreeSet};
use std::io::{Read, Write};

use bica::Format;
use bica_link::Shown;
use bica_recording::mcap::{ChannelRecord, Compression, SchemaRecord, Writer};
use bica_recording::repair::Copied;
use bica_recording::{Error, NameTable, RecordedCycle, Recording, Scenery, StoredBlob};
use bica_wire::model::{Description, Invalid};

use crate::message::Encoded;
use crate::names::Names;
use crate::topics::{Sent, Topics};

/// Size above which messages that wait are written, bytes.
const CHUNK: usize = 1 << 20;
/// Header of a message in CDR with little-endian numbers.
const CDR_LE: [u8; 4] = [0, 1, 0, 0];

/// Writes a recording as a bag: an MCAP file of the profile `ros2`, which `ros2 bag`, `rosbags`, Foxglove and `PlotJuggler` read. It
/// has the topics that a node has, with the robot's time; a recording has outputs in some cycles only.
///
/// # Errors
/// If the recording cannot be read, or the bag cannot be written.
pub fn bag<R: Read, W: Write>(source: R, target: W) -> Result<Copied, Error> {
    let mut recording = Recording::new(source)?;
    let header = recording.header().clone();
    let invalid = |invalid: Invalid| Error::Names(invalid.what);
    let names = Names::new(&header.tree, "").map_err(invalid)?;
    let topics = Topics::new(&header.tree, names, true);
    topics.check(&mut NameTable::new("ROS topic")).map_err(invalid)?;
    let mut bag = Bag::begin(topics, target)?;
    let items: Vec<_> = header.scenery.iter().map(shown).collect();
    let mut cycles = 0;
    while let Some(cycle) = recording.next_cycle()? {
        let time = header.nanoseconds(cycle.tick.instant);
        if cycles == 0 {
            let messages = bag.topics.fixed_frames().into_iter().chain(bag.topics.scenery(&items)).collect();
            bag.write(time, messages)?;
        }
        cycles += 1;
        let states = bag.topics.states(&header.tree, states(&header.tree, &cycle));
        bag.write(time, states)?;
        let mut frames = Vec::new();
        for blob in cycle.blobs.iter().map(StoredBlob::blob).filter(|blob| blob.format != Format::Points) {
            let camera = bag.topics.cameras().next_frame(blob.frame, &mut frames);
            let image = bag.topics.image(time, &camera, blob.format, blob.bytes);
            bag.write(time, image)?;
        }
        for value in cycle.information.iter().flat_map(|record| &record.values) {
            if let Some(json) = header.decode(value) {
                let messages = bag.topics.value(time, (value.component.into(), value.index.into()), &json);
                bag.write(time, messages)?;
            }
        }
        for line in &cycle.log {
            let messages = bag.topics.log(time, line.level, &line.text);
            bag.write(time, messages)?;
        }
        for event in &cycle.events {
            let messages = bag.topics.log(time, 2, format!("{} {}", event.kind, event.detail).trim_end());
            bag.write(time, messages)?;
        }
    }
    bag.writer.close()?;
    let damage = recording.ending().is_none().then(|| "the end of the recording is missing".to_owned());
    Ok(Copied { cycles, bytes: bag.writer.length(), chunks: bag.chunks, damage: damage.into_iter().collect() })
}

fn shown(item: &Scenery) -> Shown {
    let Scenery { name, shape, frame, colour, value, .. } = item.clone();
    let colour = colour.map(|[red, green, blue]| format!("#{red:02x}{green:02x}{blue:02x}"));
    Shown { name, shape, frame, child: None, value, colour, line_width: None }
}

fn states(tree: &Description, cycle: &RecordedCycle) -> Vec<String> {
    let state = |index| {
        let name = tree.state(index, cycle.tree.state(index)).unwrap_or("active");
        if cycle.tree.is_active(index) { name } else { "latent" }.to_owned()
    };
    (0..tree.components.len()).map(state).collect()
}

struct Bag<W> {
    topics: Topics,
    writer: Writer<W>,
    schemas: BTreeMap<String, u16>,
    declared: BTreeSet<usize>,
    chunks: u64,
}

impl<W: Write> Bag<W> {
    fn begin(topics: Topics, target: W) -> Result<Self, Error> {
        let (writer, schemas, declared) = (Writer::new(target, "ros2")?, BTreeMap::new(), BTreeSet::new());
        Ok(Self { topics, writer, schemas, declared, chunks: 0 })
    }

    fn write(&mut self, time: u64, messages: Vec<Sent>) -> Result<(), Error> {
        for (topic, Encoded(data)) in messages {
            if self.declared.insert(topic) {
                self.declare(topic)?;
            }
            self.writer.message(Compression::Lz4, topic as u16, time, |out| {
                out.extend_from_slice(&CDR_LE);
                out.extend_from_slice(&data);
            });
        }
        if self.writer.pending() > CHUNK {
            self.writer.flush()?;
            self.chunks += 1;
        }
        Ok(())
    }

    /// Writes the type of a topic before its first message.
    fn declare(&mut self, topic: usize) -> Result<(), Error> {
        let declared = &self.topics.all()[topic];
        let name = format!("{}/msg/{}", declared.kind.package, declared.kind.name);
        let next = self.schemas.len() as u16 + 1;
        let schema = *self.schemas.entry(name.clone()).or_insert(next);
        let data = declared.kind.definition().into_bytes();
        let record = (schema == next).then(|| SchemaRecord { id: schema, name, encoding: "ros2msg".to_owned(), data });
        let topic_name = declared.name.clone();
        let metadata = BTreeMap::from([("offered_qos_profiles".to_owned(), declared.quality.profile())]);
        let channel =
            ChannelRecord { id: topic as u16, schema, topic: topic_name, encoding: "cdr".to_owned(), metadata };
        self.writer.declare(record.into_iter().collect(), vec![channel])?;
        Ok(())
    }
}
