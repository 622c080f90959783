//! Hand-drawn rectangles of one colour class in recorded images, from a CSV file.
//!
//! Columns, found by name: `file`; `x0`, `y0`, `x1`, `y1` (px, `x1` and `y1` exclusive); `class`.

use std::fs;
use std::path::Path;

use bica_app::Failure;
use bica_vision::colour::Colour;

use crate::table::Table;

/// Classes by their names in the file.
const CLASSES: [(&str, Colour); 6] = [
    ("ball", Colour::Orange),
    ("goal_yellow", Colour::Yellow),
    ("goal_blue", Colour::Blue),
    ("field", Colour::Green),
    ("line", Colour::White),
    ("other", Colour::None),
];

/// Rectangle of pixels of one class.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Rectangle {
    /// Folder and name of the image, as in the file of rectangles.
    pub(super) file: String,
    /// First column, and last column plus one.
    pub(super) x: [u16; 2],
    /// First row, and last row plus one.
    pub(super) y: [u16; 2],
    /// The class; [`Colour::None`] for pixels of none of the classes.
    pub(super) class: Colour,
}

/// Reads a file.
pub(super) fn read(path: &Path) -> Result<Vec<Rectangle>, Failure> {
    let help = "name a CSV file with the columns file, x0, y0, x1, y1 and class";
    let text = fs::read_to_string(path).map_err(|error| Failure::of_path("read the rectangles", path, &error, help))?;
    parse(&text).map_err(|(what, help)| Failure::new(format!("`{}`: {what}", path.display()), help))
}

fn parse(text: &str) -> Result<Vec<Rectangle>, (String, String)> {
    let needed = |what| (what, "the columns are file, x0, y0, x1, y1 and class".to_owned());
    let table = Table::parse(text).map_err(needed)?;
    let column = |name| table.column(name).map_err(needed);
    let (file, class) = (column("file")?, column("class")?);
    let sides = [column("x0")?, column("x1")?, column("y0")?, column("y1")?];
    let mut rectangles = Vec::new();
    for row in table.rows() {
        let cell = |column: usize| row.cell(column);
        let wrong = |what: &str, help: &str| (format!("line {}: {what}", row.line), help.to_owned());
        let known = CLASSES.iter().find(|(name, _)| *name == cell(class));
        let names = || CLASSES.map(|(name, _)| name).join(", ");
        let (_, class) = known.ok_or_else(|| {
            wrong(&format!("`{}` is not a class", cell(class)), &format!("the classes are {}", names()))
        })?;
        let [x0, x1, y0, y1] = sides.map(|side| cell(side).parse().ok());
        let range = |from: Option<u16>, to: Option<u16>| Some([from?, to?]).filter(|[from, to]| from < to);
        let (x, y) = range(x0, x1).zip(range(y0, y1)).ok_or_else(|| {
            wrong("this is not a rectangle", "use whole pixels from 0, with x0 less than x1 and y0 less than y1")
        })?;
        rectangles.push(Rectangle { file: cell(file).to_owned(), x, y, class: *class });
    }
    Ok(rectangles)
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADER: &str = "file,x0,y0,x1,y1,class\n";

    #[test]
    fn rectangles_are_parsed_with_their_class() {
        let read = parse(&format!("{HEADER}a/1.png,1,2,30,40,goal_blue\n\n")).expect("rectangles");
        assert_eq!(read, [Rectangle { file: "a/1.png".to_owned(), x: [1, 30], y: [2, 40], class: Colour::Blue }]);
    }

    #[test]
    fn malformed_rectangles_are_refused_with_their_line() {
        let wrong = |row: &str| parse(&format!("{HEADER}{row}")).expect_err(row).0;
        assert_eq!(wrong("1.png,1,2,3,4,sky"), "line 2: `sky` is not a class");
        assert_eq!(wrong("\n1.png,3,2,3,4,field"), "line 3: this is not a rectangle");
        assert_eq!(wrong("1.png,1,2,3.5,4,field"), "line 2: this is not a rectangle");
        assert_eq!(parse("file,x0\n").expect_err("columns").0, "there is no column `class`");
    }
}
