//! CSV files whose columns are found by name.

use csv::{ReaderBuilder, StringRecord, Trim};

/// CSV text with a header.
pub(crate) struct Table {
    header: StringRecord,
    rows: Vec<Row>,
}

/// Row of a table.
pub(crate) struct Row {
    /// Number of its line in the file, from 1.
    pub(crate) line: usize,
    cells: StringRecord,
}

impl Table {
    /// Parses a text. Cells are trimmed and blank lines skipped; rows may be shorter than the header.
    pub(crate) fn parse(text: &str) -> Result<Self, String> {
        let mut header = None;
        let mut rows = Vec::new();
        let mut reader =
            ReaderBuilder::new().has_headers(false).flexible(true).trim(Trim::All).from_reader(text.as_bytes());
        for record in reader.records() {
            let cells = record.map_err(|error| error.to_string())?;
            if cells.iter().all(str::is_empty) && cells.len() < 2 {
                continue;
            }
            let line = cells.position().map_or(0, |position| line_of(text, position.byte() as usize));
            if header.is_none() { header = Some(cells) } else { rows.push(Row { line, cells }) }
        }
        Ok(Self { header: header.ok_or("the file is empty")?, rows })
    }

    /// Returns the index of a column, if the table has it.
    pub(crate) fn find(&self, name: &str) -> Option<usize> {
        self.header.iter().position(|cell| cell == name)
    }

    /// Returns the index of a column that the table must have.
    pub(crate) fn column(&self, name: &str) -> Result<usize, String> {
        self.find(name).ok_or_else(|| format!("there is no column `{name}`"))
    }

    pub(crate) fn rows(&self) -> &[Row] {
        &self.rows
    }
}

impl Row {
    /// Returns a cell; empty if the row is too short.
    pub(crate) fn cell(&self, column: usize) -> &str {
        self.cells.get(column).unwrap_or("")
    }

    /// Number of cells.
    pub(crate) fn len(&self) -> usize {
        self.cells.len()
    }
}

/// Line number of the record at a byte offset. The reader counts blank lines before a record as part of it.
fn line_of(text: &str, byte: usize) -> usize {
    let rest = text.get(byte..).unwrap_or("");
    let blank = rest.len() - rest.trim_start_matches(['\r', '\n']).len();
    1 + text.get(..byte + blank).map_or(0, |before| before.matches('\n').count())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_found_by_column() {
        let table = Table::parse("name, note\n\na ,\"x, y\"\r\n\n\nb\n").expect("a table");
        let note = table.column("note").expect("a column");
        let found: Vec<_> = table.rows().iter().map(|row| (row.line, row.cell(0), row.cell(note), row.len())).collect();
        assert_eq!(found, [(3, "a", "x, y", 2), (6, "b", "", 1)]);
        assert_eq!(table.column("size"), Err("there is no column `size`".to_owned()));
        assert!(Table::parse(" \n\n").is_err_and(|what| what == "the file is empty"));
    }
}
