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

    /// Number of inliers minus the number of points above the line. `None` if it is below `least`. With
    /// `is_right_first` the last points are counted first.
    fn score(self, points: &Blocks, close: f32, least: i32, is_right_first: bool) -> Option<i32> {
        let mut possible = points.count;
        let is_possible = |block: &Block| {
            possible -= self.penalty(block, close);
            possible >= least
        };
        let mut blocks = points.blocks.iter();
        let is_enough = if is_right_first { blocks.rev().all(is_possible) } else { blocks.all(is_possible) };
        is_enough.then_some(possible)
    }

    /// Number of points below the line plus twice the number of points above it, without inliers.
    #[inline(always)]
    fn penalty(self, block: &Block, close: f32) -> i32 {
        let mut sums = [0; LANES];
        for (at, sum) in sums.iter_mut().enumerate() {
            let miss = block.rows[at] - self.row(block.columns[at]);
            *sum = i32::from(miss > close) + 2 * i32::from(miss < -close);
        }
        sums.iter().sum()
    }
}

/// Number of points that are compared with a line at once.
const LANES: usize = if cfg!(any(target_arch = "x86_64", target_arch = "aarch64")) { 8 } else { 1 };

/// Few points by coordinate, so that SIMD compares them. Places without a point contain NaN, which is never outside.
struct Block {
    columns: [f32; LANES],
    rows: [f32; LANES],
}

/// Points in blocks.
struct Blocks {
    blocks: Vec<Block, { COLUMNS.div_ceil(LANES) }>,
    /// Number of points.
    count: i32,
}

impl Blocks {
    fn of(points: &[Vec2]) -> Self {
        let block = |few: &[Vec2]| {
            let all = |of: fn(&Vec2) -> f32| core::array::from_fn(|at| few.get(at).map_or(f32::NAN, of));
            Block { columns: all(|point| point.x), rows: all(|point| point.y) }
        };
        Self { blocks: points.chunks(LANES).map(block).collect(), count: points.len() as i32 }
    }
}

/// Sides of the carpet, the one with the most inliers first.
fn sides(points: &[Vec2], close: f32, enough: i32) -> Vec<Side, SIDES> {
    let mut left: Vec<Vec2, COLUMNS> = points.iter().copied().collect();
    let mut taken: Vec<Vec2, COLUMNS> = Vec::new();
    let mut sides = Vec::new();
    while !sides.is_full() {
        let Some(best) = best_side(&left, &taken, close, enough) else { break };
        taken.extend(left.iter().copied().filter(|point| best.misses(*point).abs() <= close));
        left.retain(|point| best.misses(*point) > close);
        let _ = sides.push(best);
    }
    sides
}

/// Line through two points of `left` with the highest score, at least `enough`. Of equal scores, the line through the
/// last points wins.
fn best_side(left: &[Vec2], taken: &[Vec2], close: f32, enough: i32) -> Option<Side> {
    let (blocks, taken) = (Blocks::of(left), Blocks::of(taken));
    // The carpet is convex: no inlier of one side is above another side. The points far from the line's points are
    // compared first.
    let score = |side: Side, least: i32, is_right_first: bool| {
        let part = side.score(&blocks, close, least, is_right_first)?;
        let all = part + side.score(&taken, close, i32::MIN, false)?.min(0);
        (all >= least).then_some(all)
    };
    let line = |i: usize, j: usize| Side::through(left[i], left[j]);
    // A line through points far apart often has nearly the highest score, so most others are given up early.
    let last = left.len().checked_sub(1)?;
    let wide = (last > 0).then(|| line(0, last - usize::from(last.is_multiple_of(2))))?;
    let mut least = score(wide, enough, false).unwrap_or(enough);
    let mut best = None;
    let pairs = (0..left.len()).step_by(2).flat_map(|i| (i + 1..left.len()).step_by(2).map(move |j| (i, j)));
    for (i, j) in pairs.rev() {
        let side = line(i, j);
        if let Some(score) = score(side, least, i + j < last) {
            // From now on only a higher score counts.
            (best, least) = (Some(side), score + 1);
        }
    }
    best
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

#[cfg(test)]
mod tests {
    extern crate std;

    use proptest::prelude::*;

    use super::*;

    /// Reference: the scores of all lines.
    fn best_of_all(left: &[Vec2], taken: &[Vec2], close: f32, enough: i32) -> Option<Side> {
        let vote = |miss: f32| if miss < -close { -1 } else { i32::from(miss <= close) };
        let votes = |side: Side, points: &[Vec2]| points.iter().map(|point| vote(side.misses(*point))).sum::<i32>();
        let pairs = (0..left.len()).step_by(2).flat_map(|i| (i + 1..left.len()).step_by(2).map(move |j| (i, j)));
        let lines = pairs.map(|(i, j)| Side::through(left[i], left[j]));
        let scores = lines.map(|side| (votes(side, left) + votes(side, taken).min(0), side));
        scores.max_by_key(|(score, _)| *score).filter(|(score, _)| *score >= enough).map(|(_, side)| side)
    }

    /// Points of a line with two slopes and outliers, in whole rows.
    fn points() -> impl Strategy<Value = std::vec::Vec<Vec2>> {
        let outlier = prop_oneof![3 => Just(0_i8), 1 => -20..20_i8];
        let rows = prop::collection::vec((outlier, -1..=1_i8), 0..COLUMNS);
        (rows, -1.0..1.0_f32, -1.0..1.0_f32, 0..COLUMNS).prop_map(|(rows, before, after, corner)| {
            let row = |column: usize| {
                let way = column as f32 - corner as f32;
                libm::roundf(60.0 + way * if column < corner { before } else { after })
            };
            let point = |(column, (outlier, error)): (usize, &(i8, i8))| {
                Vec2::new(8.0 * column as f32, row(column) + f32::from(*outlier) + f32::from(*error))
            };
            rows.iter().enumerate().map(point).collect()
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(500))]

        #[test]
        fn best_side_is_that_of_all_lines(points in points(), split in 0..COLUMNS, enough in 0..12) {
            let (taken, left) = points.split_at(split.min(points.len()));
            for (left, taken) in [(left, taken), (&points[..], &[][..])] {
                let (found, best) = (best_side(left, taken, 1.8, enough), best_of_all(left, taken, 1.8, enough));
                prop_assert_eq!(found.map(|side| (side.start, side.slope)), best.map(|side| (side.start, side.slope)));
            }
        }
    }
}
