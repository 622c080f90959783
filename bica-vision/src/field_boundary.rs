//! Field boundary in the image (the paper's "end of field"): the top of the green in each column, then a convex line.
//!
//! In each scanned column the greenest stretch, lines included, gives a point: the edge of the carpet. With a known camera pose
//! nothing above the horizon is carpet. Goals, robots and the ball occlude the edge and move points down; green objects in the hall
//! move them up. The boundary is the convex line of one to three straight sides with the most inliers.
//!
//! Cost: [`COLUMNS`] columns × half the rows, about 2 ns each, and up to 200 lines × 40 points for each side: 16 µs at 320 × 240.

mod hull;

use bica_core::Params;
use bica_macros::Params;
use glam::Vec2;
use heapless::Vec;

use crate::colour::{Classify, Colour};
use crate::frame::Frame;
use crate::projection::Camera;

/// Number of scanned columns.
pub const COLUMNS: usize = 40;

/// Tolerated error of the camera's pitch, rad.
const PITCH_ERROR: f32 = 0.035;

/// Detection of the field boundary.
#[derive(Clone, Copy, Debug, PartialEq, Params)]
#[params(crate = bica_core)]
pub struct BoundaryDetection {
    /// Minimum excess of green over other colours in a column, as a share of its scanned pixels.
    #[param(default = 0.03, range = 0.0..=0.5, step = 0.005)]
    pub min_green: f32,
    /// Length of a gap in the green that ends the carpet, as a share of the image height.
    #[param(default = 0.025, range = 0.0..=0.5, step = 0.005)]
    pub max_gap: f32,
    /// Maximum distance of an inlier from a side of the carpet, as a share of the image height.
    #[param(default = 0.015, range = 0.001..=0.1, step = 0.001)]
    pub inlier_distance: f32,
    /// Minimum score of a side of the carpet: number of inlying columns, of 40, minus number of columns above it.
    #[param(default = 4, range = 1..=40)]
    pub min_score: i32,
}

/// Field boundary from the left to the right image edge.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FieldBoundary {
    corners: Vec<Vec2, COLUMNS>,
    /// Lowest row of each scanned column that may not be green; all scanned rows below it are green.
    green_below: Vec<u16, COLUMNS>,
}

impl FieldBoundary {
    /// No field in view.
    pub const NONE: Self = Self { corners: Vec::new(), green_below: Vec::new() };

    /// Finds the field boundary from green and white pixels alone.
    #[must_use]
    pub fn find(frame: &Frame<'_>, colours: &impl Classify) -> Self {
        Self::find_with(frame, colours, None)
    }

    /// Finds the field boundary as [`find`](Self::find) does. With `camera`, ignores rows more than 2° above the horizon.
    #[must_use]
    pub fn find_with(frame: &Frame<'_>, colours: &impl Classify, camera: Option<&Camera>) -> Self {
        Self::find_tuned(frame, colours, camera, &BoundaryDetection::DEFAULT)
    }

    /// Finds the field boundary as [`find_with`](Self::find_with) does, with thresholds of the caller.
    #[must_use]
    pub fn find_tuned(
        frame: &Frame<'_>,
        colours: &impl Classify,
        camera: Option<&Camera>,
        tuning: &BoundaryDetection,
    ) -> Self {
        let (mut points, mut green_below) = (Vec::<Vec2, COLUMNS>::new(), Vec::new());
        for x in columns(frame.width()) {
            let column = Column::scan(frame, colours, x as u16, highest_row(camera, x), tuning);
            points.extend(column.top.map(|top| Vec2::new(x, top)));
            green_below.extend([column.green_below]);
        }
        let (width, height) = (f32::from(frame.width()), f32::from(frame.height()));
        let corners = hull::over(&points, (0.0, width - 1.0), tuning.inlier_distance * height, tuning.min_score);
        Self { corners, green_below }
    }

    /// Scans the columns as [`find_tuned`](Self::find_tuned) does, for a view of the search. Returns x of each column
    /// and the row of the carpet's edge; `None` if there is too little green.
    pub fn scan(
        frame: &Frame<'_>,
        colours: &impl Classify,
        tuning: &BoundaryDetection,
    ) -> impl Iterator<Item = (f32, Option<f32>)> {
        columns(frame.width()).map(move |x| (x, Column::scan(frame, colours, x as u16, 0, tuning).top))
    }

    /// Corners, px, from the left; empty if no field is in view.
    #[must_use]
    pub fn corners(&self) -> &[Vec2] {
        &self.corners
    }

    /// Row of the boundary in a column. `None` if no field is in view.
    #[must_use]
    pub fn row_at(&self, x: f32) -> Option<f32> {
        hull::line_at(&self.corners, x)
    }

    /// Lowest row of a scanned column, by its number from the left, that may not be green; all scanned rows below it are green.
    pub(crate) fn green_below(&self, column: usize) -> u16 {
        self.green_below.get(column).copied().unwrap_or(u16::MAX)
    }

    /// The same boundary without knowledge of its columns.
    #[cfg(test)]
    pub(crate) fn without_columns(&self) -> Self {
        Self { corners: self.corners.clone(), ..Self::NONE }
    }

    /// Highest row of the boundary; the field is below it. `None` if no field is in view.
    #[must_use]
    pub fn top(&self) -> Option<f32> {
        self.corners.iter().map(|corner| corner.y).reduce(f32::min)
    }

    /// Whether a point is on the field, or at most `margin` px above the boundary. False if no field is in view.
    #[must_use]
    pub fn is_below(&self, x: f32, y: f32, margin: f32) -> bool {
        self.row_at(x).is_some_and(|end| y >= end - margin)
    }

    /// Whether the image of a camera shows the field at a position in the ground frame, m. Positions beside, above or behind the
    /// image are not on the field, those below it are: the feet hide them.
    #[must_use]
    pub fn shows_field(&self, camera: &Camera, at: Vec2) -> bool {
        let size = 2.0 * camera.intrinsics().centre;
        let Some(pixel) = camera.pixel(at.extend(0.0)) else { return false };
        pixel.y >= size.y || (0.0..size.x).contains(&pixel.x) && pixel.y >= 0.0 && self.is_below(pixel.x, pixel.y, 0.0)
    }
}

/// Middles of the scanned columns of a frame of a width, px.
pub(crate) fn columns(width: u16) -> impl Iterator<Item = f32> {
    let pitch = f32::from(width) / COLUMNS as f32;
    (0..COLUMNS).map(move |column| (column as f32 + 0.5) * pitch)
}

/// Highest row that may show carpet in a column.
fn highest_row(camera: Option<&Camera>, x: f32) -> u16 {
    let row = camera.and_then(|camera| Some(camera.horizon(x)? - PITCH_ERROR * camera.intrinsics().focal.y));
    row.map_or(0, |row| row.max(0.0) as u16)
}

/// Green of a column.
struct Column {
    /// Top of the stretch with the most green, if it has enough.
    top: Option<f32>,
    /// Row of the lowest pixel that is not green; an unscanned row if all are green.
    green_below: u16,
}

impl Column {
    /// Scans a column upwards. The stretch with the most green is the maximum prefix sum of +1 (green) and −1 (other). A gap of
    /// other colours than white longer than `max_gap` ends a stretch.
    fn scan(frame: &Frame<'_>, colours: &impl Classify, x: u16, highest: u16, tuning: &BoundaryDetection) -> Self {
        let longest = (tuning.max_gap * f32::from(frame.height() / 2)) as u16;
        let (mut best, mut best_row, mut sum, mut gap) = (0_u16, 0, 0_u16, 0);
        let mut green_below = highest;
        for (row, pixel) in frame.column(x).upwards(highest) {
            let class = colours.classify(pixel);
            if class == Colour::Green {
                (sum, gap) = (sum + 1, 0);
                continue;
            }
            green_below = green_below.max(row);
            if sum > best {
                (best, best_row) = (sum, row + 2);
            }
            if class == Colour::White {
                sum = sum.saturating_sub(1);
            } else {
                gap += 1;
                sum = if gap > longest { 0 } else { sum.saturating_sub(1) };
            }
            // Even if all rows above were green, they would not be a better stretch.
            if sum + (row - highest) / 2 <= best {
                break;
            }
        }
        if sum > best {
            // The highest scanned row is green.
            (best, best_row) = (sum, highest + (frame.height() - 1 - highest) % 2);
        }
        let enough = tuning.min_green * f32::from(frame.height() / 2);
        let top = (f32::from(best) >= enough).then_some(f32::from(best_row));
        Self { top, green_below }
    }
}
