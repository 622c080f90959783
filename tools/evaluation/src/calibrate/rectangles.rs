//! Rectangles of one class in recorded images, placed by hand.
//!
//! Columns by name: `file`; `x0`, `y0`, `x1`, `y1` (px, the last column and row not included); `class`.

use std::fs;
use std::path::Path;

use bica_vision::colour::Colour;

use crate::labels::Table;
use bica_console::Failure;

/// The classes by the names that such files use.
const CLASSES: [(&str, Colour); 6] = [
    ("ball", Colour::Orange),
    ("goal_yellow", Colour::Yellow),
    ("goal_blue", Colour::Blue),
    ("field", Colour::Green),
    ("line", Colour::White),
    ("other", Colour::None),
];

/// Pixels of one class.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rectangle {
    /// The folder and the name, as the file has it.
    pub file: String,
    /// First and one past the last column.
    pub x: [u16; 2],
    /// First and one past the last row.
    pub y: [u16; 2],
    /// [`Colour::None`] is none of the classes.
    pub class: Colour,
}

/// The rectangles of a file.
pub fn read(path: &Path) -> Result<Vec<Rectangle>, Failure> {
    let mend = "name a CSV file with the columns file, x0, y0, x1, y1 and class";
    let text = fs::read_to_string(path).map_err(|error| Failure::of_path("read the rectangles", path, &error, mend))?;
    parse(&text).map_err(|(what, mend)| Failure::new(format!("`{}`: {what}", path.display()), mend))
}

fn parse(text: &str) -> Result<Vec<Rectangle>, (String, String)> {
    let needed = |what| (what, "the columns are file, x0, y0, x1, y1 and class".to_owned());
    let table = Table::new(text).map_err(needed)?;
    let column = |name| table.column(name).map_err(needed);
    let (file, class) = (column("file")?, column("class")?);
    let sides = [column("x0")?, column("x1")?, column("y0")?, column("y1")?];
    let mut rectangles = Vec::new();
    for (line, cells) in table.rows() {
        let cell = |column: usize| cells.get(column).map_or("", String::as_str);
        let wrong = |what: &str, mend: &str| (format!("line {line}: {what}"), mend.to_owned());
        let known = CLASSES.iter().find(|(name, _)| *name == cell(class));
        let names = || CLASSES.map(|(name, _)| name).join(", ");
        let (_, class) = known
            .ok_or_else(|| wrong(&format!("`{}` is no class", cell(class)), &format!("the classes are {}", names())))?;
        let [x0, x1, y0, y1] = sides.map(|side| cell(side).parse().ok());
        let range = |from: Option<u16>, to: Option<u16>| Some([from?, to?]).filter(|[from, to]| from < to);
        let (x, y) = range(x0, x1).zip(range(y0, y1)).ok_or_else(|| {
            wrong("this is no rectangle", "x0 is less than x1, y0 less than y1, all whole pixels from 0")
        })?;
        rectangles.push(Rectangle { file: cell(file).to_owned(), x, y, class: *class });
    }
    Ok(rectangles)
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADING: &str = "file,x0,y0,x1,y1,class\n";

    #[test]
    fn rectangles_are_read_with_their_class() {
        let read = parse(&format!("{HEADING}a/1.png,1,2,30,40,goal_blue\n\n")).expect("rectangles");
        assert_eq!(read, [Rectangle { file: "a/1.png".to_owned(), x: [1, 30], y: [2, 40], class: Colour::Blue }]);
    }

    #[test]
    fn what_is_no_rectangle_is_refused_and_the_line_named() {
        let wrong = |row: &str| parse(&format!("{HEADING}{row}")).expect_err(row).0;
        assert_eq!(wrong("1.png,1,2,3,4,sky"), "line 2: `sky` is no class");
        assert_eq!(wrong("\n1.png,3,2,3,4,field"), "line 3: this is no rectangle");
        assert_eq!(wrong("1.png,1,2,3.5,4,field"), "line 2: this is no rectangle");
        assert_eq!(parse("file,x0\n").expect_err("columns").0, "there is no column `class`");
    }
}
