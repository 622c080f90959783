//! Messages from the page.

use bica_wire::model::{NamedRequest, NamedSetting};
use serde::{Deserialize, Serialize};

use super::{Breakpoint, Open, SessionId, SourceRequest, Watch};

/// A message from the page, with the identifier of its answer.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FromPage {
    /// Chosen by the page, different for each message; not 0.
    pub id: u32,
    /// The session that the request is about, if it is about one.
    #[serde(default)]
    pub session: Option<SessionId>,
    /// The request.
    #[serde(flatten)]
    pub request: Request,
}

/// What the page asks for. In brackets: the `result` of the answer, if there is one. All but `Open`, `Recordings`, `Layouts`, `SaveLayout`
/// and `Source` are about the session of the message. Times, from `from_us` until `until_us`, are µs; a component, its information and its
/// parameters are indices of the description.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
#[expect(missing_docs, reason = "the fields are explained at their variants")]
pub enum Request {
    /// Shows a robot, a world or a recording. [`{"session": number}`]
    Open { source: Open },
    /// Closes a session.
    Close {},
    /// Replaces all that this page watches of a session.
    Watch { watch: Watch },
    /// Reads the state at a time: of the last cycle that is not later, with information, each by component and index.
    /// [[`Moment`](super::Moment); if `image`, a binary frame with the last image that is not later and this `id` comes before the answer]
    At { time_us: u64, info: Vec<(usize, usize)>, image: bool },
    /// Reads the activation timeline of an interval; bars and gaps shorter than the resolution may be merged. [list of [`Row`](super::Row)]
    Timeline { from_us: u64, until_us: u64, resolution_us: u64 },
    /// Reads samples of an output or of a parameter-like number, thinned to at most `points`. [list of `[time_us, value]`]
    Series { component: usize, info: usize, from_us: u64, until_us: u64, points: usize },
    /// Reads the last log lines of an interval, at most `limit`. [list of [`LogLine`](super::LogLine)]
    Lines { from_us: u64, until_us: u64, limit: usize },
    /// Becomes the operator of a session if nobody is.
    Acquire {},
    /// Becomes the operator instead of another one; only when a person asks for it.
    Take {},
    /// Gives control back: holds, rates and modulations end.
    Release {},
    /// Sent at least every 500 ms by a page that controls a session. After 3 s without it control ends.
    Keep {},
    /// Requests a change of the tree, or an action of its world.
    /// [`{"cycle": number, "values": list}`: first cycle with it, and effective values]
    Operate { request: NamedRequest },
    /// Stops the robot: calls all of its stops, whoever operates it, also from a page that may only watch. Control ends.
    /// [as `Operate`]
    Stop {},
    /// Pauses a simulated world between two cycles.
    Pause {},
    /// Continues a simulated world.
    Resume {},
    /// Runs a number of cycles of a paused simulated world.
    Step { cycles: u32 },
    /// Replaces the breakpoints of a session. A simulated world pauses at the cycle in which one is reached, a robot goes on. All
    /// pages get them as [`ToPage::Breakpoints`](super::ToPage::Breakpoints).
    Breakpoints { list: Vec<Breakpoint> },
    /// Searches the next time in memory, later than `from_us`, at which a breakpoint of the session is reached.
    /// [[`Reached`](super::Reached), or `null`]
    NextHit { from_us: u64 },
    /// Counts what a session has visited of a machine, as far as it is in memory: the component with the key
    /// `component` in a file below the folder of sources, and the index `index` in the session. [`bica_vicode::coverage::Coverage`]
    Coverage { file: String, component: String, index: usize },
    /// Begins a simulated world again, with another seed if given.
    Restart { seed: Option<u64> },
    /// Adds a note of the operator, at most 500 characters, to log, timeline and recording.
    Note { text: String },
    /// Keeps the recording of the last minutes under a name, without ending, in the recordings folder. [`{"path": text}`]
    KeepRecording { name: String },
    /// Keeps the cycles of a span under a name in the recordings folder: of a recording, or as `KeepRecording`. [`{"path": text}`]
    KeepSpan { name: String, from_us: u64, until_us: u64 },
    /// Lists the recordings in the recordings folder. [list of `{"name", "bytes", "seconds"}`]
    Recordings {},
    /// Writes changed parameters, each by component and index, to a tune file; its name without ending is a kind of world or a robot.
    /// [`{"path": text}`]
    SaveTune { params: Vec<(usize, usize)>, name: String },
    /// Writes a parameter as the new default to its Rust source. [`{"path": text, "diff": text}`]
    SaveSource { component: usize, param: usize },
    /// Lists where a parameter is declared and read in the sources. [list of [`SourceUse`](super::SourceUse)]
    ParamUses { component: usize, param: usize },
    /// Reads layouts of panels. [object from name to layout]
    Layouts {},
    /// Saves a layout of panels; `null` deletes it.
    SaveLayout { name: String, layout: serde_json::Value },
    /// Reads, edits, checks and runs the sources of VICODE.
    Source { request: SourceRequest },
    /// Compares the recording with that of another session. [`{"equal": bool, "cycle", "time_us", "field", "text"}`: the first difference]
    Compare { other: SessionId },
    /// Runs a recording again with other settings, as a new session. [`{"session": number}`]
    RunAgain { settings: Vec<NamedSetting> },
    /// Sends a message to the [extension](crate::program::Extension) of a name. [its answer]
    Extension { name: String, message: serde_json::Value },
}
