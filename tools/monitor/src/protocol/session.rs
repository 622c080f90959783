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
    /// What the connection's state means, for people; empty if all is well.
    pub note: String,
    /// How the run ended, for people, such as `Goal at 16.68 s`; empty before.
    pub result: String,
    /// First time of which something is known, µs.
    pub from_us: u64,
    /// Last time of which something is known, µs.
    pub until_us: u64,
    /// Times between which nothing was received as the connection was lost, µs; the oldest first.
    pub gaps: Vec<(u64, u64)>,
    /// Whether a simulated world is paused.
    pub paused: bool,
    /// Who operates it.
    pub control: Control,
    /// What can be done with it.
    pub can: Capabilities,
    /// The recording that is made.
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
    /// It was lost and is being restored.
    Lost,
    /// It has ended and is not restored.
    Ended,
}

/// Who operates a session.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Control {
    /// Nobody.
    Free,
    /// The page that receives this.
    Yours,
    /// Another page of this server.
    OtherPage,
    /// Another monitor of the robot.
    OtherMonitor,
    /// Nobody can.
    Unavailable,
}

/// What can be done with a session.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[expect(clippy::struct_excessive_bools, reason = "each is an independent capability, a field of a JSON object")]
pub struct Capabilities {
    /// Requests: parameters, holds, rates, modulations, actions of the world.
    pub operate: bool,
    /// Pause and step, and restart if the world is of this process.
    pub pause: bool,
    /// The true state is known.
    pub truth: bool,
    /// Images come.
    pub images: bool,
    /// Costs come.
    pub costs: bool,
    /// Conditions of transitions come.
    pub conditions: bool,
    /// It can be run again with other parameters.
    pub run_again: bool,
}

/// The recording of a session: the run of a world of this process from its beginning, or the last minutes of a robot.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct RecordingState {
    /// Whether it is recorded.
    pub on: bool,
    /// First time that can be kept, µs.
    pub from_us: u64,
    /// Size, bytes.
    pub bytes: u64,
    /// Why it is not recorded, or what was lost; empty if all is well.
    pub note: String,
    /// File in which the session is recorded from its beginning; empty without `--record`.
    pub file: String,
}
