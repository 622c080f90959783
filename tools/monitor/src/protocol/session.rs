//! Sessions: robots, worlds and recordings.

use serde::Serialize;

use super::SessionId;

/// A session.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SessionInfo {
    /// Identifier.
    pub id: SessionId,
    /// Kind.
    pub kind: SessionKind,
    /// Name for people: world and seed, address, or file.
    pub name: String,
    /// Seed of a world of this process.
    pub seed: Option<u64>,
    /// State of the connection.
    pub connection: Connection,
    /// Explanation of the connection's state, for people; empty if there is no problem.
    pub note: String,
    /// How the run ended, for people, such as `Goal at 16.68 s`; empty before.
    pub result: String,
    /// First time in the history, µs.
    pub from_us: u64,
    /// Last time in the history, µs.
    pub until_us: u64,
    /// Gaps in which nothing was received because the connection was lost: begin and end, µs; the oldest first.
    pub gaps: Vec<(u64, u64)>,
    /// Whether a simulated world is paused.
    pub paused: bool,
    /// Operator of the session.
    pub control: Control,
    /// Supported operations and data.
    pub can: Capabilities,
    /// State of its recording.
    pub recording: RecordingState,
}

/// Kind of a session.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum SessionKind {
    /// A simulated world in this process.
    World,
    /// A robot behind a link.
    Robot,
    /// A recording.
    Recording,
}

/// State of a connection.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Connection {
    /// The first connection is being made.
    #[default]
    Connecting,
    /// Data arrive, or the recording is open.
    Connected,
    /// The connection was lost and is being restored.
    Lost,
    /// The connection has ended and is not restored.
    Ended,
}

/// Operator of a session.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Control {
    /// No operator.
    Free,
    /// The page that receives this message.
    Yours,
    /// Another page of this server.
    OtherPage,
    /// Another monitor of the robot.
    OtherMonitor,
    /// The session cannot be operated.
    Unavailable,
}

/// Supported operations and data of a session.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[expect(clippy::struct_excessive_bools, reason = "each is an independent capability, a field of a JSON object")]
pub struct Capabilities {
    /// Requests: parameters, holds, rates, modulations, actions of the world.
    pub operate: bool,
    /// Pause and step; for a world of this process also restart.
    pub pause: bool,
    /// True state of the world.
    pub truth: bool,
    /// Images.
    pub images: bool,
    /// Costs.
    pub costs: bool,
    /// Conditions of transitions.
    pub conditions: bool,
    /// Another run of the recording with other parameters.
    pub run_again: bool,
}

/// The recording of a session: the run of a world of this process from its beginning, or the last minutes of a robot.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct RecordingState {
    /// Whether the session is recorded.
    pub on: bool,
    /// First time that can be kept, µs.
    pub from_us: u64,
    /// Size, bytes.
    pub bytes: u64,
    /// Why the session is not recorded, or which data were lost; empty if there is no problem.
    pub note: String,
    /// File in which the session is recorded from its beginning; empty without `--record`.
    pub file: String,
}
