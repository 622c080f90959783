//! Topics and messages of a robot, for the node and for recordings.

mod annotations;
mod convert;
mod diagnostics;
mod markers;
mod output;
mod points;
mod topic;

use std::collections::{BTreeMap, BTreeSet};

use bica::Format;
use bica_link::Shown;
use bica_wire::model::{Component, Description, Invalid};
use serde_json::Value;

use super::{
    Byte, Clock, CompressedImage, DiagnosticArray, DiagnosticStatus, Header, KeyValue, Kind, Log, MarkerArray, Names,
    Parameter, ParameterEvent, ParameterValue, PointCloud, Ros as _, Text, Transforms,
};
use crate::cameras::Cameras;
use crate::names::NameTable;
use crate::preview::jpeg;
use crate::shape::{CALIBRATION, OPTICAL, Pose, each, shapes};
use convert::transform;
use markers::markers;
use output::OutputTopics;
pub use topic::{Quality, Sent, Topic, parameter_value};
use topic::{image_topic, placements, sent, stamp};

/// Levels of a line of the log of ROS for those of a robot: 1 debug, 2 information, 3 warning, 4 error.
const LOG_LEVELS: [u8; 5] = [10, 10, 20, 30, 40];
/// Data that a recording contains as JSON in texts, if all numbers are requested.
const NUMBERS: [&str; 3] = ["sensors", "command", "costs"];

/// The topics of a robot, and its messages.
#[derive(Debug)]
pub struct Topics {
    all: Vec<Topic>,
    outputs: BTreeMap<(usize, usize), OutputTopics>,
    names: Names,
    cameras: Cameras,
    /// Topics of images and of point clouds, by their names; none if another thing has the name.
    measured: BTreeMap<String, Option<usize>>,
    /// Frames of cameras that the tree calibrates.
    calibrated: BTreeSet<String>,
    tf: usize,
    tf_static: usize,
    clock: usize,
    log: usize,
    diagnostics: usize,
    parameters: usize,
    scenery: usize,
    states: usize,
    /// Topic of the state of each component with states, and name of its last state.
    state: BTreeMap<usize, (usize, String)>,
    last_states: Vec<String>,
    /// Topics that only recordings have: points of a scenery, and numbers.
    scenery_points: BTreeMap<String, usize>,
    numbers: BTreeMap<&'static str, usize>,
}

impl Topics {
    /// Returns the topics of a node. `has_images` is whether the robot may send images.
    #[must_use]
    pub fn new(description: &Description, names: Names, has_images: bool) -> Self {
        Self::of(description, names, has_images, false)
    }

    /// Returns the topics of a recording: those of a node, and markers and points of everything drawn, because viewers do not
    /// show all messages. `scenery` are the names of the objects that do not move; `has_numbers` is whether sensor values,
    /// commands and costs have topics.
    #[must_use]
    pub fn recorded<'a>(
        description: &Description,
        names: Names,
        scenery: impl Iterator<Item = &'a str>,
        has_numbers: bool,
    ) -> Self {
        let mut topics = Self::of(description, names, true, true);
        for name in scenery {
            let (topic, source) = (topics.names.private(&["scenery", name, "points"]), format!("the scenery `{name}`"));
            let index = topics.add(topic, source, Kind::of::<PointCloud>(), Quality::Latched);
            topics.scenery_points.insert(name.to_owned(), index);
        }
        for name in NUMBERS.into_iter().filter(|_| has_numbers) {
            let (topic, source) = (topics.names.private(&[name]), format!("the recorded {name}"));
            let index = topics.add(topic, source, Kind::of::<Text>(), Quality::Reliable);
            topics.numbers.insert(name, index);
        }
        topics
    }

    fn add(&mut self, name: String, source: String, kind: Kind, quality: Quality) -> usize {
        self.all.push(Topic { name, source, kind, quality });
        self.all.len() - 1
    }

    fn of(description: &Description, names: Names, has_images: bool, for_viewers: bool) -> Self {
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
            (name.clone(), Some(add(name, source, kind, quality)))
        });
        let measured = images.collect();
        let outputs = output::all(description, &names, tf, for_viewers, &mut add);
        let (last_states, scenery_points, numbers) = Default::default();
        Self {
            all: topics,
            outputs,
            names,
            cameras: Cameras::new(description),
            measured,
            calibrated,
            tf,
            tf_static,
            clock,
            log,
            diagnostics,
            parameters,
            scenery,
            states,
            state,
            last_states,
            scenery_points,
            numbers,
        }
    }

    /// Checks that all topics have different names.
    ///
    /// # Errors
    /// If two things have the same name.
    pub fn check(&self, table: &mut NameTable) -> Result<(), Invalid> {
        self.all.iter().try_for_each(|topic| table.add(&topic.name, &topic.source))
    }

    /// Returns all topics so far, by their indices.
    #[must_use]
    pub fn all(&self) -> &[Topic] {
        &self.all
    }

    /// Returns the indices of component and output of all outputs that a topic needs.
    pub fn sources(&self, topic: usize) -> impl Iterator<Item = (usize, usize)> {
        self.outputs.iter().filter(move |(_, output)| output.topics.contains(&Some(topic))).map(|(key, _)| *key)
    }

    /// Returns the topics of an output.
    pub fn of_output(&self, component: usize, output: usize) -> impl Iterator<Item = usize> {
        self.outputs.get(&(component, output)).into_iter().flat_map(|output| output.topics).flatten()
    }

    /// Returns whether a topic shows images.
    #[must_use]
    pub fn is_image(&self, topic: usize) -> bool {
        self.all.get(topic).is_some_and(|topic| topic.kind.name == CompressedImage::TYPE.1)
    }

    /// Returns whether a topic shows costs.
    #[must_use]
    pub const fn is_costs(&self, topic: usize) -> bool {
        topic == self.diagnostics
    }

    fn header(&self, time: u64, frame: &str) -> Header {
        Header { stamp: stamp(time), frame_id: self.names.frame(frame) }
    }

    /// Returns the indices of component and output of all outputs with a visual type, and the camera in whose image they lie.
    pub fn visual(&self) -> impl Iterator<Item = ((usize, usize), Option<&str>)> {
        let visual = self.outputs.iter().filter(|(_, output)| output.is_visual());
        visual.map(|(key, output)| (*key, output.camera.as_deref()))
    }

    /// Returns whether viewers show a value of an output until another value replaces it.
    #[must_use]
    pub fn is_drawn(&self, key: (usize, usize)) -> bool {
        self.outputs.get(&key).is_some_and(OutputTopics::is_drawn)
    }

    /// Returns the messages of the value of an output after the cycle at a time, ns.
    pub fn value(&mut self, time: u64, key: (usize, usize), value: &Value) -> Vec<Sent> {
        self.outputs.get_mut(&key).map(|output| output.messages(time, value)).unwrap_or_default()
    }

    /// Returns the places of frames that never move, at a time, ns.
    #[must_use]
    pub fn fixed_frames(&self, time: u64) -> Vec<Sent> {
        let of_camera = |frame: &String| transform(self.header(time, frame), self.names.optical(frame), &OPTICAL);
        let transforms: Vec<_> = self.calibrated.iter().map(of_camera).collect();
        if transforms.is_empty() { Vec::new() } else { sent(self.tf_static, &Transforms { transforms }) }
    }

    /// Returns a first place of each frame, at the origin of the other frame: viewers show nothing until the frames form a single
    /// tree.
    #[must_use]
    pub fn first_frames(&self, time: u64) -> Vec<Sent> {
        const ORIGIN: Pose = Pose { position: [0.0; 3], rotation: [0.0, 0.0, 0.0, 1.0] };
        let first = |output: &OutputTopics| Some(transform(output.header(time), output.child.clone()?, &ORIGIN));
        let transforms: Vec<_> = self.outputs.values().filter_map(first).collect();
        if transforms.is_empty() { Vec::new() } else { sent(self.tf, &Transforms { transforms }) }
    }

    /// Returns the time of a simulation, ns.
    #[must_use]
    pub fn clock(&self, time: u64) -> Vec<Sent> {
        sent(self.clock, &Clock { clock: stamp(time) })
    }

    /// Returns the states of the components, if one has changed. `states` contains for each component the name of its state,
    /// `active` if it has no states, or `latent`.
    pub fn states(&mut self, description: &Description, states: Vec<String>) -> Vec<Sent> {
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

    /// Returns the scenery of the robot's world.
    #[must_use]
    pub fn scenery(&self, time: u64, items: &[Shown]) -> Vec<Sent> {
        let of_item = |item: &Shown| {
            let channel = |at| item.colour.as_ref().and_then(|text| u8::from_str_radix(text.get(at..at + 2)?, 16).ok());
            let colour = [1, 3, 5].map(|at| f32::from(channel(at).unwrap_or(u8::MAX)) / 255.0);
            markers(&self.header(time, &item.frame), &item.name, &item.shape, &item.value, colour)
        };
        let mut messages = sent(self.scenery, &MarkerArray { markers: items.iter().flat_map(of_item).collect() });
        for item in items {
            if let Some(topic) = self.scenery_points.get(&item.name) {
                let mut all = Vec::new();
                each(&item.value, &mut |value| all.extend(shapes(&item.shape, value)));
                messages.extend(sent(*topic, &points::points(self.header(time, &item.frame), &all)));
            }
        }
        messages
    }

    /// Returns the frames of the cameras.
    #[must_use]
    pub const fn cameras(&self) -> &Cameras {
        &self.cameras
    }

    /// Returns a camera image in a frame, coded as JPEG, at most `max_width` pixels wide. The first image of a frame adds its
    /// topic.
    pub fn image(&mut self, time: u64, camera: &str, format: Format<'_>, pixels: &[u8], max_width: usize) -> Vec<Sent> {
        let topic = match self.measured(time, image_topic(&self.names, camera)) {
            Ok(topic) => topic,
            Err(refused) => return refused,
        };
        let (data, size, scale) = match format {
            Format::Jpeg => (pixels.to_vec(), None, 1.0),
            _ => match jpeg(format, pixels, max_width) {
                Some(jpeg) => (jpeg.data, Some([jpeg.width, jpeg.height]), jpeg.scale),
                None => return Vec::new(),
            },
        };
        for output in self.outputs.values_mut().filter(|output| output.camera.as_deref() == Some(camera)) {
            (output.image_size, output.scale) = (size.or(output.image_size), scale);
        }
        let is_calibrated = self.calibrated.contains(camera);
        let frame_id = if is_calibrated { self.names.optical(camera) } else { self.names.frame(camera) };
        let header = Header { stamp: stamp(time), frame_id };
        sent(topic, &CompressedImage { header, format: "jpeg".to_owned(), data })
    }

    /// Returns a recorded point cloud in a frame, of three little-endian `f32` for each point. The first cloud of a frame adds
    /// its topic.
    pub fn cloud(&mut self, time: u64, frame: &str, data: &[u8]) -> Vec<Sent> {
        let (name, source) = (self.names.camera(frame, "points"), format!("the points in the frame `{frame}`"));
        let topic = Topic { name, source, kind: Kind::of::<PointCloud>(), quality: Quality::Sensor };
        match self.measured(time, topic) {
            Ok(topic) => sent(topic, &points::cloud(self.header(time, frame), data.to_vec())),
            Err(refused) => refused,
        }
    }

    /// Returns the index of a topic of images or points. If another topic has its name, the first call returns a line of the log.
    fn measured(&mut self, time: u64, topic: Topic) -> Result<usize, Vec<Sent>> {
        if let Some(known) = self.measured.get(&topic.name) {
            return known.ok_or_else(Vec::new);
        }
        let other = self.all.iter().find(|other| other.name == topic.name);
        let what = other.map(|other| format!("{} and {} have the same ROS topic", other.source, topic.source));
        self.measured.insert(topic.name.clone(), what.is_none().then_some(self.all.len()));
        if let Some(what) = what {
            let line = format!("{what}: the second one is not published; rename its frame");
            return Err(self.log(time, 3, "", &line));
        }
        self.all.push(topic);
        Ok(self.all.len() - 1)
    }

    /// Returns a line of the log, of a source such as a component, or of the robot. Levels: 1 debug, 2 information, 3 warning, 4 error.
    #[must_use]
    pub fn log(&self, time: u64, level: u8, source: &str, text: &str) -> Vec<Sent> {
        let level = LOG_LEVELS[usize::from(level).min(LOG_LEVELS.len() - 1)];
        let name = if source.is_empty() { self.names.node.clone() } else { format!("{}.{source}", self.names.node) };
        let (stamp, msg) = (stamp(time), text.to_owned());
        sent(self.log, &Log { stamp, level, name, msg, ..Log::default() })
    }

    /// Returns sensor values, a command or costs as JSON, if the recording has a topic for them.
    #[must_use]
    pub fn numbers(&self, name: &str, value: &Value) -> Vec<Sent> {
        let topic = self.numbers.get(name);
        topic.map(|topic| sent(*topic, &Text { data: value.to_string() })).unwrap_or_default()
    }

    /// Returns parameters that have changed, by their names `Component.name`.
    #[must_use]
    pub fn parameters(&self, time: u64, changed: BTreeMap<String, ParameterValue>) -> Vec<Sent> {
        let changed_parameters = changed.into_iter().map(|(name, value)| Parameter { name, value }).collect();
        let (stamp, node) = (stamp(time), self.names.full());
        sent(self.parameters, &ParameterEvent { stamp, node, changed_parameters, ..ParameterEvent::default() })
    }
}
