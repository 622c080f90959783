//! What a robot publishes, for the node and for bags.

mod convert;
mod markers;
mod output;

use std::collections::{BTreeMap, BTreeSet};

use bica::Format;
use bica_link::{Costs, Shown};
use bica_recording::shape::{CALIBRATION, OPTICAL};
use bica_recording::{Cameras, NameTable, jpeg};
use bica_wire::model::{Component, Description, Invalid};
use serde_json::Value;

use crate::message::{
    Byte, Clock, CompressedImage, DiagnosticArray, DiagnosticStatus, Encoded, Header, KeyValue, Kind, Log, MarkerArray,
    Parameter, ParameterEvent, ParameterValue, Ros, Text, Time, Transforms,
};
use crate::names::Names;
use convert::transform;
use markers::markers;
use output::Output;

/// Greatest width of an image, px: none is made smaller.
const MAX_WIDTH: usize = 1 << 14;
/// Levels of a line of the log of ROS for those of a robot: 1 debug, 2 information, 3 warning, 4 error.
const LOG_LEVELS: [u8; 5] = [10, 10, 20, 30, 40];
/// Level of a warning in diagnostics.
const WARN: u8 = 1;

/// How a topic is sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Quality {
    /// Sensor data: best effort.
    Sensor,
    /// Reliable.
    Reliable,
    /// Reliable, and kept for nodes that come later.
    Latched,
}

impl Quality {
    /// Returns the quality of service as the metadata of a bag have it: YAML, with a number for each choice.
    pub(crate) fn profile(self) -> String {
        let (depth, reliability, durability) = match self {
            Self::Sensor => (10, 2, 2),
            Self::Reliable => (10, 1, 2),
            Self::Latched => (1, 1, 1),
        };
        let forever = "{sec: 9223372036, nsec: 854775807}";
        format!(
            "[{{history: 1, depth: {depth}, reliability: {reliability}, durability: {durability}, deadline: {forever}, \
             lifespan: {forever}, liveliness: 1, liveliness_lease_duration: {forever}, \
             avoid_ros_namespace_conventions: false}}]"
        )
    }
}

/// A topic.
#[derive(Clone, Debug)]
pub(crate) struct Topic {
    /// Absolute name.
    pub(crate) name: String,
    /// What it is the topic of.
    source: String,
    pub(crate) kind: Kind,
    pub(crate) quality: Quality,
}

/// A message and the index of its topic.
pub(crate) type Sent = (usize, Encoded);

/// The topics of a robot, and its messages.
#[derive(Debug)]
pub(crate) struct Topics {
    all: Vec<Topic>,
    outputs: BTreeMap<(usize, usize), Output>,
    names: Names,
    cameras: Cameras,
    /// Topic of the images of each frame of a camera; none if ROS cannot distinguish its name from another one.
    images: BTreeMap<String, Option<usize>>,
    /// Frames of cameras that the tree calibrates.
    calibrated: BTreeSet<String>,
    tf_static: usize,
    clock: usize,
    log: usize,
    diagnostics: usize,
    parameters: usize,
    scenery: usize,
    states: usize,
    /// Topic and last name of the state of each component with states.
    state: BTreeMap<usize, (usize, String)>,
    last_states: Vec<String>,
}

impl Topics {
    /// The topics of a robot.
    pub(crate) fn new(description: &Description, names: Names, has_images: bool) -> Self {
        let mut topics = Vec::new();
        let mut add = |name: String, source: String, kind, quality| {
            topics.push(Topic { name, source, kind, quality });
            topics.len() - 1
        };
        let mut own = |name: String, kind, quality| {
            let source = format!("the node's own `{}`", name.rsplit('/').next().unwrap_or_default());
            add(name, source, kind, quality)
        };
        let tf = own("/tf".to_owned(), Kind::of::<Transforms>(), Quality::Reliable);
        let tf_static = own("/tf_static".to_owned(), Kind::of::<Transforms>(), Quality::Latched);
        let clock = own("/clock".to_owned(), Kind::of::<Clock>(), Quality::Sensor);
        let log = own("/rosout".to_owned(), Kind::of::<Log>(), Quality::Latched);
        let diagnostics = own("/diagnostics".to_owned(), Kind::of::<DiagnosticArray>(), Quality::Reliable);
        let parameters = own("/parameter_events".to_owned(), Kind::of::<ParameterEvent>(), Quality::Reliable);
        let scenery = own(names.private(&["scenery"]), Kind::of::<MarkerArray>(), Quality::Latched);
        let states = own(names.private(&["states"]), Kind::of::<DiagnosticStatus>(), Quality::Latched);
        let state = description.components.iter().enumerate().filter(|(_, one)| !one.states.is_empty());
        let state = state.map(|(index, one)| {
            let source = format!("the state of `{}`", one.name);
            let topic = add(names.private(&[&one.name, "state"]), source, Kind::of::<Text>(), Quality::Latched);
            (index, (topic, String::new()))
        });
        let state = state.collect();
        let calibrated = placements(description).filter(|one| one.shape == CALIBRATION).map(|one| one.frame.clone());
        let calibrated = calibrated.collect();
        let is_in_image = |shape: &str| shape == CALIBRATION || shape.starts_with("Image");
        let frames = placements(description).filter(|one| has_images && is_in_image(&one.shape));
        let images = frames.map(|one| one.frame.clone()).collect::<BTreeSet<_>>().into_iter().map(|frame| {
            let Topic { name, source, kind, quality } = image_topic(&names, &frame);
            (frame, Some(add(name, source, kind, quality)))
        });
        let images = images.collect();
        let outputs = output::all(description, &names, tf, &mut add);
        let last_states = Vec::new();
        Self {
            all: topics,
            outputs,
            names,
            cameras: Cameras::new(description),
            images,
            calibrated,
            tf_static,
            clock,
            log,
            diagnostics,
            parameters,
            scenery,
            states,
            state,
            last_states,
        }
    }

    /// Checks that each topic has another name.
    ///
    /// # Errors
    /// The two things with one name.
    pub(crate) fn check(&self, table: &mut NameTable) -> Result<(), Invalid> {
        self.all.iter().try_for_each(|topic| table.add(&topic.name, &topic.source))
    }

    pub(crate) fn all(&self) -> &[Topic] {
        &self.all
    }

    /// Returns the indices of component and output of all that is needed for a topic.
    pub(crate) fn sources(&self, topic: usize) -> impl Iterator<Item = (usize, usize)> {
        self.outputs.iter().filter(move |(_, output)| output.topics.contains(&Some(topic))).map(|(key, _)| *key)
    }

    /// Returns the topics of an output.
    pub(crate) fn of(&self, component: usize, info: usize) -> impl Iterator<Item = usize> {
        self.outputs.get(&(component, info)).into_iter().flat_map(|output| output.topics).flatten()
    }

    /// Whether a topic shows images.
    pub(crate) fn is_image(&self, topic: usize) -> bool {
        self.images.values().any(|image| *image == Some(topic))
    }

    /// Whether a topic shows costs.
    pub(crate) const fn is_costs(&self, topic: usize) -> bool {
        topic == self.diagnostics
    }

    fn header(&self, time: u64, frame: &str) -> Header {
        Header { stamp: stamp(time), frame_id: self.names.frame(frame) }
    }

    /// Returns the messages of the value of an output after the cycle at a time, ns.
    pub(crate) fn value(&mut self, time: u64, key: (usize, usize), value: &Value) -> Vec<Sent> {
        self.outputs.get_mut(&key).map(|output| output.messages(time, value)).unwrap_or_default()
    }

    /// Returns the places of frames that never move.
    pub(crate) fn fixed_frames(&self) -> Vec<Sent> {
        let of_camera = |frame: &String| transform(self.header(0, frame), self.names.optical(frame), &OPTICAL);
        let transforms: Vec<_> = self.calibrated.iter().map(of_camera).collect();
        if transforms.is_empty() { Vec::new() } else { sent(self.tf_static, &Transforms { transforms }) }
    }

    /// Returns the time of a simulation, ns.
    pub(crate) fn clock(&self, time: u64) -> Vec<Sent> {
        sent(self.clock, &Clock { clock: stamp(time) })
    }

    /// Returns the states of the components, if one has changed. `states` has the name of each component's state, `active` for one
    /// without states, and `latent`.
    pub(crate) fn states(&mut self, description: &Description, states: Vec<String>) -> Vec<Sent> {
        if states == self.last_states {
            return Vec::new();
        }
        let mut messages = Vec::new();
        for (component, (topic, last)) in &mut self.state {
            if states.get(*component).is_some_and(|state| state != last) {
                last.clone_from(&states[*component]);
                messages.extend(sent(*topic, &Text { data: last.clone() }));
            }
        }
        let value = |(one, state): (&Component, &String)| KeyValue { key: one.name.clone(), value: state.clone() };
        let values = description.components.iter().zip(&states).map(value).collect();
        let message = states.get(description.root).cloned().unwrap_or_default();
        let (name, hardware_id) = (self.names.node.clone(), self.names.full());
        messages.extend(sent(self.states, &DiagnosticStatus { level: Byte(0), name, message, hardware_id, values }));
        self.last_states = states;
        messages
    }

    /// Returns what does not move in the robot's world.
    pub(crate) fn scenery(&self, items: &[Shown]) -> Vec<Sent> {
        let of_item = |item: &Shown| {
            let channel = |at| item.colour.as_ref().and_then(|text| u8::from_str_radix(text.get(at..at + 2)?, 16).ok());
            let colour = [1, 3, 5].map(|at| f32::from(channel(at).unwrap_or(u8::MAX)) / 255.0);
            markers(&self.header(0, &item.frame), &item.name, &item.shape, &item.value, colour)
        };
        sent(self.scenery, &MarkerArray { markers: items.iter().flat_map(of_item).collect() })
    }

    /// Frames of the cameras.
    pub(crate) const fn cameras(&self) -> &Cameras {
        &self.cameras
    }

    /// Returns a camera image in a frame, coded as JPEG. The first one of a frame adds its topic.
    pub(crate) fn image(&mut self, time: u64, camera: &str, format: Format<'_>, pixels: &[u8]) -> Vec<Sent> {
        let topic = if let Some(topic) = self.images.get(camera) {
            *topic
        } else {
            let topic = image_topic(&self.names, camera);
            let other = self.all.iter().find(|other| other.name == topic.name);
            let what = other.map(|other| format!("{} and {} have the same ROS topic", other.source, topic.source));
            self.images.insert(camera.to_owned(), what.is_none().then_some(self.all.len()));
            if let Some(what) = what {
                return self.log(time, 3, &format!("{what}: the second one is not published; rename its frame"));
            }
            self.all.push(topic);
            Some(self.all.len() - 1)
        };
        let Some(topic) = topic else { return Vec::new() };
        let (data, size) = match format {
            Format::Jpeg => (pixels.to_vec(), None),
            _ => match jpeg(format, pixels, MAX_WIDTH) {
                Some(jpeg) => (jpeg.data, Some([jpeg.width, jpeg.height])),
                None => return Vec::new(),
            },
        };
        for output in self.outputs.values_mut().filter(|output| output.camera.as_deref() == Some(camera)) {
            output.image_size = size.or(output.image_size);
        }
        let is_calibrated = self.calibrated.contains(camera);
        let frame_id = if is_calibrated { self.names.optical(camera) } else { self.names.frame(camera) };
        let header = Header { stamp: stamp(time), frame_id };
        sent(topic, &CompressedImage { header, format: "jpeg".to_owned(), data })
    }

    /// Returns a line of the log. Levels: 1 debug, 2 information, 3 warning, 4 error.
    pub(crate) fn log(&self, time: u64, level: u8, text: &str) -> Vec<Sent> {
        let level = LOG_LEVELS[usize::from(level).min(LOG_LEVELS.len() - 1)];
        let (stamp, name, msg) = (stamp(time), self.names.node.clone(), text.to_owned());
        sent(self.log, &Log { stamp, level, name, msg, ..Log::default() })
    }

    /// Returns parameters that have changed.
    pub(crate) fn parameters(&self, time: u64, changed: BTreeMap<String, ParameterValue>) -> Vec<Sent> {
        let changed_parameters = changed.into_iter().map(|(name, value)| Parameter { name, value }).collect();
        let (stamp, node) = (stamp(time), self.names.full());
        sent(self.parameters, &ParameterEvent { stamp, node, changed_parameters, ..ParameterEvent::default() })
    }

    /// Returns the costs of the cycle and of the components that exceeded their budgets.
    pub(crate) fn costs(&self, time: u64, description: &Description, costs: &Costs) -> Vec<Sent> {
        let value = |key: &str, number: f32| KeyValue { key: key.to_owned(), value: format!("{number:.1}") };
        let cycle = vec![value("mean (µs)", costs.cycles.mean_us), value("max (µs)", costs.cycles.max_us)];
        let status = |level, name: String, message: &str, values| DiagnosticStatus {
            level: Byte(level),
            name: format!("{}: {name}", self.names.node),
            message: message.to_owned(),
            hardware_id: self.names.full(),
            values,
        };
        let of_component = description.components.iter().zip(&costs.components).filter(|(_, cost)| cost.runs > 0);
        let components = of_component.map(|(one, cost)| {
            let (level, message) =
                if cost.overruns > 0 { (WARN, "above its budget") } else { (0, "within its budget") };
            let values = vec![value("mean (µs)", cost.mean_us), value("max (µs)", cost.max_us)];
            status(level, one.name.clone(), message, values)
        });
        let status = [status(0, "cycle".to_owned(), "runs", cycle)].into_iter().chain(components).collect();
        let header = Header { stamp: stamp(time), frame_id: String::new() };
        sent(self.diagnostics, &DiagnosticArray { header, status })
    }
}

/// Returns the topic of the images in a frame.
fn image_topic(names: &Names, frame: &str) -> Topic {
    let (name, source) = (names.camera(frame, "image_raw/compressed"), format!("the images in the frame `{frame}`"));
    Topic { name, source, kind: Kind::of::<CompressedImage>(), quality: Quality::Sensor }
}

fn placements(description: &Description) -> impl Iterator<Item = &bica_wire::model::Placement> {
    description.components.iter().flat_map(|one| &one.info).filter_map(|info| info.placement.as_ref())
}

fn sent(topic: usize, message: &impl Ros) -> Vec<Sent> {
    vec![(topic, Encoded::from(message))]
}

/// Returns a time, ns, as ROS writes it.
pub(crate) const fn stamp(time: u64) -> Time {
    Time { sec: (time / 1_000_000_000) as i32, nanosec: (time % 1_000_000_000) as u32 }
}
