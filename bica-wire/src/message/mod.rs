//! The messages.
//!
//! Units and frames are those of [`bica_motion::robot`]: radians, newtons, m/s², the torso frame. Times are microseconds
//! since the start of the world's clock.

mod diagnostics;
mod graph;
mod image;
mod robot;
mod session;

use postcard_schema::Schema;
use serde::{Deserialize, Serialize};

pub use diagnostics::{FaultInjection, LinkStats, StackUsage, Telemetry};
pub use graph::GraphItem;
pub use image::{ImageChunk, ImageInfo};
pub use robot::{Command, Sensors};
pub use session::{ClockMode, Hello, Identity};

/// A message from the host.
#[expect(clippy::large_enum_variant, reason = "there is no heap to box the sensors in")]
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub enum ToRobot<'a> {
    /// Starts a game: the tree starts from its initial state, and the robot answers with its identity.
    Hello(Hello),
    /// Requests the graph of the robot's tree.
    Describe,
    /// A part of the next image.
    #[serde(borrow)]
    ImageChunk(ImageChunk<'a>),
    /// The current sensor values; sent after the chunks of the image, if there is a new one.
    Sensors(Sensors),
    /// Injects a fault, for tests.
    FaultInjection(FaultInjection),
    /// Requests the stack usage.
    StackUsage,
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
    /// The command for joints, lights and cameras.
    Command(Command),
    /// The report of a cycle.
    #[serde(borrow)]
    Telemetry(Telemetry<'a>),
    /// The answer to [`ToRobot::StackUsage`].
    StackUsage(StackUsage),
}
