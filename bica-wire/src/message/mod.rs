//! The messages.
//!
//! Sensor values and commands have types of the robot. A program decodes them only if the hash of their schemas equals its own
//! ([`messages_hash`](crate::messages_hash)). Times are microseconds since the start of the world's clock.

mod diagnostics;
mod extra;
mod graph;
mod image;
mod monitor;
mod operator;
mod robot;
mod scene;
mod session;

use postcard_schema::Schema;
use serde::{Deserialize, Serialize};

pub use bica_core::Hold;
pub use bica_core::params::{Setting, Value};
pub use diagnostics::{FaultInjection, LinkStats, StackUsage, Telemetry};
pub use extra::{
    COSTS_CYCLES, ComponentCost, ComponentCosts, ConditionState, Conditions, Costs, ExtraKind, FromMonitorExtra,
    Happened, ImageHead, MAX_CONDITIONS, MAX_COSTS, Offers, Reached, Requested, Stop, StopAt, Taken, ToMonitorExtra,
    WorldChange, WorldRequest, WorldState,
};
pub use graph::GraphItem;
pub use image::{BlobsInfo, ImageChunk};
pub use monitor::{
    Attached, ComponentState, ComponentStates, CycleInfo, LogLine, LogSource, MAX_OUTPUT_BYTES, MAX_STATES,
    MAX_TEXT_BYTES, MAX_VALUES, OutputSchema, OutputValue, ParamValues, SCHEMA_PART_BYTES, Watch, WatchOutput,
};
pub use operator::{
    Answer, AnswerResult, Change, LeaseAction, LeaseState, MAX_ARGUMENTS, MAX_BATCH, RefusalCode, Request,
};
pub use robot::{Command, Sensors};
pub use scene::{SCENE_PART_BYTES, SceneContent, SceneDeclaration, SceneKind, ScenePart};
pub use session::{ClockMode, Hello, Identity};

/// A message from the host.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub enum ToRobot<'a> {
    /// Starts a game: the tree starts from its initial state, and the robot answers with its identity.
    #[serde(borrow)]
    Hello(Hello<'a>),
    /// Requests the graph of the robot's tree.
    Describe,
    /// A part of the large data of the next sensor values, such as an image.
    #[serde(borrow)]
    ImageChunk(ImageChunk<'a>),
    /// The current sensor values; sent after the chunks of their large data, if there is any.
    #[serde(borrow)]
    Sensors(Sensors<'a>),
    /// Injects a fault, for tests.
    FaultInjection(FaultInjection),
    /// Requests the stack usage.
    StackUsage,
    /// A [`FromMonitor`] in postcard's format. A robot without monitors does not decode it.
    Monitor(&'a [u8]),
    /// A [`FromMonitorExtra`] in postcard's format. Only a program on a computer decodes it.
    MonitorExtra(&'a [u8]),
}

impl ToRobot<'_> {
    /// Returns whether the message comes from the body or the world that the robot controls. Only such messages show that the
    /// robot still receives sensor values; a monitor's message must not prevent the safe stop.
    #[must_use]
    pub const fn is_from_body(&self) -> bool {
        matches!(self, Self::Hello(_) | Self::ImageChunk(_) | Self::Sensors(_))
    }
}

/// A message from the robot.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub enum FromRobot<'a> {
    /// The first message after a start, and the answer to [`ToRobot::Hello`].
    #[serde(borrow)]
    Identity(Identity<'a>),
    /// A part of the answer to [`ToRobot::Describe`].
    #[serde(borrow)]
    GraphItem(GraphItem<'a>),
    /// The command for the actuators.
    #[serde(borrow)]
    Command(Command<'a>),
    /// The report of a cycle.
    #[serde(borrow)]
    Telemetry(Telemetry<'a>),
    /// The answer to [`ToRobot::StackUsage`].
    StackUsage(StackUsage),
    /// A [`ToMonitor`] in postcard's format.
    Monitor(&'a [u8]),
    /// A [`ToMonitorExtra`] in postcard's format.
    MonitorExtra(&'a [u8]),
}

/// A message from a monitor. It never affects the game, except for [`Request`](Self::Request).
#[expect(clippy::large_enum_variant, reason = "there is no heap to box the request in")]
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub enum FromMonitor {
    /// Attaches. Changes nothing in the robot, unlike [`ToRobot::Hello`]; the robot answers with [`ToMonitor::Attached`] and
    /// the lease. Sent again, it shows that the monitor still exists.
    Attach,
    /// Sets how often snapshots are sent.
    Watch(Watch),
    /// Sets how often an output is sent.
    WatchOutput(WatchOutput),
    /// Requests the current values of all parameters.
    ReadParams,
    /// Acts on the lease.
    Lease(LeaseAction),
    /// Requests a change.
    Request(Request),
}

/// A message to a monitor.
#[expect(clippy::large_enum_variant, reason = "there is no heap to box the states in")]
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub enum ToMonitor<'a> {
    /// The answer to [`FromMonitor::Attach`].
    #[serde(borrow)]
    Attached(Attached<'a>),
    /// The beginning of a snapshot.
    Cycle(CycleInfo),
    /// A part of a snapshot.
    Components(ComponentStates),
    /// A value of an output.
    #[serde(borrow)]
    Output(OutputValue<'a>),
    /// A part of the schema of an output.
    #[serde(borrow)]
    OutputSchema(OutputSchema<'a>),
    /// Current values of parameters: the answer to [`FromMonitor::ReadParams`], and sent to every monitor after a change.
    Params(ParamValues),
    /// The lease.
    Lease(LeaseState),
    /// The answer to [`FromMonitor::Request`].
    #[serde(borrow)]
    Answer(Answer<'a>),
    /// A line of the log.
    #[serde(borrow)]
    Log(LogLine<&'a str>),
    /// The robot closes the connection.
    Closing {
        /// The reason, for people.
        reason: &'a str,
    },
}
