//! Sources, as they are sent to pages.

use bica_vicode::model::{Model, Span};
use bica_vicode::{Conflict, Note, Splice};
use serde::Serialize;

/// An open file, complete.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SourceState {
    /// File.
    pub file: String,
    /// Version of the text.
    pub version: u64,
    /// Text.
    pub text: String,
    /// Model of the text.
    pub model: Model,
    /// Positions of states and notes on the canvas.
    #[serde(flatten)]
    pub drawn: Drawn,
    /// State of the file on disk.
    #[serde(flatten)]
    pub state: FileState,
}

/// A change of an open file.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SourceChange {
    /// File.
    pub file: String,
    /// Version of the text afterwards.
    pub version: u64,
    /// Version before it; the same if the text did not change.
    pub from_version: u64,
    /// Lists of replacements. Each list refers to the text after the list before it.
    pub splices: Vec<Vec<Splice>>,
    /// Model of the text; none if the text did not change.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub model: Option<Model>,
    /// Positions of states and notes on the canvas.
    #[serde(flatten)]
    pub drawn: Drawn,
    /// State of the file on disk.
    #[serde(flatten)]
    pub state: FileState,
    /// Origin of the change.
    pub by: ChangedBy,
    /// Page that requested the change, as in [`ToPage::Hello`](super::ToPage::Hello); 0 without one.
    pub page: u64,
}

/// Origin of a change of an open file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ChangedBy {
    /// A page.
    Page,
    /// Another program, which changed the file on disk.
    File,
    /// A page, which undid or redid a step.
    Undo,
}

/// State of the file on disk, compared with the open text.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
#[expect(clippy::struct_excessive_bools, reason = "each is an independent property, a field of a JSON object")]
pub struct FileState {
    /// Whether the file contains the open text.
    pub saved: bool,
    /// Whether the file is read-only.
    pub readonly: bool,
    /// Whether the file was deleted. The text is kept; `save_file` creates the file again.
    pub deleted: bool,
    /// Why the file cannot be read or written, with a remedy; empty if there is no problem.
    pub problem: String,
    /// Conflicting changes of pages and of another program. The file is not written until the conflict is resolved.
    pub conflict: Option<Conflict>,
    /// Whether there is a step to undo.
    pub undo: bool,
    /// Whether there is a step to redo.
    pub redo: bool,
}

/// Positions of states and notes on the canvas.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Drawn {
    /// Centres of all states.
    pub positions: Vec<StatePosition>,
    /// Notes.
    pub notes: Vec<PlacedNote>,
}

/// A note on the drawing of a component.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct PlacedNote {
    /// Component.
    pub component: String,
    /// The note.
    #[serde(flatten)]
    pub note: Note,
}

/// Centre of a state on the canvas, points; x to the right, y down.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct StatePosition {
    /// Component.
    pub component: String,
    /// State.
    pub state: String,
    /// Horizontal coordinate, to the right.
    pub x: i32,
    /// Vertical coordinate, down.
    pub y: i32,
    /// Whether a person placed the state; otherwise the position is computed.
    pub placed: bool,
}

/// A file of the folder of sources.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct SourceFile {
    /// File.
    pub file: String,
    /// Its components.
    pub components: Vec<SourceComponent>,
    /// Names of its trees.
    pub trees: Vec<String>,
    /// Why the file cannot be read.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub problem: Option<String>,
}

/// A component of a file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct SourceComponent {
    /// Key in the file, as used by edits.
    pub key: String,
    /// Name.
    pub name: String,
    /// Whether it is a state machine.
    pub machine: bool,
}

/// A table of constants of a file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct SourceTable {
    /// File.
    pub file: String,
    /// Key in the file, as used by edits.
    pub key: String,
    /// Type of a row.
    pub ty: String,
    /// Names of the cells of the first row.
    pub cells: Vec<String>,
}

/// A use of a function.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct SourceUse {
    /// File.
    pub file: String,
    /// Line, from 1.
    pub line: usize,
    /// Span of the name.
    pub span: Span,
    /// Text of the line.
    pub text: String,
    /// Whether the component is named before the function; otherwise the type of the called value is unknown.
    pub certain: bool,
}
