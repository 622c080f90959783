//! A recorded image with what was seen drawn in.

use std::path::Path;

use glam::Vec2;

use super::detections::{Sighting, Trust};
use crate::frame_io::Recorded;
use bica_console::Failure;
use bica_drawing::camera;
use bica_drawing::canvas::Canvas;
use bica_drawing::palette::{FAINT, PAPER, TEXT};
use bica_drawing::png;
use bica_drawing::polar::Sight;
use bica_drawing::text::Font;

const WIDTH: usize = 640;
const MARGIN: usize = 12;
const HEAD: usize = 48;

/// Draws it into a folder, under the name that it had.
pub fn write(folder: &Path, recorded: &Recorded, sighting: &Sighting) -> Result<(), Failure> {
    let view = camera::view(&recorded.image(), &sighting.marks, WIDTH);
    let (width, height) = (view.width() + 2 * MARGIN, view.height() + HEAD + MARGIN);
    let mut sheet = Canvas::new(width, height, PAPER);
    sheet.write(Vec2::new(MARGIN as f32, 6.0), Font::Title, TEXT, &sighting.file);
    sheet.write(Vec2::new(MARGIN as f32, 28.0), Font::Normal, FAINT, &words(sighting));
    sheet.place(&view, MARGIN, HEAD);
    let path = folder.join(&sighting.file).with_extension("png");
    let mend = "is the disk full, or the folder write-protected?";
    png::write(&path, &sheet).map_err(|error| Failure::of_path("write", &path, &error, mend))
}

fn words(sighting: &Sighting) -> String {
    let mut words =
        vec![sighting.ball.as_ref().map_or_else(|| "no ball".to_owned(), |ball| place("ball", ball.ground))];
    words.extend(sighting.goals.iter().map(|goal| place(&format!("{} goal", goal.colour), goal.ground)));
    words.extend(match sighting.pose {
        Trust::Trusted => None,
        Trust::Untrusted => Some("pose not trusted".to_owned()),
        Trust::Missing => Some("no pose".to_owned()),
    });
    words.join(", ")
}

fn place(what: &str, ground: Option<[f32; 2]>) -> String {
    ground
        .map_or_else(|| what.to_owned(), |at| format!("{what} {}", Sight::new(Vec2::from(at), true).to_string().trim()))
}
