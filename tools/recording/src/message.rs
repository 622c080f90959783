//! Channels of a recording and their messages.

use bica::Hold;
use bica_wire::message::LogSource;
use bica_wire::model::Description;
use postcard_schema::Schema;
use postcard_schema::schema::NamedType;
use serde::{Deserialize, Serialize};

use crate::blob::BlobRecord;
use crate::outputs::OutputsRecord;
use crate::request::RequestRecord;

/// Encoding of the messages in a file.
pub(crate) const ENCODING: &str = "cdr";
/// Key of the schema of a message's content, in the metadata of its channel.
pub(crate) const SCHEMA_KEY: &str = "postcard_schema";

/// Channel of a recording.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Channel {
    /// [`RequestRecord`]: a request was applied before the cycle.
    Requests,
    /// [`BlobRecord`]: large data in the sensor values of a cycle.
    Blobs,
    /// The sensor values of the cycle without their large data, as [`bica_wire::blobs`] encodes them.
    Sensors,
    /// The command of the cycle in postcard's format.
    Command,
    /// [`TreeRecord`]: active components and states, if they changed in the cycle.
    Tree,
    /// [`Tick`]: instant and digests of the cycle; its last message.
    Tick,
    /// [`RunEvent`]: an event of the run.
    Events,
    /// [`LogLine`]: a line of text.
    Log,
    /// [`Costs`]: time of the components.
    Costs,
    /// [`OutputsRecord`]: outputs of the active components.
    Outputs,
    /// [`HoldsRecord`]: holds and rates, if they changed in the cycle; only in a recording of a monitor.
    Holds,
}

impl Channel {
    /// All channels, in the order of their numbers from 1 on.
    pub const ALL: [Self; 11] = [
        Self::Requests,
        Self::Blobs,
        Self::Sensors,
        Self::Command,
        Self::Tree,
        Self::Tick,
        Self::Events,
        Self::Log,
        Self::Costs,
        Self::Outputs,
        Self::Holds,
    ];

    /// Returns the number of the channel and of its schema in the file.
    #[must_use]
    pub const fn id(self) -> u16 {
        self as u16 + 1
    }

    /// Returns the channel of a number.
    #[must_use]
    pub fn of_id(id: u16) -> Option<Self> {
        Self::ALL.get(usize::from(id).checked_sub(1)?).copied()
    }

    /// Returns the topic in a file.
    #[must_use]
    pub const fn topic(self) -> &'static str {
        match self {
            Self::Requests => "/bica/requests",
            Self::Blobs => "/bica/blobs",
            Self::Sensors => "/bica/sensors",
            Self::Command => "/bica/command",
            Self::Tree => "/bica/tree",
            Self::Tick => "/bica/tick",
            Self::Events => "/bica/events",
            Self::Log => "/bica/log",
            Self::Costs => "/bica/costs",
            Self::Outputs => "/bica/information",
            Self::Holds => "/bica/holds",
        }
    }

    /// Returns the name: the last part of the topic.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.topic().trim_start_matches("/bica/")
    }

    /// Returns the schema of the messages; none if it is the robot's own.
    #[must_use]
    pub const fn schema(self) -> Option<&'static NamedType> {
        Some(match self {
            Self::Requests => RequestRecord::SCHEMA,
            Self::Blobs => BlobRecord::SCHEMA,
            Self::Sensors | Self::Command => return None,
            Self::Tree => TreeRecord::SCHEMA,
            Self::Tick => Tick::SCHEMA,
            Self::Events => RunEvent::SCHEMA,
            Self::Log => LogLine::SCHEMA,
            Self::Costs => Costs::SCHEMA,
            Self::Outputs => OutputsRecord::SCHEMA,
            Self::Holds => HoldsRecord::SCHEMA,
        })
    }
}

/// Active components and states after a cycle.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct TreeRecord {
    /// One bit for each component, from the lowest bit of the first byte on: whether it is active.
    pub active: Vec<u8>,
    /// One byte for each component: the index of its state, 255 without a state machine.
    pub states: Vec<u8>,
}

/// Holds and rates after a cycle. In the recording of a robot's own program they follow from the requests.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, Schema)]
pub struct HoldsRecord {
    /// Hold of each component.
    pub holds: Vec<Hold>,
    /// For each component the rate in force, Hz; none: every cycle.
    pub rates: Vec<Option<f32>>,
}

/// Instant and digests of a cycle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct Tick {
    /// Number of the cycle, from 0.
    pub cycle: u64,
    /// Instant that the tree was given, ticks.
    pub instant: u64,
    /// CRC-32 of the message `sensors`.
    pub sensors: u32,
    /// CRC-32 of the large data of the cycle, one after the other; 0 without any.
    pub blobs: u32,
    /// CRC-32 of the message `command`.
    pub command: u32,
    /// CRC-32 of active components and states.
    pub tree: u32,
    /// FNV-1a hash (64 bits) of the requests and of all fields above of all cycles up to this one.
    pub fingerprint: u64,
}

/// An event of the run, such as a goal or a fall.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct RunEvent {
    /// Time since the start of the run, ns.
    pub at_ns: u64,
    /// Kind, such as `goal` or `kick`.
    pub kind: String,
    /// Details, as text.
    pub detail: String,
}

/// A line of text.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct LogLine {
    /// 2: information, 3: warning, 4: error.
    pub level: u8,
    /// Origin.
    pub source: LogSource,
    /// The text.
    pub text: String,
}

/// Time of the components since the last message of this kind.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct Costs {
    /// One entry for each component.
    pub components: Vec<ComponentCosts>,
}

/// Time of one component.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct ComponentCosts {
    /// Number of runs.
    pub runs: u32,
    /// Time in its own code, ns.
    pub ns: u64,
}

impl TreeRecord {
    /// Returns whether a component is active.
    #[must_use]
    pub fn is_active(&self, component: usize) -> bool {
        self.active.get(component / 8).is_some_and(|byte| byte >> (component % 8) & 1 == 1)
    }

    /// Returns the index of a component's state.
    #[must_use]
    pub fn state(&self, component: usize) -> Option<usize> {
        self.states.get(component).filter(|state| **state != u8::MAX).map(|state| usize::from(*state))
    }

    /// Returns the name of each component's state: `active` if it has no states, `latent` if it is latent.
    pub(crate) fn names(&self, tree: &Description) -> Vec<String> {
        let name = |index| {
            if self.is_active(index) { tree.state(index, self.state(index)).unwrap_or("active") } else { "latent" }
        };
        (0..tree.components.len()).map(|index| name(index).to_owned()).collect()
    }

    /// Returns the CRC-32 of the contents.
    #[must_use]
    pub fn digest(&self) -> u32 {
        let mut hash = crc32fast::Hasher::new();
        hash.update(&self.active);
        hash.update(&self.states);
        hash.finalize()
    }
}
