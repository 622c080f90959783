//! Messages to the page.

use bica_link::Description;
use serde::Serialize;

use super::{HoldKind, SessionId};

/// A message to the page.
#[derive(Clone, Debug, Serialize)]
#[serde(tag = "type", rename_all = "snake_case")]
pub enum ToPage {
    /// The first message.
    Hello {
        /// [`VERSION`](super::VERSION).
        protocol: u32,
        /// Version of the program.
        program: &'static str,
        /// Whether pages may only watch.
        read_only: bool,
        /// Whether sources can be read and edited.
        source: bool,
        /// Whether programs can be built and run.
        build: bool,
        /// All sessions.
        sessions: Vec<SessionInfo>,
    },
    /// A session is new, or something of it changed.
    Session {
        /// The session.
        session: SessionInfo,
    },
    /// A session was closed.
    Closed {
        /// Session.
        session: SessionId,
    },
    /// The tree of a session, sent before anything else of it, and again when another robot has come.
    Described {
        /// Session.
        session: SessionId,
        /// The tree, with the current values of parameters.
        description: Box<Description>,
        /// Where components and links are drawn.
        drawing: Drawing,
    },
    /// State of the tree after the last cycle, about 30 times a second while it runs.
    Update {
        /// Session.
        session: SessionId,
        /// Time of the tick, µs.
        time_us: u64,
        /// Number of the cycle.
        cycle: u64,
        /// Number of images taken in.
        images: u64,
        /// Number of cycles that ended after the next one was due.
        overruns: u64,
        /// State of each component.
        components: Vec<ComponentNow>,
        /// Components that changed since the last update, each with time, active, state. In order of time.
        changes: Vec<(usize, u64, bool, Option<u16>)>,
    },
    /// Values of watched information.
    Info {
        /// Session.
        session: SessionId,
        /// The samples, in order of time.
        samples: Vec<InfoSample>,
    },
    /// Conditions of the transitions of watched components.
    Conditions {
        /// Session.
        session: SessionId,
        /// Component.
        component: usize,
        /// Time, µs.
        time_us: u64,
        /// One for each transition of the component.
        conditions: Vec<Condition>,
    },
    /// Time of the components and of the loop, about twice a second.
    Costs {
        /// Session.
        session: SessionId,
        /// Time, µs.
        time_us: u64,
        /// Time since the last costs, µs.
        window_us: u64,
        /// One for each component.
        components: Vec<ComponentCost>,
        /// Mean and largest duration of a cycle from sensor values to command, µs.
        chain_us: (f32, f32),
        /// Time of the worst cycle in the window, µs.
        worst_us: u64,
    },
    /// True state of a simulated world. It is never sent to a robot.
    Truth {
        /// Session.
        session: SessionId,
        /// Time, µs.
        time_us: u64,
        /// The state.
        truth: Truth,
    },
    /// Values of all parameters of a component, after a change.
    Params {
        /// Session.
        session: SessionId,
        /// Component.
        component: usize,
        /// Values in the order of the description.
        values: Vec<serde_json::Value>,
    },
    /// New lines of the log.
    Log {
        /// Session.
        session: SessionId,
        /// The lines.
        lines: Vec<LogLine>,
    },
    /// Answer to a message of this page.
    Answer {
        /// `id` of the message.
        id: u32,
        /// The result, if it was done.
        #[serde(skip_serializing_if = "Option::is_none")]
        result: Option<serde_json::Value>,
        /// Why it was not done.
        #[serde(skip_serializing_if = "Option::is_none")]
        error: Option<Failed>,
    },
}

/// Why a request was not done.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Failed {
    /// What went wrong.
    pub text: String,
    /// How to mend it.
    pub help: String,
    /// Index of the setting or argument that was refused.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub entry: Option<usize>,
}

/// A session.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SessionInfo {
    /// Identifier.
    pub id: SessionId,
    /// Kind.
    pub kind: SessionKind,
    /// Name for people: world and seed, address, or file.
    pub name: String,
    /// State of the connection.
    pub connection: Connection,
    /// What the connection's state means, for people; empty if all is well.
    pub note: String,
    /// First time of which something is known, µs.
    pub from_us: u64,
    /// Last time of which something is known, µs.
    pub until_us: u64,
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
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Connection {
    /// The first connection is being made.
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
    /// Requests: parameters, holds, rates, modulations.
    pub operate: bool,
    /// Pause, step and restart.
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

/// The recording of a session: a ring of the last minutes.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct RecordingState {
    /// Whether it is recorded.
    pub on: bool,
    /// First time in the ring, µs.
    pub from_us: u64,
    /// Size, bytes.
    pub bytes: u64,
    /// Why it is not recorded, or what was lost; empty if all is well.
    pub note: String,
}

/// State of a component, in JSON a list.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ComponentNow(
    /// Whether it was visited in the last cycle.
    pub bool,
    /// How it is held.
    pub HoldKind,
    /// Index of its state, also of a latent one.
    pub Option<u16>,
    /// Requested rate, Hz; none: every cycle.
    pub Option<f32>,
    /// Time since which it has been in this state, or active or latent, µs.
    pub u64,
);

/// A value of information, in JSON a list.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct InfoSample(
    /// Component.
    pub usize,
    /// Information.
    pub usize,
    /// Time, µs.
    pub u64,
    /// Value; `null` for `None`.
    pub serde_json::Value,
);

/// The condition of a transition as it was evaluated last.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Condition {
    /// Whether it was true; none if it was not evaluated in this state.
    pub holds: Option<bool>,
    /// Time since which it has had this value, µs.
    pub since_us: u64,
    /// Rest of the transition's timer, ms; none without a timer or in another state.
    pub remaining_ms: Option<u32>,
}

/// Time of a component, in JSON a list.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ComponentCost(
    /// Number of runs in the window.
    pub u32,
    /// Mean time of a run, µs.
    pub f32,
    /// Longest time of a run, µs.
    pub f32,
);

/// True state of a simulated world, field frame: origin in the middle, x to the attacked goal, y to the left, m and rad.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Truth {
    /// The robot.
    pub robot: RobotPose,
    /// The ball: x, y.
    pub ball: (f32, f32),
    /// Other robots: x, y.
    pub others: Vec<(f32, f32)>,
    /// Pose of the robot when its odometry began.
    pub start: RobotPose,
    /// Whether the attacked goal is blue, else yellow.
    pub attacks_blue: bool,
}

/// Pose on the field, in JSON a list: x, y in m, heading in rad.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct RobotPose(pub f32, pub f32, pub f32);

/// A line of the log.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct LogLine {
    /// Time, µs.
    pub time_us: u64,
    /// 1 debug, 2 information, 3 warning, 4 error.
    pub level: u8,
    /// Kind.
    pub kind: LogKind,
    /// Text.
    pub text: String,
    /// The component that it is about.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub component: Option<usize>,
}

/// Kind of a log line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum LogKind {
    /// Of the robot.
    Robot,
    /// Of the referee.
    Referee,
    /// A request and its answer.
    Request,
    /// A change of the tree.
    Tree,
    /// A note of an operator.
    Note,
    /// Of this server: connection, recording.
    Server,
}

/// State at a time.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Moment {
    /// Time of the cycle, µs.
    pub time_us: u64,
    /// Number of the cycle.
    pub cycle: u64,
    /// State of each component.
    pub components: Vec<ComponentNow>,
    /// The requested information, as the last sample that is not later.
    pub info: Vec<InfoSample>,
    /// Number of the image, if there is one.
    pub image: Option<u32>,
    /// True state, if it is known.
    pub truth: Option<Truth>,
}

/// Activity of a component in an interval.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// Component.
    pub component: usize,
    /// Times in which it was active.
    pub bars: Vec<Bar>,
    /// Times of overruns, µs.
    pub overruns: Vec<u64>,
}

/// A time in which a component was active in one state, in JSON a list.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Bar(
    /// Begin, µs.
    pub u64,
    /// End, µs; of the session if it is active now.
    pub u64,
    /// State; none without states, or if states were merged.
    pub Option<u16>,
);

/// Where a tree is drawn, px.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Drawing {
    /// Width.
    pub width: f32,
    /// Height.
    pub height: f32,
    /// One box for each component.
    pub boxes: Vec<DrawnBox>,
    /// One for each link, in the order of the description: component by component.
    pub links: Vec<DrawnLink>,
}

/// Box of a component: centre x, upper y; width and height are the same for all.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DrawnBox {
    /// Centre, px.
    pub x: f32,
    /// Upper edge, px.
    pub y: f32,
    /// `machine`, `controller`, `perception` or `actuation`.
    pub kind: String,
}

/// A drawn link.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DrawnLink {
    /// Activating component.
    pub from: usize,
    /// Activated component.
    pub to: usize,
    /// Path in SVG's notation.
    pub path: String,
}
