//! Constants that are tables of numbers.

use serde::Serialize;

use super::{Docs, Name, Span};

/// A constant whose value is a table of numbers, such as the keyframes of a motion.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Table {
    /// Unique key in the file: the name; `#2` is appended for the second table of that name.
    pub key: String,
    /// Name of the constant, or of the variant for which a `match` returns the table.
    pub name: Name,
    /// Type of a row, without its path.
    pub ty: String,
    /// Place of the whole item.
    pub span: Span,
    /// Doc comment.
    pub docs: Docs,
    /// Span between the brackets of the rows; none if the table is a single row outside an array.
    pub array: Option<Span>,
    /// Span of the array length in the type; none for a slice.
    pub length: Option<Span>,
    /// The rows.
    pub rows: Vec<Row>,
}

/// A row of a table.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Row {
    /// Place.
    pub span: Span,
    /// Span between the brackets, for a row that is a list of pairs of name and number.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pairs: Option<Span>,
    /// Its cells.
    pub cells: Vec<Cell>,
}

/// A number in a row, or the name of a constant.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Cell {
    /// Path of the number in its row: field names and zero-based positions, separated by dots; in a list of pairs the name of the pair.
    pub name: String,
    /// Place.
    pub span: Span,
    /// The number; none for the name of a constant.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub value: Option<f64>,
}

impl Row {
    /// Returns the cell with that name.
    #[must_use]
    pub fn cell(&self, name: &str) -> Option<&Cell> {
        self.cells.iter().find(|cell| cell.name == name)
    }
}
