//! Requests about sources.

use bica_vicode::draw::Format;
use bica_vicode::model::Span;
use bica_vicode::trial::Step;
use bica_vicode::{Edit, Keep, Note};
use serde::{Deserialize, Serialize};

/// A request about sources. In brackets: the `result` of the answer, if there is one. A `file` is a path below the folder of
/// `--source`, with `/` between its parts; a component is named by its key. Offsets are bytes of UTF-8.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
#[expect(missing_docs, reason = "the fields are explained at their variants")]
pub enum SourceRequest {
    /// Lists the files with components or trees. [list of [`SourceFile`](super::SourceFile)]
    Sources {},
    /// Lists the tables of constants whose rows have one of these types, named without paths. [list of [`SourceTable`](super::SourceTable)]
    Tables { types: Vec<String> },
    /// Opens a file. From now on the page receives its messages, first a [`ToPage::Source`](super::ToPage::Source).
    OpenFile { file: String },
    /// Ends the messages about a file. Unsaved changes are still saved.
    CloseFile { file: String },
    /// Applies edits as one step of the history, all or none. Edits by name apply to any version, `replace` only to `version`.
    /// [`{"version": number}`]
    EditFile { file: String, version: u64, edits: Vec<Edit> },
    /// Undoes the last step. [`{"version": number}`]
    UndoFile { file: String },
    /// Redoes the last undone step. [`{"version": number}`]
    RedoFile { file: String },
    /// Saves a file at once. A deleted file is created again.
    SaveFile { file: String },
    /// Resolves a conflict. [`{"version": number}`]
    ResolveFile { file: String, keep: Keep },
    /// Moves states on the canvas. The positions are written to the layout file at once.
    MoveStates { file: String, positions: Vec<MovedState> },
    /// Removes the stored positions of a component's states. [`{"positions": list of` [`StatePosition`](super::StatePosition)`}`]
    ArrangeStates { file: String, component: String },
    /// Replaces a note on the canvas: `from` none adds one, `to` none removes it. It is written to the layout file at once.
    ChangeNote { file: String, component: String, from: Option<Note>, to: Option<Note> },
    /// Lists uses of a function of a component in other files. [list of [`SourceUse`](super::SourceUse)]
    Uses { file: String, component: String, function: String },
    /// Renames a function in its file, like the edit `rename`, and at chosen places of other files. The places are those that
    /// `Uses` lists, and include all certain ones. Undo in one file undoes the change in all files.
    /// [`{"files": [{"file", "version"}]}`]
    RenameUses { file: String, component: String, function: String, to: String, places: Vec<SourcePlace> },
    /// Creates a component with a name such as `WallFinder`: its file in `folder` (empty: the folder of sources), its `mod` line,
    /// and its entry in the `activation_tree!` of the file `tree`. That file imports the component from the module `import`, such
    /// as `crate::behaviour`. With `dry` only the differences are returned.
    /// [`{"file": text, "files": [{"file", "diff"}]}`]
    NewComponent { name: String, folder: String, tree: Option<String>, import: Option<String>, dry: bool },
    /// Draws a machine. [`{"text": text}`, or of a PNG `{"base64": text}`]
    DrawFile { file: String, component: String, format: Format },
    /// Finds edits that fix the mistakes of a file. [`{"version": number, "fixes": list for each mistake of `{"label", "edit"}`}`]
    Fixes { file: String },
    /// Compares a file with its last commit. [`{"revision": text, "new": bool, "report": text, "comparison", "both": object from component
    /// to its model with what was removed}`]
    CompareFile { file: String },
    /// Evaluates a trial of a machine from its beginning. [`{"trial", "test": text}`]
    TryMachine { file: String, component: String, steps: Vec<Step> },
    /// Checks the packages of the open files with the compiler. Results come as [`ToPage::Check`](super::ToPage::Check).
    Check {},
    /// Builds the program and runs it with `robots` other robots, in place of the running program. Results come as
    /// [`ToPage::Build`](super::ToPage::Build).
    Run { seed: u64, robots: usize },
    /// Ends a build and the running program.
    StopRun {},
}

/// New centre of a state on the canvas, points.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MovedState {
    /// Component.
    pub component: String,
    /// State.
    pub state: String,
    /// Horizontal coordinate, to the right.
    pub x: i32,
    /// Vertical coordinate, down.
    pub y: i32,
}

/// A place in a file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SourcePlace {
    /// File.
    pub file: String,
    /// Span in the file.
    pub span: Span,
}
