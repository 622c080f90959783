//! Messages from the page.

use bica_wire::model::{NamedRequest, NamedSetting};
use serde::{Deserialize, Serialize};

use super::{Arrange, Breakpoint, Open, SessionId, SourceRequest, Watch};

/// A message from the page, with the identifier of its answer.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FromPage {
    /// Identifier of the message: chosen by the page, different for each message, not 0.
    pub id: u32,
    /// Session that the request concerns, if any.
    #[serde(default)]
    pub session: Option<SessionId>,
    /// The request.
    #[serde(flatten)]
    pub request: Request,
}

/// A request of the page. In brackets: the `result` of the answer, if there is one. All but `Open`, `Recordings`, `Arrange`,
/// `Layouts`, `SaveLayout` and `Source` concern the session of the message. Times, from `from_us` until `until_us`, are µs.
/// Components, outputs and parameters are indices of the description.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
#[expect(missing_docs, reason = "the fields are explained at their variants")]
pub enum Request {
    /// Shows a robot, a world or a recording. [`{"session": number}`]
    Open { source: Open },
    /// Closes a session.
    Close {},
    /// Replaces the data that this page watches in a session.
    Watch { watch: Watch },
    /// Reads the state after the last cycle that is not later than `time_us`, with outputs, each by component and index.
    /// [[`Moment`](super::Moment); if `image`, a binary frame with the last image that is not later and this `id` precedes the answer]
    At {
        time_us: u64,
        #[serde(rename = "info")]
        outputs: Vec<(usize, usize)>,
        image: bool,
    },
    /// Reads the activation timeline of an interval; bars and gaps shorter than the resolution may be merged. [list of [`Row`](super::Row)]
    Timeline { from_us: u64, until_us: u64, resolution_us: u64 },
    /// Reads samples of an output, thinned to at most `points`. [list of `[time_us, value]`]
    Series {
        component: usize,
        #[serde(rename = "info")]
        output: usize,
        from_us: u64,
        until_us: u64,
        points: usize,
    },
    /// Reads the last log lines of an interval, at most `limit`. [list of [`LogLine`](bica_wire::message::LogLine)]
    Lines { from_us: u64, until_us: u64, limit: usize },
    /// Makes the page the operator of a session, unless there is another one.
    Acquire {},
    /// Makes the page the operator in place of another one. It is sent only if a person asks for it.
    Take {},
    /// Gives control back: holds, rates and modulations end.
    Release {},
    /// Keeps control. A page that controls a session sends it at least every 500 ms. Control ends 3 s after the last `Acquire`,
    /// `Take`, `Keep` or `Operate`.
    Keep {},
    /// Requests a change of the tree, or an action of its world.
    /// [`{"cycle": number, "values": list}`: first cycle with the change, and effective values]
    Operate { request: NamedRequest },
    /// Stops the robot: calls all of its stops. It needs no control, and pages that may only watch may send it, too. Control of the
    /// operator ends.
    /// [as `Operate`]
    Stop {},
    /// Pauses a simulated world between two cycles.
    Pause {},
    /// Continues a simulated world.
    Resume {},
    /// Runs a number of cycles of a paused simulated world.
    Step { cycles: u32 },
    /// Replaces the breakpoints of a session. A simulated world pauses at the cycle in which a breakpoint is reached; a robot
    /// continues. All pages receive the list as [`ToPage::Breakpoints`](super::ToPage::Breakpoints).
    Breakpoints { list: Vec<Breakpoint> },
    /// Finds the first time in memory, later than `from_us`, at which a breakpoint of the session is reached.
    /// [[`Reached`](super::Reached), or `null`]
    NextHit { from_us: u64 },
    /// Computes the coverage of a state machine by the session's history. The machine has the key `component` in a file below the
    /// folder of sources, and the index `index` in the session.
    /// [`bica_vicode::coverage::Coverage`]
    Coverage { file: String, component: String, index: usize },
    /// Restarts a simulated world, with another seed if given.
    Restart { seed: Option<u64> },
    /// Adds a note of the operator, at most 500 characters, to log, timeline and recording.
    Note { text: String },
    /// Keeps the recording of a world's run, or of the last minutes of a robot, in the recordings folder under a name without ending.
    /// [`{"path": text}`]
    KeepRecording { name: String },
    /// Keeps the cycles of a span in the recordings folder under a name: cycles of a recording, or of what `KeepRecording` keeps.
    /// [`{"path": text}`]
    KeepSpan { name: String, from_us: u64, until_us: u64 },
    /// Lists the recordings in the recordings folder. [list of `{"name", "bytes", "seconds"}`]
    Recordings {},
    /// Writes the values of parameters, each by component and index, to a tune file. Its name without ending is a kind of world or a robot.
    /// [`{"path": text}`]
    SaveTune { params: Vec<(usize, usize)>, name: String },
    /// Writes the value of a parameter to its Rust source as the new default. [`{"path": text, "diff": text}`]
    SaveSource { component: usize, param: usize },
    /// Lists where a parameter is declared and read in the sources. [list of [`SourceUse`](super::SourceUse)]
    ParamUses { component: usize, param: usize },
    /// Lays a drawing out. [[`Arrange::answer`]]
    Arrange { drawing: Arrange },
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
    /// Sends a message to the [extension](crate::program::Extension) with this name. [its answer]
    Extension { name: String, message: serde_json::Value },
}
