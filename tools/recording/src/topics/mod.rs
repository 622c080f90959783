//! Topics that other programs show: derived from the messages of a recording, and ignored when it is read.
//!
//! Their schemas are those of Foxglove, in Protocol Buffers. The crate `foxglove` (0.30, without default features) needs 98 others, among
//! them `prost`; the few messages that are written need a table of their fields and a writer of 70 lines.

mod cameras;
mod foxglove;
mod numbers;
mod outputs;
mod preview;
mod protobuf;
mod schema;
pub mod shape;

use std::collections::{BTreeMap, HashMap};

use bica::runner::Change;
use bica::{Format, Value};
use bica_link::decode_message;
use bica_wire::model::Invalid;

use crate::blob::BlobRecord;
use crate::header::{Header, Topics};
use crate::image_codec::ImageCoder;
use crate::information::InformationRecord;
use crate::mcap::Compression;
use crate::message::{Channel, Costs, LogLine, RunEvent, TreeRecord};
use crate::names::NameTable;
use crate::recording::{MAX_BLOBS, MAX_CYCLE_BYTES};
use crate::request::RequestRecord;
use crate::scenery::Scenery;
pub use cameras::Cameras;
use outputs::{Outputs, Seen};
pub use preview::{Jpeg, jpeg};
use preview::{Preview, is_image};
use protobuf::Protobuf;
pub(crate) use schema::Schema;

/// Shortest time from one preview of an image to the next, ns.
const PREVIEW_AFTER: u64 = 290_000_000;
/// Shortest time between two records of outputs that are shown, ns: a monitor may receive more.
const OUTPUTS_AFTER: u64 = 45_000_000;

/// Most large data of a frame that waits.
const MAX_WAITING: usize = 64;

/// Message of a topic.
#[derive(Debug)]
pub(crate) struct Derived {
    pub(crate) topic: String,
    pub(crate) schema: Schema,
    pub(crate) compression: Compression,
    pub(crate) data: Vec<u8>,
}

/// Returns a name as a part of a topic: viewers read a space as the end of a path.
pub(crate) fn path(name: &str) -> String {
    name.replace(char::is_whitespace, "_")
}

/// Large data that waits for its preview.
#[derive(Debug)]
struct Waiting {
    time: u64,
    /// A [`BlobRecord`] in postcard's format.
    record: Vec<u8>,
}

/// Derives the messages of topics from those of a recording.
#[derive(Debug)]
pub(crate) struct Deriver {
    header: Header,
    cameras: Cameras,
    /// Cycle of the last large data, and the names of its frames.
    last_cycle: (Option<u64>, Vec<String>),
    /// Newest large data of each frame, points and images, in the order of its times: in a file it precedes its cycle.
    waiting: BTreeMap<(String, bool), Vec<Waiting>>,
    coder: ImageCoder,
    /// Times of the last previews and of the last outputs that were shown, ns.
    shown: [Option<u64>; 2],
    tree: TreeRecord,
    outputs: Outputs,
    has_begun: bool,
    derived: Vec<Derived>,
}

impl Deriver {
    /// A deriver of the topics that a header requests.
    ///
    /// # Errors
    /// If two things have one topic.
    pub(crate) fn new(header: &Header) -> Result<Option<Self>, Invalid> {
        if header.topics == Topics::None {
            return Ok(None);
        }
        let (outputs, mut names) = (Outputs::new(&header.tree), NameTable::new("topic of the recording"));
        outputs.topics().try_for_each(|(topic, source)| names.add(topic, source))?;
        for Scenery { name, .. } in &header.scenery {
            names.add(format!("/scene/{}", path(name)), format!("the scenery `{name}`"))?;
        }
        Ok(Some(Self {
            header: header.clone(),
            cameras: Cameras::new(&header.tree),
            last_cycle: (None, Vec::new()),
            waiting: BTreeMap::new(),
            coder: ImageCoder::default(),
            shown: [None; 2],
            tree: TreeRecord::default(),
            outputs,
            has_begun: false,
            derived: Vec::new(),
        }))
    }

    /// Returns the messages that follow from a message of the recording. One that cannot be read has none.
    pub(crate) fn derive(&mut self, channel: Channel, time: u64, data: &[u8]) -> Vec<Derived> {
        if !std::mem::replace(&mut self.has_begun, true) {
            self.parameters();
            self.scenery(time);
            self.derived.extend(self.outputs.first_transforms(time));
        }
        let all = self.header.topics == Topics::All;
        match channel {
            Channel::Requests => self.request(time, data),
            Channel::Events => {
                if let Ok(RunEvent { kind, detail, .. }) = postcard::from_bytes(data) {
                    self.log(time, 2, "event", format!("{kind} {detail}").trim_end());
                }
            }
            Channel::Log => {
                if let Ok(LogLine { level, source, text }) = postcard::from_bytes(data) {
                    self.log(time, level, &format!("{source:?}").to_lowercase(), &text);
                }
            }
            Channel::Tree => {
                if let Ok(tree) = postcard::from_bytes(data) {
                    self.states(time, tree);
                }
            }
            Channel::Blobs => self.wait(time, data),
            Channel::Information => {
                if let Ok(record) = postcard::from_bytes(data) {
                    self.information(time, &record, all);
                }
            }
            Channel::Sensors | Channel::Command | Channel::Costs if all => self.numbers(channel, data),
            _ => {}
        }
        std::mem::take(&mut self.derived)
    }

    fn send(&mut self, topic: &str, schema: Schema, message: Protobuf) {
        self.push(topic.to_owned(), schema, Compression::Lz4, message.0);
    }

    fn push(&mut self, topic: String, schema: Schema, compression: Compression, data: Vec<u8>) {
        self.derived.push(Derived { topic, schema, compression, data });
    }

    fn log(&mut self, time: u64, level: u8, name: &str, text: &str) {
        self.send("/log", Schema::Foxglove("Log"), foxglove::log(time, level, name, text));
    }

    fn request(&mut self, time: u64, data: &[u8]) {
        let Ok(request) = postcard::from_bytes::<RequestRecord>(data) else { return };
        let text = request.describe(&self.header.tree);
        self.log(time, 2, "operator", &text);
        self.header.apply(&request);
        if matches!(request, RequestRecord::Tree(Change::Params(_))) {
            self.parameters();
        }
    }

    fn parameters(&mut self) {
        let mut message = Protobuf::default();
        for (number, component) in (1..).zip(&self.header.tree.components) {
            if component.params.is_empty() {
                continue;
            }
            message.nested(number, |out| {
                for (number, param) in (1..).zip(&component.params) {
                    let value = param.current();
                    match value {
                        Value::Bool(is_on) => out.int(number, is_on.into()),
                        Value::Choice(_) => out.text(number, &param.kind.text(value).to_string()),
                        // The digits of the f32, not the exact value of its f64.
                        _ => out.double(number, value.to_string().parse().unwrap_or(f64::NAN)),
                    };
                }
            });
        }
        if !message.0.is_empty() {
            self.send("/parameters", Schema::Parameters, message);
        }
    }

    /// Writes what does not move in the world, once.
    fn scenery(&mut self, time: u64) {
        for Scenery { name, shape, frame, colour, value, .. } in std::mem::take(&mut self.header.scenery) {
            let mut all = Vec::new();
            shape::each(&value, &mut |value| all.extend(shape::shapes(&shape, value)));
            let [red, green, blue] = colour.unwrap_or([u8::MAX; 3]).map(|part| f64::from(part) / 255.0);
            let scene = foxglove::scene(time, &frame, &name, &[red, green, blue, 1.0], &all);
            let topic = path(&name);
            self.send(&format!("/scene/{topic}"), Schema::Foxglove("SceneUpdate"), scene);
            let points = foxglove::points(time, &frame, &all);
            self.send(&format!("/points/{topic}"), Schema::Foxglove("PointCloud"), points);
        }
    }

    /// Writes the state of each component, and each change as text.
    fn states(&mut self, time: u64, tree: TreeRecord) {
        let mut message = Protobuf::default();
        let mut lines = Vec::new();
        for (index, component) in self.header.tree.components.iter().enumerate() {
            let state = |tree: &TreeRecord| self.header.tree.state(index, tree.state(index)).unwrap_or("active");
            let name = |tree: &TreeRecord| if tree.is_active(index) { state(tree) } else { "latent" };
            message.text(index as u32 + 1, name(&tree));
            if name(&tree) != name(&self.tree) {
                lines.push((component.name.clone(), format!("{}: {}", component.name, name(&tree))));
            }
        }
        self.tree = tree;
        self.send("/states", Schema::States, message);
        for (component, text) in &lines {
            self.log(time, 1, component, text);
        }
    }

    /// Keeps large data until its preview is due.
    fn wait(&mut self, time: u64, data: &[u8]) {
        let Ok(BlobRecord { format, frame, cycle, .. }) = postcard::from_bytes(data) else { return };
        let is_points = format == Format::Points;
        if is_points || is_image(format) {
            let (last, frames) = &mut self.last_cycle;
            if cycle.is_none() || *last != cycle {
                (*last, *frames) = (cycle, Vec::new());
            }
            // A damaged file may have any number, and of any size.
            if frames.len() >= MAX_BLOBS {
                return;
            }
            let bytes: usize = self.waiting.values().flatten().map(|one| one.record.len()).sum();
            if bytes + data.len() > MAX_CYCLE_BYTES {
                self.waiting.clear();
            }
            // Points and images have topics of different names.
            let frame = if is_points { frame.to_owned() } else { self.cameras.next_frame(frame, frames) };
            let waiting = self.waiting.entry((frame, is_points)).or_default();
            waiting.drain(..waiting.len().saturating_sub(MAX_WAITING - 1));
            waiting.push(Waiting { time, record: data.to_vec() });
        }
    }

    fn information(&mut self, time: u64, record: &InformationRecord, all: bool) {
        if all {
            self.json(record);
        }
        if self.shown[1].is_some_and(|shown| time < shown.saturating_add(OUTPUTS_AFTER)) {
            return;
        }
        self.shown[1] = Some(time);
        let seen = self.previews(time);
        let values = record
            .values
            .iter()
            .filter_map(|value| Some(((value.component.into(), value.index.into()), self.header.decode(value)?)));
        let values: HashMap<_, _> = values.collect();
        for derived in self.outputs.derive(time, &values, seen.as_ref(), &self.tree) {
            self.push(derived.topic, derived.schema, derived.compression, derived.data);
        }
    }

    /// Writes the newest images and point clouds, if they are due; returns the images.
    fn previews(&mut self, time: u64) -> Option<Seen> {
        if self.waiting.is_empty() {
            return None;
        }
        for waiting in self.waiting.values_mut() {
            let past = waiting.iter().take_while(|one| one.time <= time).count();
            waiting.drain(..past.saturating_sub(1));
        }
        if self.shown[0].is_some_and(|shown| time < shown.saturating_add(PREVIEW_AFTER)) {
            return Some(Seen::new());
        }
        self.shown[0] = Some(time);
        let mut seen = Seen::new();
        let due = self.waiting.iter_mut().filter_map(|((frame, _), waiting)| {
            let is_past = waiting.first()?.time <= time;
            is_past.then(|| (frame.clone(), waiting.remove(0)))
        });
        for (frame, Waiting { time, record }) in due.collect::<Vec<_>>() {
            let Ok(record) = postcard::from_bytes::<BlobRecord<'_>>(&record) else { continue };
            if record.format == Format::Points {
                let cloud = foxglove::cloud(time, &frame, record.stored);
                self.send(&format!("/{}/points", path(&frame)), Schema::Foxglove("PointCloud"), cloud);
            } else if let Some(preview) = Preview::new(&record, &mut self.coder) {
                let image = foxglove::image(time, &self.outputs.optical(&frame), &preview);
                let topic = format!("/{}/image", path(&frame));
                self.push(topic, Schema::Foxglove("CompressedImage"), Compression::None, image.0);
                seen.insert(frame, (time, preview));
            }
        }
        Some(seen)
    }

    /// Writes outputs as JSON.
    fn json(&mut self, record: &InformationRecord) {
        for value in &record.values {
            let Some(component) = self.header.tree.components.get(usize::from(value.component)) else { continue };
            let Some(output) = component.info.get(usize::from(value.index)) else { continue };
            let Some(json) = self.header.decode(value) else { continue };
            let topic = format!("/outputs/{}/{}", component.name, output.name);
            self.push(topic, Schema::Json, Compression::Lz4, numbers::object(json));
        }
    }

    /// Writes sensor values, a command or costs as JSON.
    fn numbers(&mut self, channel: Channel, data: &[u8]) {
        let messages = self.header.messages();
        let json = match channel {
            Channel::Sensors => messages.and_then(|messages| decode_message(&messages.sensors, data)),
            Channel::Command => messages.and_then(|messages| decode_message(&messages.command, data)),
            _ => postcard::from_bytes::<Costs>(data).ok().map(|costs| numbers::costs(&self.header.tree, &costs)),
        };
        if let Some(json) = json {
            self.push(format!("/{}", channel.topic()), Schema::Json, Compression::Lz4, numbers::object(json));
        }
    }
}
