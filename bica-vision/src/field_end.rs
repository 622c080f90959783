//! The end of the field in the image: the top of the green, column by column, then one convex line.
//!
//! In each scanned column the stretch that is greenest, lines included, gives a point: where the carpet ends. Nothing
//! above the horizon is carpet, if the camera's pose is known. Goals, robots and the ball stand in it and pull points
//! down, never up; carpet is convex, so the upper hull of the points runs over the dips. Green things in the hall pull
//! points up; what stands out most is taken out as long as more points fit the line without it.
//!
//! Cost: [`COLUMNS`] columns × half the rows, about 2 ns each, and 1 µs for each point that is taken out, at most ten:
//! 12 µs at 320 × 240.

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
/// Points that may be taken out.
const PEELS: usize = 10;
/// A line that falls more than this for each column is the side of an obstacle.
const STEEP: f32 = 2.5;
/// A point within this part of the frame's height belongs to the line.
const CLOSE: f32 = 0.015;

/// The line at which the field ends, from the left edge of the image to the right one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FieldEnd {
    corners: Vec<Vec2, COLUMNS>,
}

impl FieldEnd {
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
        let close = CLOSE * f32::from(frame.height());
        Self { corners: robust_hull(&points, close) }
    }

    /// The corners of the line in pixels, from the left; empty if no field is in sight.
    #[must_use]
    pub fn corners(&self) -> &[Vec2] {
        &self.corners
    }

    /// The row at which the field ends in a column; beyond the first and last corner level with that one. None if no
    /// field is in sight.
    #[must_use]
    pub fn row_at(&self, x: f32) -> Option<f32> {
        line_at(&self.corners, x)
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

/// The upper convex hull of points ordered by x.
fn upper_hull(points: &[Vec2]) -> Vec<Vec2, COLUMNS> {
    let mut hull: Vec<Vec2, COLUMNS> = Vec::new();
    for point in points {
        while let [.., a, b] = hull.as_slice()
            && (b.y - a.y) * (point.x - a.x) >= (point.y - a.y) * (b.x - a.x)
        {
            hull.pop();
        }
        let _ = hull.push(*point);
    }
    hull
}

fn line_at(corners: &[Vec2], x: f32) -> Option<f32> {
    let (first, last) = (corners.first()?, corners.last()?);
    if x <= first.x {
        return Some(first.y);
    }
    let after = corners.iter().position(|corner| corner.x >= x);
    let Some(after) = after else { return Some(last.y) };
    let (a, b) = (corners[after - 1], corners[after]);
    Some(a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x))
}

/// Takes corners off either end that the line falls down to: there something stands before the field.
fn drop_obstacles(corners: &mut Vec<Vec2, COLUMNS>) {
    let falls = |from: Vec2, to: Vec2| to.y - from.y > STEEP * (to.x - from.x).abs();
    while let [.., before, last] = corners.as_slice()
        && falls(*before, *last)
    {
        corners.pop();
    }
    let first = corners.windows(2).take_while(|edge| falls(edge[1], edge[0])).count();
    corners.rotate_left(first);
    corners.truncate(corners.len() - first);
}

/// How many points a line has within `close` rows.
fn support(corners: &[Vec2], points: &[Vec2], close: f32) -> usize {
    let on_line = |p: &&Vec2| line_at(corners, p.x).is_some_and(|y| (y - p.y).abs() <= close);
    points.iter().filter(on_line).count()
}

/// How far one of at least three corners stands out above the line of its neighbours, at an end above that of the next
/// two; rows.
fn protrusion(corners: &[Vec2], index: usize) -> f32 {
    let last = corners.len() - 1;
    let (a, b) = match index {
        0 => (1, 2),
        _ if index == last => (last - 1, last - 2),
        _ => (index - 1, index + 1),
    };
    let (a, b, corner) = (corners[a], corners[b], corners[index]);
    a.y + (b.y - a.y) * (corner.x - a.x) / (b.x - a.x) - corner.y
}

/// The upper hull of the points as far as it is no obstacle's side.
fn line_over(points: &[Vec2]) -> Vec<Vec2, COLUMNS> {
    let mut hull = upper_hull(points);
    drop_obstacles(&mut hull);
    hull
}

/// The hull of the points, without those that stand out, if more points are close to the line then.
fn robust_hull(points: &[Vec2], close: f32) -> Vec<Vec2, COLUMNS> {
    let mut left: Vec<Vec2, COLUMNS> = points.iter().copied().collect();
    let mut hull = line_over(&left);
    let (mut best, mut supported) = (hull.clone(), support(&hull, points, close));
    for _ in 0..PEELS {
        let standing_out = (0..hull.len()).filter(|_| hull.len() > 2);
        let corner = standing_out.max_by(|a, b| protrusion(&hull, *a).total_cmp(&protrusion(&hull, *b)));
        let Some(corner) = corner.filter(|_| supported < points.len()) else { break };
        let out = hull[corner];
        left.retain(|point| *point != out);
        hull = line_over(&left);
        let count = support(&hull, points, close);
        if count > supported {
            (best, supported) = (hull.clone(), count);
        }
    }
    best
}
