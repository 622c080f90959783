//! The end of the field in the image: the top of the green, column by column, then one convex line.
//!
//! In each scanned column the stretch that is greenest, lines included, gives a point: where the carpet ends. Nothing
//! above the horizon is carpet, if the camera's pose is known. Goals, robots and the ball stand in it and pull points
//! down, green things in the hall pull them up. The end is the convex line of one to three straight sides that most
//! points agree on.
//!
//! Cost: [`COLUMNS`] columns × half the rows, about 2 ns each, and up to 200 lines × 40 points for each side: 16 µs at
//! 320 × 240.

mod hull;

use glam::Vec2;
use heapless::Vec;

use crate::colour::{Classify, Colour};
use crate::frame::Frame;
use crate::projection::Camera;

/// Scanned columns in a frame.
pub const COLUMNS: usize = 40;

/// A column needs this much more green than other colours, as a part of the scanned rows, to count.
const ENOUGH_GREEN: f32 = 0.03;
/// A gap that ends the carpet, as a part of the frame's height.
const GAP: f32 = 0.025;
/// An error of the camera's pitch that the horizon forgives, rad.
const PITCH_ERROR: f32 = 0.035;

/// The line at which the field ends, from the left edge of the image to the right one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FieldBoundary {
    corners: Vec<Vec2, COLUMNS>,
}

impl FieldBoundary {
    /// No field in sight.
    pub const NONE: Self = Self { corners: Vec::new() };

    /// Finds the end of the field by green and white alone; no other class is asked for.
    #[must_use]
    pub fn find(frame: &Frame<'_>, colours: &impl Classify) -> Self {
        Self::find_with(frame, colours, None)
    }

    /// As [`find`](Self::find). With `camera`, nothing above the horizon counts, give or take 2° of pitch.
    #[must_use]
    pub fn find_with(frame: &Frame<'_>, colours: &impl Classify, camera: Option<&Camera>) -> Self {
        let points = column_tops(frame, colours, camera);
        let (width, height) = (f32::from(frame.width()), f32::from(frame.height()));
        Self { corners: hull::over(&points, (0.0, width - 1.0), height) }
    }

    /// The corners of the line in pixels, from the left; empty if no field is in sight.
    #[must_use]
    pub fn corners(&self) -> &[Vec2] {
        &self.corners
    }

    /// The row at which the field ends in a column. None if no field is in sight.
    #[must_use]
    pub fn row_at(&self, x: f32) -> Option<f32> {
        hull::line_at(&self.corners, x)
    }

    /// The highest row of the line: nothing of the field is above it. None if no field is in sight.
    #[must_use]
    pub fn top(&self) -> Option<f32> {
        self.corners.iter().map(|corner| corner.y).reduce(f32::min)
    }

    /// Whether a point is on the field, or at most `margin` pixels above its end. Never if no field is in sight.
    #[must_use]
    pub fn is_below(&self, x: f32, y: f32, margin: f32) -> bool {
        self.row_at(x).is_some_and(|end| y >= end - margin)
    }
}

fn column_tops(frame: &Frame<'_>, colours: &impl Classify, camera: Option<&Camera>) -> Vec<Vec2, COLUMNS> {
    let pitch = f32::from(frame.width()) / COLUMNS as f32;
    let columns = (0..COLUMNS).map(|column| (column as f32 + 0.5) * pitch);
    let highest = |x: f32| {
        let row = camera.and_then(|camera| Some(camera.horizon(x)? - PITCH_ERROR * camera.intrinsics().focal.y));
        row.map_or(0, |row| row.max(0.0) as u16)
    };
    columns.filter_map(|x| Some(Vec2::new(x, column_top(frame, colours, x as u16, highest(x))?))).collect()
}

/// The top of the stretch of a column with the most green over the rest: the largest sum of +1 and −1. A gap of other
/// colours than white ends a stretch if it is longer than [`GAP`].
fn column_top(frame: &Frame<'_>, colours: &impl Classify, x: u16, highest: u16) -> Option<f32> {
    let longest = (GAP * f32::from(frame.height() / 2)) as u16;
    let (mut best, mut best_row, mut sum, mut gap) = (0, 0, 0, 0);
    for row in (highest..frame.height()).rev().step_by(2) {
        let class = frame.pixel(i32::from(x), i32::from(row)).map(|pixel| colours.classify(pixel));
        if class == Some(Colour::Green) {
            (sum, gap) = (sum + 1, 0);
        } else {
            gap += u16::from(class != Some(Colour::White));
            sum = if gap > longest { 0 } else { (sum - 1).max(0) };
        }
        if sum > best {
            (best, best_row) = (sum, row);
        }
    }
    let enough = ENOUGH_GREEN * f32::from(frame.height() / 2);
    (best as f32 >= enough).then_some(f32::from(best_row))
}
