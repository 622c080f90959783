//! Pictures of recorded images with detections.

use std::path::Path;

use bica_app::Failure;
use bica_drawing::canvas::Canvas;
use bica_drawing::palette::{FAINT, PAPER, TEXT};
use bica_drawing::png;
use bica_drawing::text::Font;
use glam::Vec2;

use super::detections::{Detections, PoseTrust};
use crate::frame_io::RecordedFrame;
use crate::pictures::camera;
use crate::polar::Polar;

/// Width of the image, px.
const WIDTH: usize = 640;
/// Margin around the image, px.
const MARGIN: usize = 12;
/// Height of the title, px.
const TITLE_HEIGHT: usize = 48;

/// Writes the picture of an image to a folder, under the name of the image.
pub(super) fn write(folder: &Path, recorded: &RecordedFrame, detections: &Detections) -> Result<(), Failure> {
    let view = camera::view(&recorded.image(), &detections.marks, WIDTH);
    let (width, height) = (view.width() + 2 * MARGIN, view.height() + TITLE_HEIGHT + MARGIN);
    let mut sheet = Canvas::new(width, height, PAPER);
    sheet.write(Vec2::new(MARGIN as f32, 6.0), Font::Title, TEXT, &detections.file);
    sheet.write(Vec2::new(MARGIN as f32, 28.0), Font::Normal, FAINT, &caption(detections));
    sheet.place(&view, MARGIN, TITLE_HEIGHT);
    let path = folder.join(&detections.file).with_extension("png");
    let help = "is the disk full, or the folder write-protected?";
    png::write(&path, &sheet).map_err(|error| Failure::of_path("write", &path, &error, help))
}

fn caption(detections: &Detections) -> String {
    let mut words =
        vec![detections.ball.as_ref().map_or_else(|| "no ball".to_owned(), |ball| position("ball", ball.ground))];
    words.extend(detections.goals.iter().map(|goal| position(&format!("{} goal", goal.colour), goal.ground)));
    words.extend(match detections.pose {
        PoseTrust::Trusted => None,
        PoseTrust::Untrusted => Some("pose not trusted".to_owned()),
        PoseTrust::Missing => Some("no pose".to_owned()),
    });
    words.join(", ")
}

fn position(what: &str, ground: Option<[f32; 2]>) -> String {
    ground
        .map_or_else(|| what.to_owned(), |at| format!("{what} {}", Polar::new(Vec2::from(at), true).to_string().trim()))
}
