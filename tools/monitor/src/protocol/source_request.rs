//! Requests about sources.

use bica_vicode::model::Span;
use bica_vicode::trial::Step;
use bica_vicode::{Edit, Note};
use serde::{Deserialize, Serialize};

/// What a page asks of the sources. In brackets: the `result` of the answer, if there is one. A `file` is a path below the folder of
/// `--source`, with `/` between its parts. Offsets are bytes of UTF-8.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
pub enum SourceRequest {
    /// Lists the files with components or trees. [list of [`SourceFile`](super::SourceFile)]
    Sources {},
    /// Lists the tables of constants with rows of certain types. [list of [`SourceTable`](super::SourceTable)]
    Tables {
        /// Types of rows, without paths.
        types: Vec<String>,
    },
    /// Opens a file. The page gets its messages from now on, first a [`ToPage::Source`](super::ToPage::Source).
    OpenFile {
        /// File.
        file: String,
    },
    /// Ends the messages of a file. What was not saved is still saved.
    CloseFile {
        /// File.
        file: String,
    },
    /// Applies edits as one step of the history, all or none. [`{"version": number}`]
    EditFile {
        /// File.
        file: String,
        /// Version that the page knows. Edits by name are applied to any version, `replace` only to this one.
        version: u64,
        /// The edits.
        edits: Vec<Edit>,
    },
    /// Undoes the last step. [`{"version": number}`]
    UndoFile {
        /// File.
        file: String,
    },
    /// Makes the last undone step again. [`{"version": number}`]
    RedoFile {
        /// File.
        file: String,
    },
    /// Saves a file at once. A file that was deleted is made again.
    SaveFile {
        /// File.
        file: String,
    },
    /// Ends a conflict. [`{"version": number}`]
    ResolveFile {
        /// File.
        file: String,
        /// What to keep.
        keep: KeepSide,
    },
    /// Moves states on the canvas. The positions are written to the layout file at once.
    MoveStates {
        /// File.
        file: String,
        /// The positions.
        positions: Vec<MovedState>,
    },
    /// Forgets all positions of a component. [`{"positions": list of` [`StatePosition`](super::StatePosition)`}`]
    ArrangeStates {
        /// File.
        file: String,
        /// Component.
        component: String,
    },
    /// Replaces a note on the canvas. It is written to the layout file at once.
    ChangeNote {
        /// File.
        file: String,
        /// Component.
        component: String,
        /// The note as it is; none adds one.
        from: Option<Note>,
        /// The note as it will be; none removes it.
        to: Option<Note>,
    },
    /// Lists uses of a function of a component in other files. [list of [`SourceUse`](super::SourceUse)]
    Uses {
        /// File with the component.
        file: String,
        /// Component.
        component: String,
        /// Function.
        function: String,
    },
    /// Renames a function in its file, as the edit `rename`, and at chosen places of other files, all certain ones among them.
    /// Undoing it in one file undoes it in all.
    /// [`{"files": [{"file", "version"}]}`]
    RenameUses {
        /// File with the component.
        file: String,
        /// Component.
        component: String,
        /// Function.
        function: String,
        /// New name.
        to: String,
        /// Places in other files, as `Uses` lists them.
        places: Vec<SourcePlace>,
    },
    /// Makes a component: its file, its `mod` line, its entry in a tree. [`{"file": text, "files": [{"file", "diff"}]}`]
    NewComponent {
        /// Name, as in `WallFinder`.
        name: String,
        /// Folder of the new file; empty for the folder of sources itself.
        folder: String,
        /// File with the `activation_tree!` that gets the component.
        tree: Option<String>,
        /// Path of the module from which that file imports it, as in `crate::behaviour`.
        import: Option<String>,
        /// Whether only the differences are answered.
        dry: bool,
    },
    /// Draws a machine. [`{"text": text}`, or of a PNG `{"base64": text}`]
    DrawFile {
        /// File.
        file: String,
        /// Component.
        component: String,
        /// Format.
        format: DrawingFormat,
    },
    /// Finds edits that mend the mistakes of a file. [`{"version": number, "fixes": list for each mistake of `{"label", "edit"}`}`]
    Fixes {
        /// File.
        file: String,
    },
    /// Compares a file with its last commit. [`{"revision": text, "new": bool, "report": text, "comparison", "both": object from component
    /// to its model with what was removed}`]
    CompareFile {
        /// File.
        file: String,
    },
    /// Evaluates a trial of a machine from its beginning. [`{"trial", "test": text}`]
    TryMachine {
        /// File.
        file: String,
        /// Component.
        component: String,
        /// What is done, in order.
        steps: Vec<Step>,
    },
    /// Checks the packages of the open files with the compiler. Results come as [`ToPage::Check`](super::ToPage::Check).
    Check {},
    /// Builds the program and runs it instead of the one that runs. Results come as [`ToPage::Build`](super::ToPage::Build).
    Run {
        /// Seed.
        seed: u64,
        /// Number of other robots.
        robots: usize,
    },
    /// Ends a build and the program that runs.
    StopRun {},
}

/// Which text a conflict ends with.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum KeepSide {
    /// The text of the page.
    Ours,
    /// The text of the file.
    Theirs,
    /// A text made of both.
    Text(String),
}

/// New centre of a state on the canvas, points.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MovedState {
    /// Component.
    pub component: String,
    /// State.
    pub state: String,
    /// To the right.
    pub x: i32,
    /// Down.
    pub y: i32,
}

/// A place in a file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SourcePlace {
    /// File.
    pub file: String,
    /// Place.
    pub span: Span,
}

/// Format of a drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum DrawingFormat {
    /// Vector graphics.
    Svg,
    /// Picture.
    Png,
    /// `stateDiagram-v2` of Mermaid.
    Mermaid,
    /// `digraph` of Graphviz.
    Dot,
}
