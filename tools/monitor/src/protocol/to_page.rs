//! Messages to the page.

use bica_drawing::layout::Kind;
use bica_link::{Description, Plain, Shown};
use serde::Serialize;

use super::{
    Breakpoint, Build, Check, ComponentNow, Conditions, Costs, Hit, InfoSample, LogLine, SessionId, SessionInfo,
    SourceChange, SourceState, World,
};

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
        /// Number of this page.
        page: u64,
        /// Whether pages may only watch.
        read_only: bool,
        /// Whether sources can be read and edited.
        source: bool,
        /// Whether programs can be built and run.
        build: bool,
        /// Worlds that this program can simulate.
        worlds: Vec<World>,
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
        /// Kind of each component; none of a tree that is too large to draw, or whose links lead nowhere.
        kinds: Vec<Kind>,
    },
    /// What does not move in the world of a session, sent after the tree.
    Scenery {
        /// Session.
        session: SessionId,
        /// The items.
        scenery: Vec<Shown>,
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
        /// The conditions.
        #[serde(flatten)]
        of: Conditions,
    },
    /// Time of the components and of the loop, about twice a second.
    Costs {
        /// Session.
        session: SessionId,
        /// The costs.
        #[serde(flatten)]
        costs: Costs,
    },
    /// True state of a simulated world. It is never sent to a robot.
    Truth {
        /// Session.
        session: SessionId,
        /// Time, µs.
        time_us: u64,
        /// The state.
        truth: Vec<Shown>,
    },
    /// Values of all parameters of a component, after a change.
    Params {
        /// Session.
        session: SessionId,
        /// Component.
        component: usize,
        /// Values in the order of the description.
        values: Vec<Plain>,
    },
    /// New lines of the log.
    Log {
        /// Session.
        session: SessionId,
        /// The lines.
        lines: Vec<LogLine>,
    },
    /// The breakpoints of a session, after a change.
    Breakpoints {
        /// Session.
        session: SessionId,
        /// The breakpoints.
        list: Vec<Breakpoint>,
    },
    /// A breakpoint was reached.
    Hit(Hit),
    /// A file that this page has opened.
    Source(Box<SourceState>),
    /// A file that this page has opened has changed.
    SourceChanged(Box<SourceChange>),
    /// Course and result of a check.
    Check(Check),
    /// Course of the program that is built and run.
    Build(Build),
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
    /// Whether the request is about an older version of a text, and can be sent again for the present one.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub stale: bool,
}
