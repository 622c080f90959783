//! Labels of recorded images, from a CSV file.
//!
//! Columns, found by name: `file`; `ball_x`, `ball_y`, `ball_radius` (px; `none` without a ball, `unlabelled` without a
//! label); `ball_flag` (`full`, `clipped` or `small`); `goal` (empty or `x0:y0:x1:y1:colour:complete|partial`, px). In
//! place of one flag, `ball_flag` may hold all balls as `x:y:r:colour:flag`, separated by `;`.

use std::fs;
use std::path::Path;

use bica_app::Failure;
use glam::Vec2;

use crate::frame_io::stem;
use crate::table::Table;

const HELP: &str = "the columns are file, ball_x, ball_y, ball_radius, ball_flag and goal";

/// Labelled content of an image.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// Folder and name, as in the file of labels.
    pub file: String,
    /// All balls.
    pub balls: Vec<Ball>,
    /// The goal.
    pub goal: Option<Goal>,
}

/// Labelled ball, px.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    /// Centre.
    pub centre: Vec2,
    /// Radius.
    pub radius: f32,
    /// Whether this is the ball of the game; otherwise it is a red object or another ball.
    pub orange: bool,
    /// Whether the ball is completely visible and not tiny.
    pub full: bool,
}

/// Bounding box of a goal, px.
#[derive(Clone, Debug, PartialEq)]
pub struct Goal {
    /// Upper left corner.
    pub min: Vec2,
    /// Lower right corner.
    pub max: Vec2,
    /// `yellow` or `blue`.
    pub colour: String,
    /// Whether the image shows both posts.
    pub complete: bool,
}

/// Labels of the images of one folder.
#[derive(Debug)]
pub struct Labels(Vec<Label>);

impl Labels {
    /// Reads the labels of a folder, or all labels if none names the folder.
    ///
    /// # Errors
    /// If the file cannot be read or a label is malformed.
    pub fn read(path: &Path, folder: &Path) -> Result<Self, Failure> {
        let help = "name a CSV file with the labels";
        let text = fs::read_to_string(path).map_err(|error| Failure::of_path("read the labels", path, &error, help))?;
        let wrong = |what| Failure::new(format!("`{}`: {what}", path.display()), HELP);
        let mut all = parse(&text).map_err(wrong)?;
        let own = own_folder(folder);
        if all.iter().any(|label| label.file.starts_with(&own)) {
            all.retain(|label| label.file.starts_with(&own));
        }
        Ok(Self(all))
    }

    /// Returns the label of an image; `None` if there is none or more than one.
    #[must_use]
    pub fn get(&self, file: &str) -> Option<&Label> {
        let mut fitting = self.0.iter().filter(|label| stem(&label.file) == stem(file));
        fitting.next().filter(|_| fitting.next().is_none())
    }
}

/// Returns the prefix of a folder's images in files of labels: the folder's name and a slash.
#[must_use]
pub fn own_folder(folder: &Path) -> String {
    let folder = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
    format!("{}/", folder.file_name().unwrap_or_default().to_string_lossy())
}

fn parse(text: &str) -> Result<Vec<Label>, String> {
    let table = Table::parse(text)?;
    let columns = ["file", "ball_x", "ball_y", "ball_radius", "ball_flag", "goal"].map(|name| table.column(name));
    let [file, x, y, radius, flag, goal] = columns;
    let (file, x, y, radius, flag, goal) = (file?, x?, y?, radius?, flag?, goal?);
    let mut labels = Vec::new();
    for row in table.rows() {
        let cell = |column: usize| row.cell(column);
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
        labels.push(label().map_err(|what: String| format!("line {}: {what}", row.line))?);
    }
    Ok(labels)
}

fn numbers<const N: usize>(parts: &[&str]) -> Option<[f32; N]> {
    let list: Vec<f32> = parts.iter().take(N).filter_map(|part| part.parse().ok()).collect();
    <[f32; N]>::try_from(list).ok().filter(|list| list.iter().all(|number| number.is_finite()))
}

fn ball(text: &str) -> Result<Ball, String> {
    let parts: Vec<&str> = text.split(':').collect();
    let [x, y, radius] = numbers(&parts).filter(|_| parts.len() == 5).ok_or(format!("`{text}` is not a ball"))?;
    Ok(Ball { centre: Vec2::new(x, y), radius, orange: parts[3] == "orange", full: parts[4] == "full" })
}

fn goal(text: &str) -> Result<Goal, String> {
    let parts: Vec<&str> = text.split(':').collect();
    let [x0, y0, x1, y1] = numbers(&parts).filter(|_| parts.len() == 6).ok_or(format!("`{text}` is not a goal"))?;
    let (min, max) = (Vec2::new(x0, y0), Vec2::new(x1, y1));
    Ok(Goal { min, max, colour: parts[4].to_owned(), complete: parts[5] == "complete" })
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADER: &str = "file,ball_x,ball_y,ball_radius,ball_flag,goal,checked\n";

    #[test]
    fn all_forms_of_labels_are_parsed() {
        let rows = "a/1.png,10,20.5,3,full,1:2:3:4:blue:partial,\"by hand, or not\"\na/2.png,none,none,none,,,\n\
            a/3.png,unlabelled,,,,,\n\na/4.png,1,2,3,1:2:3:orange:clipped;4:5:6:red:full,,\n";
        let labels = parse(&format!("{HEADER}{rows}")).expect("labels");
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
    fn malformed_labels_are_refused_with_their_line() {
        let wrong = |rows: &str| parse(&format!("{HEADER}{rows}")).expect_err(rows);
        assert_eq!(wrong("1.png,1,2,x,full,,"), "line 2: `1:2:x:orange:full` is not a ball");
        assert_eq!(wrong("\n1.png,none,,,,1:2:3:blue,"), "line 3: `1:2:3:blue` is not a goal");
        assert_eq!(parse("file,ball_x\n").expect_err("columns"), "there is no column `ball_y`");
    }
}
