//! Labels of recorded images from a CSV file.
//!
//! Columns by name: `file`; `ball_x`, `ball_y`, `ball_radius` (px), `none` if there is no ball, `unlabelled` if nobody
//! looked; `ball_flag`, `full`, `clipped` or `small`, or all balls as `x:y:r:colour:flag` with `;` between them; `goal`,
//! empty or `x0:y0:x1:y1:colour:complete|partial` (px).

use std::fs;
use std::path::Path;

use glam::Vec2;

use crate::frame_io::stem;
use bica_console::Failure;

const MEND: &str = "the columns are file, ball_x, ball_y, ball_radius, ball_flag and goal";

/// What is in an image.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// The folder and the name, as the file has it.
    pub file: String,
    pub balls: Vec<Ball>,
    pub goal: Option<Goal>,
}

/// A ball, px.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    pub centre: Vec2,
    pub radius: f32,
    /// Else it is red, or another that is not to be played with.
    pub orange: bool,
    /// Whether it is whole in the image and not tiny.
    pub full: bool,
}

/// The box around a goal, px.
#[derive(Clone, Debug, PartialEq)]
pub struct Goal {
    pub min: Vec2,
    pub max: Vec2,
    pub colour: String,
    pub complete: bool,
}

/// The labels for the images of one folder.
#[derive(Debug)]
pub struct Labels(Vec<Label>);

impl Labels {
    /// Reads those for a folder: the ones that name it, or all if none does.
    pub fn read(path: &Path, folder: &Path) -> Result<Self, Failure> {
        let mend = "name a CSV file with the labels";
        let text = fs::read_to_string(path).map_err(|error| Failure::of_path("read the labels", path, &error, mend))?;
        let wrong = |what| Failure::new(format!("`{}`: {what}", path.display()), MEND);
        let mut all = parse(&text).map_err(wrong)?;
        let own = own_folder(folder);
        if all.iter().any(|label| label.file.starts_with(&own)) {
            all.retain(|label| label.file.starts_with(&own));
        }
        Ok(Self(all))
    }

    /// The label for an image; none if there is none, or several.
    pub fn get(&self, file: &str) -> Option<&Label> {
        let mut fitting = self.0.iter().filter(|label| stem(&label.file) == stem(file));
        fitting.next().filter(|_| fitting.next().is_none())
    }
}

/// How files of labels begin the name of an image of a folder: with its name and a slash.
pub fn own_folder(folder: &Path) -> String {
    let folder = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
    format!("{}/", folder.file_name().unwrap_or_default().to_string_lossy())
}

fn parse(text: &str) -> Result<Vec<Label>, String> {
    let table = Table::new(text)?;
    let columns = ["file", "ball_x", "ball_y", "ball_radius", "ball_flag", "goal"].map(|name| table.column(name));
    let [file, x, y, radius, flag, goal] = columns;
    let (file, x, y, radius, flag, goal) = (file?, x?, y?, radius?, flag?, goal?);
    let mut labels = Vec::new();
    for (line, cells) in table.rows() {
        let cell = |column: usize| cells.get(column).map_or("", String::as_str);
        if cell(x) == "unlabelled" {
            continue;
        }
        let one = [cell(x), cell(y), cell(radius), "orange", cell(flag)].join(":");
        let balls = if cell(flag).contains(':') { cell(flag) } else { &one };
        let label = || {
            let balls = balls.split(';').filter(|_| cell(x) != "none").map(ball).collect::<Result<_, _>>()?;
            let goal = Some(cell(goal)).filter(|text| !text.is_empty()).map(self::goal).transpose()?;
            Ok(Label { file: cell(file).to_owned(), balls, goal })
        };
        labels.push(label().map_err(|what: String| format!("line {line}: {what}"))?);
    }
    Ok(labels)
}

fn numbers<const N: usize>(parts: &[&str]) -> Option<[f32; N]> {
    let list: Vec<f32> = parts.iter().take(N).filter_map(|part| part.parse().ok()).collect();
    <[f32; N]>::try_from(list).ok().filter(|list| list.iter().all(|number| number.is_finite()))
}

fn ball(text: &str) -> Result<Ball, String> {
    let parts: Vec<&str> = text.split(':').collect();
    let [x, y, radius] = numbers(&parts).filter(|_| parts.len() == 5).ok_or(format!("`{text}` is no ball"))?;
    Ok(Ball { centre: Vec2::new(x, y), radius, orange: parts[3] == "orange", full: parts[4] == "full" })
}

fn goal(text: &str) -> Result<Goal, String> {
    let parts: Vec<&str> = text.split(':').collect();
    let [x0, y0, x1, y1] = numbers(&parts).filter(|_| parts.len() == 6).ok_or(format!("`{text}` is no goal"))?;
    let (min, max) = (Vec2::new(x0, y0), Vec2::new(x1, y1));
    Ok(Goal { min, max, colour: parts[4].to_owned(), complete: parts[5] == "complete" })
}

/// A CSV text with a heading.
pub struct Table<'a> {
    heading: Vec<String>,
    text: &'a str,
}

impl<'a> Table<'a> {
    /// Reads the heading.
    pub fn new(text: &'a str) -> Result<Self, String> {
        let heading = text.lines().next().ok_or("the file is empty")?;
        Ok(Self { heading: cells(heading), text })
    }

    /// The place of a column.
    pub fn column(&self, name: &str) -> Result<usize, String> {
        self.heading.iter().position(|cell| cell == name).ok_or_else(|| format!("there is no column `{name}`"))
    }

    /// The cells of each row, with the number of its line.
    pub fn rows(&self) -> impl Iterator<Item = (usize, Vec<String>)> {
        let lines = self.text.lines().enumerate().skip(1).filter(|(_, line)| !line.trim().is_empty());
        lines.map(|(index, line)| (index + 1, cells(line)))
    }
}

/// The cells of a line; a comma between quotation marks is a part of its cell.
fn cells(line: &str) -> Vec<String> {
    let (mut cells, mut quoted) = (vec![String::new()], false);
    for letter in line.chars() {
        match letter {
            '"' => quoted = !quoted,
            ',' if !quoted => cells.push(String::new()),
            _ => cells.last_mut().into_iter().for_each(|cell| cell.push(letter)),
        }
    }
    cells.iter().map(|cell| cell.trim().to_owned()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADING: &str = "file,ball_x,ball_y,ball_radius,ball_flag,goal,checked\n";

    #[test]
    fn labels_are_read_in_all_their_forms() {
        let rows = "a/1.png,10,20.5,3,full,1:2:3:4:blue:partial,\"by hand, or not\"\na/2.png,none,none,none,,,\n\
            a/3.png,unlabelled,,,,,\n\na/4.png,1,2,3,1:2:3:orange:clipped;4:5:6:red:full,,\n";
        let labels = parse(&format!("{HEADING}{rows}")).expect("labels");
        let names: Vec<&str> = labels.iter().map(|label| stem(&label.file)).collect();
        assert_eq!(names, ["1", "2", "4"]);
        let first = Ball { centre: Vec2::new(10.0, 20.5), radius: 3.0, orange: true, full: true };
        assert_eq!(labels[0].balls, [first]);
        assert!(
            labels[0]
                .goal
                .as_ref()
                .is_some_and(|goal| goal.max == Vec2::new(3.0, 4.0) && !goal.complete && goal.colour == "blue")
        );
        assert!(labels[1].balls.is_empty() && labels[1].goal.is_none());
        assert_eq!(
            labels[2].balls.iter().map(|ball| (ball.orange, ball.full)).collect::<Vec<_>>(),
            [(true, false), (false, true)]
        );
    }

    #[test]
    fn what_is_no_label_is_refused_and_the_line_named() {
        let wrong = |rows: &str| parse(&format!("{HEADING}{rows}")).expect_err(rows);
        assert_eq!(wrong("1.png,1,2,x,full,,"), "line 2: `1:2:x:orange:full` is no ball");
        assert_eq!(wrong("\n1.png,none,,,,1:2:3:blue,"), "line 3: `1:2:3:blue` is no goal");
        assert_eq!(parse("file,ball_x\n").expect_err("columns"), "there is no column `ball_y`");
    }
}
