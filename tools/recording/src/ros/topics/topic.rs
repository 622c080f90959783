//! A topic, and its messages.

use bica_wire::model::{Description, Placement, Plain};

use super::super::{CompressedImage, Encoded, Kind, Names, ParameterValue, Ros, Time};

/// Quality of service of a topic.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quality {
    /// Sensor data: best effort.
    Sensor,
    /// Reliable.
    Reliable,
    /// Reliable, and kept for nodes that come later.
    Latched,
}

impl Quality {
    /// Returns the quality of service as the metadata of a bag have it: YAML, with a number for each choice.
    #[must_use]
    pub fn profile(self) -> String {
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
pub struct Topic {
    /// Absolute name.
    pub name: String,
    /// Source of its messages, for people.
    pub source: String,
    /// Type of its messages.
    pub kind: Kind,
    /// Quality of service.
    pub quality: Quality,
}

/// A message and the index of its topic.
pub type Sent = (usize, Encoded);

/// Returns the topic of the images in a frame.
pub(super) fn image_topic(names: &Names, frame: &str) -> Topic {
    let (name, source) = (names.camera(frame, "image_raw/compressed"), format!("the images in the frame `{frame}`"));
    Topic { name, source, kind: Kind::of::<CompressedImage>(), quality: Quality::Sensor }
}

/// Returns the visual types of all outputs.
pub(super) fn placements(description: &Description) -> impl Iterator<Item = &Placement> {
    description.components.iter().flat_map(|one| &one.outputs).filter_map(|output| output.placement.as_ref())
}

/// Returns a message of a topic.
pub(super) fn sent(topic: usize, message: &impl Ros) -> Vec<Sent> {
    vec![(topic, Encoded::from(message))]
}

/// Returns a time, ns, as ROS writes it.
pub(super) const fn stamp(time: u64) -> Time {
    Time { sec: (time / 1_000_000_000) as i32, nanosec: (time % 1_000_000_000) as u32 }
}

/// Returns the value of a parameter as ROS has it.
#[must_use]
pub fn parameter_value(plain: &Plain) -> ParameterValue {
    let empty = ParameterValue::default();
    match plain {
        Plain::Bool(is_on) => ParameterValue { r#type: 1, bool_value: *is_on, ..empty },
        Plain::Integer(number) => ParameterValue { r#type: 2, integer_value: *number, ..empty },
        Plain::Number(number) => ParameterValue { r#type: 3, double_value: *number, ..empty },
        Plain::Name(name) => ParameterValue { r#type: 4, string_value: name.clone(), ..empty },
    }
}
