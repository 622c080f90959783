//! Topics that other programs show: messages of ROS 2, derived from the messages of a recording, and ignored when it is read.

use std::collections::{BTreeMap, HashMap};

use bica::Format;
use bica::runner::Change;
use bica_link::{Shown, decode_message};
use bica_wire::model::{Description, Invalid};
use serde_json::{Map, Value, json};

use crate::blob::BlobRecord;
use crate::header::{Header, Topics};
use crate::image_codec::ImageCoder;
use crate::layout::{MAX_BLOBS, MAX_CYCLE_BYTES};
use crate::mcap::Compression;
use crate::message::{Channel, Costs, LogLine, RunEvent, TreeRecord};
use crate::names::NameTable;
use crate::outputs::OutputsRecord;
use crate::preview::{MAX_WIDTH, is_image};
use crate::request::RequestRecord;
use crate::ros::{self, Names, Sent, parameter_value};
use crate::scenery::Scenery;

/// Shortest time from one preview of an image to the next, ns.
const PREVIEW_AFTER: u64 = 290_000_000;
/// Shortest time between two records of outputs that are shown, ns: a monitor may receive more.
const OUTPUTS_AFTER: u64 = 45_000_000;
/// Time after which a value that is drawn is written again, although it has not changed, ns.
const AGAIN_AFTER: u64 = 1_000_000_000;
/// Maximum number of large data of a frame that wait.
const MAX_WAITING: usize = 64;

/// Message of a topic.
#[derive(Debug)]
pub(crate) struct Derived {
    /// Index of the topic.
    pub(crate) topic: usize,
    pub(crate) compression: Compression,
    /// The message in CDR, without its header.
    pub(crate) data: Vec<u8>,
}

/// Large data that waits for its preview.
#[derive(Debug)]
struct Waiting {
    time: u64,
    /// A [`BlobRecord`] in postcard's format.
    record: Vec<u8>,
}

/// An output with a visual type.
#[derive(Debug, Default)]
struct Visual {
    /// Frame of the camera in whose image the values lie.
    camera: Option<String>,
    /// Value that was written last, and its time, ns.
    last: Value,
    written: Option<u64>,
}

/// Derives the messages of topics from those of a recording.
#[derive(Debug)]
pub(crate) struct Deriver {
    header: Header,
    topics: ros::Topics,
    /// Cycle of the last large data, and the names of its frames.
    last_cycle: (Option<u64>, Vec<String>),
    /// Newest large data of each frame, points and images, in the order of its times: in a file it precedes its cycle.
    waiting: BTreeMap<(String, bool), Vec<Waiting>>,
    coder: ImageCoder,
    /// Times of the last previews and of the last outputs that were shown, ns.
    shown: [Option<u64>; 2],
    tree: TreeRecord,
    /// Last state of each component that a line of the log has named.
    states: Vec<String>,
    /// Outputs with a visual type, by the indices of component and output.
    visual: BTreeMap<(usize, usize), Visual>,
    has_begun: bool,
    derived: Vec<Derived>,
}

impl Deriver {
    /// Creates a deriver of the topics that a header requests, with the names of its robot.
    ///
    /// # Errors
    /// If two things have the same topic.
    pub(crate) fn new(header: &Header, names: Names) -> Result<Option<Self>, Invalid> {
        if header.topics == Topics::None {
            return Ok(None);
        }
        let scenery = header.scenery.iter().map(|item| item.name.as_str());
        let topics = ros::Topics::recorded(&header.tree, names, scenery, header.topics == Topics::All);
        let mut table = NameTable::new("topic of the recording");
        for channel in Channel::ALL {
            table.add(channel.topic(), format!("the recording's own `{}`", channel.name()))?;
        }
        topics.check(&mut table)?;
        let visual = |camera: Option<&str>| Visual { camera: camera.map(str::to_owned), ..Visual::default() };
        let visual = topics.visual().map(|(key, camera)| (key, visual(camera))).collect();
        Ok(Some(Self {
            header: header.clone(),
            topics,
            last_cycle: (None, Vec::new()),
            waiting: BTreeMap::new(),
            coder: ImageCoder::default(),
            shown: [None; 2],
            tree: TreeRecord::default(),
            states: Vec::new(),
            visual,
            has_begun: false,
            derived: Vec::new(),
        }))
    }

    /// Returns a topic.
    pub(crate) fn topic(&self, index: usize) -> &ros::Topic {
        &self.topics.all()[index]
    }

    /// Returns the messages that are derived from a message of the recording; none from a message that cannot be read.
    pub(crate) fn derive(&mut self, channel: Channel, time: u64, data: &[u8]) -> Vec<Derived> {
        if !std::mem::replace(&mut self.has_begun, true) {
            self.begin(time);
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
            Channel::Outputs => {
                if let Ok(record) = postcard::from_bytes(data) {
                    self.outputs(time, &record, all);
                }
            }
            Channel::Sensors | Channel::Command | Channel::Costs if all => self.numbers(channel, data),
            _ => {}
        }
        std::mem::take(&mut self.derived)
    }

    fn send(&mut self, messages: Vec<Sent>) {
        let derived = messages.into_iter().map(|(topic, message)| {
            // Coded data cannot be compressed further.
            let compression = if self.topics.is_image(topic) { Compression::None } else { Compression::Lz4 };
            Derived { topic, compression, data: message.0 }
        });
        self.derived.extend(derived);
    }

    fn log(&mut self, time: u64, level: u8, source: &str, text: &str) {
        self.send(self.topics.log(time, level, source, text));
    }

    /// Writes the data known before the first cycle: parameters, scenery, and one tree of frames.
    fn begin(&mut self, time: u64) {
        self.parameters(time);
        let scenery: Vec<_> = std::mem::take(&mut self.header.scenery).into_iter().map(shown).collect();
        if !scenery.is_empty() {
            self.send(self.topics.scenery(time, &scenery));
        }
        self.send(self.topics.fixed_frames(time));
        self.send(self.topics.first_frames(time));
    }

    fn request(&mut self, time: u64, data: &[u8]) {
        let Ok(request) = postcard::from_bytes::<RequestRecord>(data) else { return };
        let text = request.describe(&self.header.tree);
        self.log(time, 2, "operator", &text);
        self.header.apply(&request);
        if matches!(request, RequestRecord::Tree(Change::Params(_))) {
            self.parameters(time);
        }
    }

    fn parameters(&mut self, time: u64) {
        let components = self.header.tree.components.iter();
        let all = components.flat_map(|one| {
            one.params.iter().map(move |param| {
                (format!("{}.{}", one.name, param.name), parameter_value(&param.plain(param.current())))
            })
        });
        let all: BTreeMap<_, _> = all.collect();
        if !all.is_empty() {
            self.send(self.topics.parameters(time, all));
        }
    }

    /// Writes the state of each component, and each change as text.
    fn states(&mut self, time: u64, tree: TreeRecord) {
        let names = tree.names(&self.header.tree);
        let components = self.header.tree.components.iter().zip(&names).enumerate();
        let last = |index: usize| self.states.get(index).map_or("latent", String::as_str);
        let changed = components.filter(|(index, (_, name))| last(*index) != name.as_str());
        let lines = changed.map(|(_, (one, name))| (one.name.clone(), format!("{}: {name}", one.name)));
        for (component, text) in lines.collect::<Vec<_>>() {
            self.log(time, 1, &component, &text);
        }
        (self.tree, self.states) = (tree, names.clone());
        let messages = self.topics.states(&self.header.tree, names);
        self.send(messages);
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
            // A damaged file may have any number of large data, of any size.
            if frames.len() >= MAX_BLOBS {
                return;
            }
            let bytes: usize = self.waiting.values().flatten().map(|one| one.record.len()).sum();
            if bytes + data.len() > MAX_CYCLE_BYTES {
                self.waiting.clear();
            }
            // Points and images have topics of different names.
            let frame = if is_points { frame.to_owned() } else { self.topics.cameras().next_frame(frame, frames) };
            let waiting = self.waiting.entry((frame, is_points)).or_default();
            waiting.drain(..waiting.len().saturating_sub(MAX_WAITING - 1));
            waiting.push(Waiting { time, record: data.to_vec() });
        }
    }

    fn outputs(&mut self, time: u64, record: &OutputsRecord, all: bool) {
        let is_due = self.shown[1].is_none_or(|shown| time >= shown.saturating_add(OUTPUTS_AFTER));
        let mut values = HashMap::new();
        for value in &record.values {
            let key = (value.component.into(), value.index.into());
            let is_visual = self.visual.contains_key(&key);
            if (if is_visual { is_due } else { all })
                && let Some(json) = self.header.decode(value)
            {
                if is_visual {
                    values.insert(key, json);
                } else {
                    let messages = self.topics.value(time, key, &json);
                    self.send(messages);
                }
            }
        }
        if !is_due {
            return;
        }
        self.shown[1] = Some(time);
        let seen = self.previews(time);
        for key in self.visual.keys().copied().collect::<Vec<_>>() {
            self.visual(time, key, values.remove(&key), seen.as_ref());
        }
    }

    /// Writes the value of an output with a visual type, if it is to be shown. `seen` has the times of the images that are shown now, by
    /// their frames; `None` if there was no image.
    fn visual(&mut self, time: u64, key: (usize, usize), value: Option<Value>, seen: Option<&HashMap<String, u64>>) {
        let Some(Visual { camera, last, written }) = self.visual.get_mut(&key) else { return };
        let value = match value {
            None if self.tree.is_active(key.0) => return,
            value => value.unwrap_or_default(),
        };
        let mut time = time;
        if let Some(camera) = camera {
            match seen.map(|seen| seen.get(camera)) {
                Some(Some(measured)) => time = *measured,
                Some(None) => return,
                None => {}
            }
        }
        if self.topics.is_drawn(key) {
            // A missing value is shown once; a value in an image is shown with each image.
            let is_again = written.is_some_and(|at| camera.is_some() || time >= at.saturating_add(AGAIN_AFTER));
            if value == *last && (value.is_null() || !is_again) {
                return;
            }
            (*last, *written) = (value.clone(), Some(time));
        }
        let messages = if value.is_null() && !self.topics.is_drawn(key) {
            Vec::new()
        } else {
            self.topics.value(time, key, &value)
        };
        self.send(messages);
    }

    /// Writes the newest images and point clouds, if they are due; returns the times of the images.
    fn previews(&mut self, time: u64) -> Option<HashMap<String, u64>> {
        if self.waiting.is_empty() {
            return None;
        }
        for waiting in self.waiting.values_mut() {
            let past = waiting.iter().take_while(|one| one.time <= time).count();
            waiting.drain(..past.saturating_sub(1));
        }
        if self.shown[0].is_some_and(|shown| time < shown.saturating_add(PREVIEW_AFTER)) {
            return Some(HashMap::new());
        }
        self.shown[0] = Some(time);
        let mut seen = HashMap::new();
        let due = self.waiting.iter_mut().filter_map(|((frame, _), waiting)| {
            let is_past = waiting.first()?.time <= time;
            is_past.then(|| (frame.clone(), waiting.remove(0)))
        });
        for (frame, Waiting { time, record }) in due.collect::<Vec<_>>() {
            let Ok(record) = postcard::from_bytes::<BlobRecord<'_>>(&record) else { continue };
            if record.format == Format::Points {
                let cloud = self.topics.cloud(time, &frame, record.stored);
                self.send(cloud);
                continue;
            }
            let messages = match record.format {
                Format::Jpeg => self.topics.image(time, &frame, record.format, record.stored, MAX_WIDTH),
                format => match record.decode(&mut self.coder) {
                    Some(stored) => self.topics.image(time, &frame, format, &stored.bytes, MAX_WIDTH),
                    None => Vec::new(),
                },
            };
            if !messages.is_empty() {
                self.send(messages);
                seen.insert(frame, time);
            }
        }
        Some(seen)
    }

    /// Writes sensor values, a command or costs as JSON.
    fn numbers(&mut self, channel: Channel, data: &[u8]) {
        let messages = self.header.messages();
        let json = match channel {
            Channel::Sensors => messages.and_then(|messages| decode_message(&messages.sensors, data)),
            Channel::Command => messages.and_then(|messages| decode_message(&messages.command, data)),
            _ => postcard::from_bytes::<Costs>(data).ok().map(|all| costs(&self.header.tree, &all)),
        };
        if let Some(json) = json {
            self.send(self.topics.numbers(channel.name(), &json));
        }
    }
}

/// Converts an item of the scenery to the form of a monitor.
fn shown(item: Scenery) -> Shown {
    let Scenery { name, shape, frame, colour, line_width, value } = item;
    let colour = colour.map(|[red, green, blue]| format!("#{red:02x}{green:02x}{blue:02x}"));
    Shown { name, shape, frame, child: None, value, colour, line_width }
}

/// Returns the time of each component, µs.
fn costs(tree: &Description, costs: &Costs) -> Value {
    let times = tree.components.iter().zip(&costs.components);
    Value::Object(times.map(|(one, cost)| (one.name.clone(), json!(cost.ns as f64 * 1e-3))).collect::<Map<_, _>>())
}
