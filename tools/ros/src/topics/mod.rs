//! What a robot publishes, for the node and for bags.

mod convert;
mod markers;
mod output;

use std::collections::BTreeMap;

use bica::Format;
use bica_link::{Costs, Shown};
use bica_recording::jpeg;
use bica_recording::shape::{CALIBRATION, OPTICAL};
use bica_wire::model::{Component, Description};
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

/// A topic.
#[derive(Clone, Debug)]
pub(crate) struct Topic {
    /// Absolute name.
    pub(crate) name: String,
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
    /// Name of the frame of the cameras, if the tree calibrates one.
    camera: Option<String>,
    tf_static: usize,
    clock: usize,
    log: usize,
    diagnostics: usize,
    parameters: usize,
    scenery: usize,
    states: usize,
    image: Option<usize>,
    /// Topic and last name of the state of each component with states.
    state: BTreeMap<usize, (usize, String)>,
    last_states: Vec<String>,
}

impl Topics {
    /// The topics of a robot.
    pub(crate) fn new(description: &Description, names: Names, has_images: bool) -> Self {
        let mut topics = Vec::new();
        let mut add = |name: String, kind, quality| {
            topics.push(Topic { name, kind, quality });
            topics.len() - 1
        };
        let tf = add("/tf".to_owned(), Kind::of::<Transforms>(), Quality::Reliable);
        let tf_static = add("/tf_static".to_owned(), Kind::of::<Transforms>(), Quality::Latched);
        let clock = add("/clock".to_owned(), Kind::of::<Clock>(), Quality::Sensor);
        let log = add("/rosout".to_owned(), Kind::of::<Log>(), Quality::Latched);
        let diagnostics = add("/diagnostics".to_owned(), Kind::of::<DiagnosticArray>(), Quality::Reliable);
        let parameters = add("/parameter_events".to_owned(), Kind::of::<ParameterEvent>(), Quality::Reliable);
        let scenery = add(names.private(&["scenery"]), Kind::of::<MarkerArray>(), Quality::Latched);
        let states = add(names.private(&["states"]), Kind::of::<DiagnosticStatus>(), Quality::Latched);
        let state = description.components.iter().enumerate().filter(|(_, one)| !one.states.is_empty());
        let state = state.map(|(index, one)| {
            let topic = add(names.private(&[&one.name, "state"]), Kind::of::<Text>(), Quality::Latched);
            (index, (topic, String::new()))
        });
        let state = state.collect();
        let camera = placements(description).find(|one| one.shape == CALIBRATION).map(|one| one.frame.clone());
        let image = names.public(&format!("{}/image_raw/compressed", camera.as_deref().unwrap_or("camera")));
        let image = has_images.then(|| add(image, Kind::of::<CompressedImage>(), Quality::Sensor));
        let outputs = output::all(description, &names, tf, &mut add);
        let last_states = Vec::new();
        Self {
            all: topics,
            outputs,
            names,
            camera,
            tf_static,
            clock,
            log,
            diagnostics,
            parameters,
            scenery,
            states,
            image,
            state,
            last_states,
        }
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
        Some(topic) == self.image
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
        let Some(camera) = &self.camera else { return Vec::new() };
        let optical = format!("{}_optical", self.names.frame(camera));
        sent(self.tf_static, &Transforms { transforms: vec![transform(self.header(0, camera), optical, &OPTICAL)] })
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

    /// Returns a camera image, coded as JPEG. Cameras of other names than the tree's share its frame, as in the tree.
    pub(crate) fn image(&mut self, time: u64, camera: &str, format: Format<'_>, pixels: &[u8]) -> Vec<Sent> {
        let Some(topic) = self.image else { return Vec::new() };
        let (data, size) = match format {
            Format::Jpeg => (pixels.to_vec(), None),
            _ => match jpeg(format, pixels, MAX_WIDTH) {
                Some(jpeg) => (jpeg.data, Some([jpeg.width, jpeg.height])),
                None => return Vec::new(),
            },
        };
        for output in self.outputs.values_mut().filter(|_| size.is_some()) {
            output.image_size = size;
        }
        let known = self.camera.as_ref().map(|own| format!("{own}_optical"));
        let header = self.header(time, known.as_deref().unwrap_or(camera));
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
