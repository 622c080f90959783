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
/// and `Source` are about the session of the message.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
pub enum Request {
    /// Shows a robot, a world or a recording. [`{"session": number}`]
    Open {
        /// What.
        source: Open,
    },
    /// Closes a session.
    Close {},
    /// Replaces all that this page watches of a session.
    Watch {
        /// What.
        watch: Watch,
    },
    /// Reads the state at a time: of the last cycle that is not later. [[`Moment`](super::Moment); if `image`, a binary
    /// frame with this `id` comes before the answer]
    At {
        /// Time, µs.
        time_us: u64,
        /// Information to read: component and index of each.
        info: Vec<(usize, usize)>,
        /// Whether the last image that is not later is sent as a binary frame.
        image: bool,
    },
    /// Reads the activation timeline of an interval. [list of [`Row`](super::Row)]
    Timeline {
        /// Begin, µs.
        from_us: u64,
        /// End, µs.
        until_us: u64,
        /// Bars and gaps shorter than this may be merged, µs.
        resolution_us: u64,
    },
    /// Reads samples of an output or of a parameter-like number, thinned to at most `points`. [list of `[time_us, value]`]
    Series {
        /// Component.
        component: usize,
        /// Information.
        info: usize,
        /// Begin, µs.
        from_us: u64,
        /// End, µs.
        until_us: u64,
        /// Largest number of samples.
        points: usize,
    },
    /// Reads log lines of an interval. [list of [`LogLine`](super::LogLine)]
    Lines {
        /// Begin, µs.
        from_us: u64,
        /// End, µs.
        until_us: u64,
        /// Largest number of lines; the last ones.
        limit: usize,
    },
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
    Operate {
        /// The request, with names.
        request: NamedRequest,
    },
    /// Pauses a simulated world between two cycles.
    Pause {},
    /// Continues a simulated world.
    Resume {},
    /// Runs cycles of a paused simulated world.
    Step {
        /// Number of cycles.
        cycles: u32,
    },
    /// Replaces the breakpoints of a session. A simulated world pauses at the cycle in which one is reached, a robot goes on. All
    /// pages get them as [`ToPage::Breakpoints`](super::ToPage::Breakpoints).
    Breakpoints {
        /// The breakpoints.
        list: Vec<Breakpoint>,
    },
    /// Searches the next time in memory at which a breakpoint of the session is reached. [[`Reached`](super::Reached), or `null`]
    NextHit {
        /// Time after which it is searched, µs.
        from_us: u64,
    },
    /// Counts what a session has visited of a machine, as far as it is in memory. [`bica_vicode::coverage::Coverage`]
    Coverage {
        /// File of the machine below the folder of sources.
        file: String,
        /// Key of its component.
        component: String,
        /// Index of the component in the session.
        index: usize,
    },
    /// Begins a simulated world again, with another seed if given.
    Restart {
        /// Seed.
        seed: Option<u64>,
    },
    /// Adds a note of the operator to log, timeline and recording.
    Note {
        /// Text, at most 500 characters.
        text: String,
    },
    /// Keeps the recording of the last minutes under a name in the recordings folder. [`{"path": text}`]
    KeepRecording {
        /// File name without folder and ending.
        name: String,
    },
    /// Keeps the cycles of a span under a name in the recordings folder: of a recording, or as `KeepRecording`. [`{"path": text}`]
    KeepSpan {
        /// File name without folder and ending.
        name: String,
        /// Begin, µs.
        from_us: u64,
        /// End, µs.
        until_us: u64,
    },
    /// Lists the recordings in the recordings folder. [list of `{"name", "bytes", "seconds"}`]
    Recordings {},
    /// Writes changed parameters to a tune file. [`{"path": text}`]
    SaveTune {
        /// Parameters: component and index of each.
        params: Vec<(usize, usize)>,
        /// Name of the tune file without ending: a kind of world or a robot.
        name: String,
    },
    /// Writes a parameter as the new default to its Rust source. [`{"path": text, "diff": text}`]
    SaveSource {
        /// Component.
        component: usize,
        /// Parameter.
        param: usize,
    },
    /// Lists where a parameter is declared and read in the sources. [list of [`SourceUse`](super::SourceUse)]
    ParamUses {
        /// Component.
        component: usize,
        /// Parameter.
        param: usize,
    },
    /// Reads layouts of panels. [object from name to layout]
    Layouts {},
    /// Saves a layout of panels.
    SaveLayout {
        /// Name.
        name: String,
        /// Layout; `null` deletes it.
        layout: serde_json::Value,
    },
    /// Reads, edits, checks and runs the sources of VICODE.
    Source {
        /// What.
        request: SourceRequest,
    },
    /// Compares two recordings. [`{"equal": bool, "cycle", "time_us", "field", "text"}`: the first difference]
    Compare {
        /// The other session.
        other: SessionId,
    },
    /// Runs a recording again with other parameters, as a new session. [`{"session": number}`]
    RunAgain {
        /// Settings.
        settings: Vec<NamedSetting>,
    },
    /// Sends a message to an [extension](crate::program::Extension). [its answer]
    Extension {
        /// Name of the extension.
        name: String,
        /// The message.
        message: serde_json::Value,
    },
}
