//! Sources as a page sees them.

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
    /// What is drawn where.
    #[serde(flatten)]
    pub drawn: Drawn,
    /// The file on disk beside it.
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
    /// Replacements, each list of the text after the list before it.
    pub splices: Vec<Vec<Splice>>,
    /// Model of the text; none if the text did not change.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub model: Option<Model>,
    /// What is drawn where.
    #[serde(flatten)]
    pub drawn: Drawn,
    /// The file on disk beside it.
    #[serde(flatten)]
    pub state: FileState,
    /// Who changed it.
    pub by: ChangedBy,
    /// The page that asked for it, as in [`ToPage::Hello`](super::ToPage::Hello); 0 without one.
    pub page: u64,
}

/// Who changed an open file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ChangedBy {
    /// A page.
    Page,
    /// Another program, in the file.
    File,
    /// A page, which undid or redid a step.
    Undo,
}

/// The file on disk beside an open text.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
#[expect(clippy::struct_excessive_bools, reason = "each is an independent property, a field of a JSON object")]
pub struct FileState {
    /// Whether the file has the text.
    pub saved: bool,
    /// Whether the file may not be written.
    pub readonly: bool,
    /// Whether the file is gone. The text stays; `save_file` makes the file again.
    pub deleted: bool,
    /// Why the file cannot be read or written, and what to do; empty if all is well.
    pub problem: String,
    /// Changes of both sides that touch each other. The file is not written until one is chosen.
    pub conflict: Option<Conflict>,
    /// Whether there is a step to undo.
    pub undo: bool,
    /// Whether there is a step to make again.
    pub redo: bool,
}

/// What is drawn where.
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
    /// To the right.
    pub x: i32,
    /// Down.
    pub y: i32,
    /// Whether a person placed it; else it is computed.
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
    /// Why it cannot be read.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub problem: Option<String>,
}

/// A component of a file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct SourceComponent {
    /// Address in the file, as edits take it.
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
    /// Address in the file, as edits take it.
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
    /// Place of the name.
    pub span: Span,
    /// The line.
    pub text: String,
    /// Whether the component is named before it; else the type of what is called is unknown.
    pub certain: bool,
}
