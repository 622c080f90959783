//! The end of the field in the image: the top of the green, column by column, then one convex line.
//!
//! In each scanned column the stretch that is greenest, lines included, gives a point: where the carpet ends. Goals,
//! robots and the ball stand in it and pull points down, never up; carpet is convex, so the upper hull of the points
//! runs over the dips. Green things in the hall pull points up; a corner of the hull that too few points support is
//! taken out.
//!
//! Cost: [`COLUMNS`] columns × half the rows, about 1 ns each, and less than 5 µs for the hull: 10 µs at 320 × 240.

use glam::Vec2;
use heapless::Vec;

use crate::colour::{Classify, Colour};
use crate::frame::Frame;

/// Scanned columns in a frame.
pub const COLUMNS: usize = 40;

/// A column needs this much more green than other colours, as a part of the scanned rows, to count.
const ENOUGH_GREEN: f32 = 0.03;
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

    /// Finds the end of the field by the green alone; no other class is asked for.
    #[must_use]
    pub fn find(frame: &Frame<'_>, colours: &impl Classify) -> Self {
        let points = column_tops(frame, colours);
        let close = CLOSE * f32::from(frame.height());
        let mut corners = upper_hull(&points);
        drop_outliers(&mut corners, &points, close);
        Self { corners }
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

fn column_tops(frame: &Frame<'_>, colours: &impl Classify) -> Vec<Vec2, COLUMNS> {
    let pitch = f32::from(frame.width()) / COLUMNS as f32;
    let columns = (0..COLUMNS).map(|column| (column as f32 + 0.5) * pitch);
    columns.filter_map(|x| Some(Vec2::new(x, column_top(frame, colours, x as u16)?))).collect()
}

/// The top of the stretch of a column with the most green over the rest: the largest sum of +1 and −1.
fn column_top(frame: &Frame<'_>, colours: &impl Classify, x: u16) -> Option<f32> {
    let (mut best, mut best_row, mut sum) = (0, 0, 0);
    for row in (0..frame.height()).rev().step_by(2) {
        let green = frame.pixel(i32::from(x), i32::from(row)).map(|p| colours.classify(p)) == Some(Colour::Green);
        sum = if green { sum + 1 } else { (sum - 1).max(0) };
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

/// How many points a line has within `close` rows.
fn support(corners: &[Vec2], points: &[Vec2], close: f32) -> usize {
    let on_line = |p: &&Vec2| line_at(corners, p.x).is_some_and(|y| (y - p.y).abs() <= close);
    points.iter().filter(on_line).count()
}

/// Takes corners out, the one that helps most first, as long as more points are close to the line without it.
fn drop_outliers(corners: &mut Vec<Vec2, COLUMNS>, points: &[Vec2], close: f32) {
    let mut left: Vec<Vec2, COLUMNS> = points.iter().copied().collect();
    let mut supported = support(corners, points, close);
    while corners.len() > 2 {
        let without = |out: &Vec2| -> (usize, Vec<Vec2, COLUMNS>, Vec<Vec2, COLUMNS>) {
            let rest: Vec<Vec2, COLUMNS> = left.iter().copied().filter(|p| p != out).collect();
            let hull = upper_hull(&rest);
            (support(&hull, points, close), hull, rest)
        };
        let Some((count, hull, rest)) = corners.iter().map(without).max_by_key(|(count, ..)| *count) else { return };
        if count <= supported {
            return;
        }
        (*corners, left, supported) = (hull, rest, count);
    }
}
