//! Messages to the page.

use bica_drawing::layout::Kind;
use bica_link::{Description, Plain, Shown};
use bica_wire::message::LogLine;
use serde::Serialize;

use super::{
    Breakpoint, Build, Check, ComponentNow, Conditions, Costs, Hit, Limits, OutputSample, SessionId, SessionInfo,
    SourceChange, SourceState, World,
};

/// A message to the page.
#[derive(Clone, Debug, Serialize)]
#[serde(tag = "type", rename_all = "snake_case")]
#[expect(missing_docs, reason = "the fields are explained at their variants")]
pub enum ToPage {
    /// The first message: the [protocol](super::VERSION), the version of the program and the number of this page; whether pages may
    /// only watch, whether sources can be read and edited and whether programs can be built and run; the worlds that this program can
    /// simulate and all sessions.
    Hello {
        protocol: u32,
        program: &'static str,
        page: u64,
        read_only: bool,
        source: bool,
        build: bool,
        worlds: Vec<World>,
        sessions: Vec<SessionInfo>,
        limits: Limits,
    },
    /// A session was opened or has changed.
    Session { session: SessionInfo },
    /// A session was closed.
    Closed { session: SessionId },
    /// The tree of a session, with the current values of parameters and the kind of each component. It is sent before the data of
    /// the session, and again after a new connection or a restart. There are no kinds if the tree is too large to draw, or if links
    /// lead nowhere.
    Described { session: SessionId, description: Box<Description>, kinds: Vec<Kind> },
    /// The scenery of a session's world, sent after the tree.
    Scenery { session: SessionId, scenery: Vec<Shown> },
    /// State of the tree after the last cycle, about 30 times a second while it runs: time of the tick, µs, and number of the
    /// cycle; number of received images, and of cycles that ended after the next one was due; the components; and the changes since
    /// the last update in order of time, each with component, time, µs, active and state.
    Update {
        session: SessionId,
        time_us: u64,
        cycle: u64,
        images: u64,
        overruns: u64,
        components: Vec<ComponentNow>,
        changes: Vec<(usize, u64, bool, Option<u16>)>,
    },
    /// Values of watched outputs, in order of time.
    #[serde(rename = "info")]
    Output { session: SessionId, samples: Vec<OutputSample> },
    /// Conditions of the transitions of watched components.
    Conditions {
        session: SessionId,
        #[serde(flatten)]
        of: Conditions,
    },
    /// Execution times of the components and of the loop, about twice a second.
    Costs {
        session: SessionId,
        #[serde(flatten)]
        costs: Costs,
    },
    /// True state of a simulated world at a time in µs. It is never sent to a robot.
    Truth { session: SessionId, time_us: u64, truth: Vec<Shown> },
    /// Values of all parameters of a component in the order of the description, after a change.
    Params { session: SessionId, component: usize, values: Vec<Plain> },
    /// New lines of the log.
    Log { session: SessionId, lines: Vec<LogLine<String>> },
    /// The breakpoints of a session, after a change.
    Breakpoints { session: SessionId, list: Vec<Breakpoint> },
    /// A breakpoint was reached.
    Hit(Hit),
    /// A file that this page has opened.
    Source(Box<SourceState>),
    /// A file that this page has opened has changed.
    SourceChanged(Box<SourceChange>),
    /// Progress and result of a check.
    Check(Check),
    /// Progress of the program that is built and run.
    Build(Build),
    /// Answer to the message `id` of this page: the result, or the error.
    Answer {
        id: u32,
        #[serde(skip_serializing_if = "Option::is_none")]
        result: Option<serde_json::Value>,
        #[serde(skip_serializing_if = "Option::is_none")]
        error: Option<Failed>,
    },
}

/// Error: why a request was not executed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Failed {
    /// Text of the error.
    pub text: String,
    /// Remedy.
    pub help: String,
    /// Index of the setting or argument that was refused.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub entry: Option<usize>,
    /// Whether the request concerns an older version of a text, and can be sent again for the current one.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub stale: bool,
}
