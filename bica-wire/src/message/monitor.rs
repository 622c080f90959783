//! Observation of a running robot.

use heapless::Vec;
use postcard_schema::Schema;
use serde::{Deserialize, Serialize};

use super::{Hold, Offers, Value};

/// Largest number of components in one [`ComponentStates`].
pub const MAX_STATES: usize = 32;
/// Largest number of values in one [`ParamValues`].
pub const MAX_VALUES: usize = 32;
/// Largest size of a value of an output in postcard's format, bytes. A larger one is not sent.
pub const MAX_OUTPUT_BYTES: usize = 1024;
/// Largest size of a part of a schema, bytes.
pub const SCHEMA_PART_BYTES: usize = 1024;
/// Largest size of the text of a [`LogLine`] and of a refusal, bytes. A longer one is cut.
pub const MAX_TEXT_BYTES: usize = 512;

/// The answer to [`FromMonitor::Attach`](super::FromMonitor::Attach): the program to which the monitor is attached.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub struct Attached<'a> {
    /// The robot's [`SCHEMA`](crate::SCHEMA).
    pub schema: u64,
    /// Hash of the tree without doc comments ([`Tree::HASH`](bica_core::Tree::HASH)): in trees with equal hashes every index has
    /// the same meaning.
    pub tree_hash: u64,
    /// Name of the tree.
    pub name: &'a str,
    /// Whether the robot's time advances with the clock. If not, an expiry in the robot's time is useless.
    pub realtime: bool,
    /// Silence of the operator after which its lease ends, ms.
    pub silence_ms: u32,
    /// Services that the robot's program offers.
    pub offers: Offers,
}

/// How often snapshots are sent to this monitor.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct Watch {
    /// A snapshot in every n-th cycle; 0: none.
    pub every: u16,
}

/// How often an output is sent to this monitor.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct WatchOutput {
    /// Index of the component.
    pub component: u16,
    /// Index of the output.
    pub output: u16,
    /// The value of every n-th cycle; 0: none.
    pub every: u16,
}

/// The beginning of a snapshot: the cycle to which the [`ComponentStates`] after it belong.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct CycleInfo {
    /// Number of the cycle since the start, from 0.
    pub cycle: u64,
    /// Instant of the tick in the robot's time, µs.
    pub time_us: u64,
    /// Number of sets of sensor values taken in since the start.
    pub sensed: u64,
    /// Number of images taken in since the start.
    pub images: u64,
    /// Number of cycles that ended after the next one was due.
    pub overruns: u64,
}

/// States of consecutive components in a snapshot.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub struct ComponentStates {
    /// Number of the cycle.
    pub cycle: u64,
    /// Index of the first component.
    pub first: u16,
    /// The states.
    pub states: Vec<ComponentState, MAX_STATES>,
}

/// State of a component after a cycle.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub struct ComponentState {
    /// Whether it was visited in this cycle.
    pub active: bool,
    /// Its hold.
    pub held: Hold,
    /// Index of its state, also while it is latent; none without states.
    pub state: Option<u16>,
    /// Requested rate, Hz; none: every cycle.
    pub hz: Option<f32>,
}

/// A value of an output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct OutputValue<'a> {
    /// Number of the cycle after which it was read.
    pub cycle: u64,
    /// Index of the component.
    pub component: u16,
    /// Index of the output.
    pub output: u16,
    /// The value in postcard's format; none if it is larger than [`MAX_OUTPUT_BYTES`].
    pub bytes: Option<&'a [u8]>,
}

/// A part of the schema of an output: a `NamedType` of postcard-schema in postcard's format. A program on a computer sends the
/// schemas of all outputs before the values of parameters. A microcontroller sends a schema before the first value of its output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct OutputSchema<'a> {
    /// Index of the component.
    pub component: u16,
    /// Index of the output.
    pub output: u16,
    /// Whether this is the last part.
    pub last: bool,
    /// The part.
    pub bytes: &'a [u8],
}

/// Current values of consecutive parameters of a component.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub struct ParamValues {
    /// Number of the cycle after which they were read.
    pub cycle: u64,
    /// Index of the component.
    pub component: u16,
    /// Index of the first parameter.
    pub first: u16,
    /// The values; none for a kind that this version of the protocol does not know.
    pub values: Vec<Option<Value>, MAX_VALUES>,
}

/// Origin of a line of the log.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, Schema)]
#[serde(rename_all = "snake_case")]
pub enum LogSource {
    /// The robot.
    Robot,
    /// The world, such as its referee.
    World,
    /// An operator: requests, and the reasons for refusals.
    Operator,
    /// A note of a person.
    Note,
    /// A monitor: connection, recording.
    Monitor,
}

/// A line of the robot's log, with its text as `T`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct LogLine<T> {
    /// Time in the robot's time, µs.
    pub time_us: u64,
    /// 1 debug, 2 information, 3 warning, 4 error.
    pub level: u8,
    /// Origin.
    pub source: LogSource,
    /// The text; in a message at most [`MAX_TEXT_BYTES`].
    pub text: T,
}
