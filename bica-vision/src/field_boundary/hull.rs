//! Convex line through points with outliers.
//!
//! At most three straight sides of the carpet are in view. Each is a line through two points with many inliers. Points
//! above the line count against it; points below do not, because of obstacles and the next side.

use glam::Vec2;
use heapless::Vec;

use super::COLUMNS;

/// Maximum number of carpet sides in view.
const SIDES: usize = 3;

/// Convex line over points ordered by x, from the first to the last column of `ends`; empty without points. Inliers of a
/// side are at most `close` rows away; a side has at least the score `enough`.
pub(super) fn over(points: &[Vec2], ends: (f32, f32), close: f32, enough: i32) -> Vec<Vec2, COLUMNS> {
    let sides = sides(points, close, enough);
    let on_side = |point: &&Vec2| sides.is_empty() || sides.iter().any(|side| side.misses(**point).abs() <= close);
    let mut hull = upper_hull(points.iter().filter(on_side));
    extend(&mut hull, &sides, ends);
    hull
}

/// Row of the line in a column; constant beyond its ends.
pub(super) fn line_at(corners: &[Vec2], x: f32) -> Option<f32> {
    let (first, last) = (corners.first()?, corners.last()?);
    if x <= first.x {
        return Some(first.y);
    }
    let after = corners.iter().position(|corner| corner.x >= x);
    let Some(after) = after else { return Some(last.y) };
    Some(Side::through(corners[after - 1], corners[after]).row(x))
}

/// Straight line.
#[derive(Clone, Copy)]
struct Side {
    start: Vec2,
    slope: f32,
}

impl Side {
    /// Line through two points with different x.
    fn through(a: Vec2, b: Vec2) -> Self {
        Self { start: a, slope: (b.y - a.y) / (b.x - a.x) }
    }

    fn row(self, x: f32) -> f32 {
        self.start.y + self.slope * (x - self.start.x)
    }

    /// Distance of a point below the line, rows; negative above it.
    fn misses(self, point: Vec2) -> f32 {
        point.y - self.row(point.x)
    }

    /// Number of inliers minus the number of points above the line.
    fn score(self, points: &[Vec2], close: f32) -> i32 {
        let vote = |point: &Vec2| {
            let miss = self.misses(*point);
            i32::from(miss >= -close) - i32::from(miss > close) - i32::from(miss < -close)
        };
        points.iter().map(vote).sum()
    }
}

/// Sides of the carpet, the one with the most inliers first.
fn sides(points: &[Vec2], close: f32, enough: i32) -> Vec<Side, SIDES> {
    let mut left: Vec<Vec2, COLUMNS> = points.iter().copied().collect();
    let mut taken: Vec<Vec2, COLUMNS> = Vec::new();
    let mut sides = Vec::new();
    while !sides.is_full() {
        let pairs = (0..left.len()).step_by(2).flat_map(|i| (i + 1..left.len()).step_by(2).map(move |j| (i, j)));
        let lines = pairs.map(|(i, j)| Side::through(left[i], left[j]));
        // The carpet is convex: no inlier of one side is above another side.
        let score = |side: &Side| side.score(&left, close) + side.score(&taken, close).min(0);
        let Some((score, best)) = lines.map(|side| (score(&side), side)).max_by_key(|(score, _)| *score) else { break };
        if score < enough {
            break;
        }
        taken.extend(left.iter().copied().filter(|point| best.misses(*point).abs() <= close));
        left.retain(|point| best.misses(*point) > close);
        let _ = sides.push(best);
    }
    sides
}

/// Upper convex hull of points ordered by x.
fn upper_hull<'a>(points: impl Iterator<Item = &'a Vec2>) -> Vec<Vec2, COLUMNS> {
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

/// Extends the sides to the columns of `ends`, where obstacles hide the field.
fn extend(hull: &mut Vec<Vec2, COLUMNS>, sides: &[Side], ends: (f32, f32)) {
    let row = |x: f32| sides.iter().map(|side| side.row(x)).reduce(f32::max);
    for (x, place) in [(ends.0, 0), (ends.1, hull.len() + 1)] {
        if let Some(row) = row(x) {
            let _ = hull.insert(place.min(hull.len()), Vec2::new(x, row.max(0.0)));
        }
    }
}
