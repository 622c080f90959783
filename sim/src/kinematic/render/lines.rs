//! Signed distance map of the field lines.

use glam::Vec2;

use crate::camera::pinhole::{LANES, round_wrapping};
use crate::field::{CARPET, CIRCLE, CORNER, LINE_WIDTH, MARK, PENALTY_AREA, PENALTY_MARK};

/// Resolution of the map, m.
const STEP: f32 = 0.01;
/// Number of points along x: one quadrant of the carpet, since the lines are symmetric.
const COLUMNS: usize = (CARPET.x / STEP) as usize + 2;
/// Number of points along y.
const ROWS: usize = (CARPET.y / STEP) as usize + 2;
/// Unit of the stored distances, m: they reach ±63.5 mm.
const UNIT: f32 = 0.0005;
/// Number of points from one row of the map to the next.
const STRIDE: usize = COLUMNS.next_power_of_two();
/// Resolution of the coarse map, m.
const COARSE: f32 = 0.05;
/// Number of points of the coarse map along x.
const COARSE_COLUMNS: usize = (CARPET.x / COARSE) as usize + 2;
/// Number of points of the coarse map along y.
const COARSE_ROWS: usize = (CARPET.y / COARSE) as usize + 2;

/// Signed distances to the edges of the lines: negative on a line.
#[derive(Clone, Debug)]
pub(crate) struct LineMap {
    distances: Vec<i8>,
    /// Lower bound of the distance to a line within the cell of each coarse point, m.
    clearances: Vec<f32>,
}

impl LineMap {
    pub(crate) fn new() -> Self {
        let mut distances = vec![0; STRIDE * ROWS];
        for (i, distance) in distances.iter_mut().enumerate() {
            let point = Vec2::new((i % STRIDE) as f32, (i / STRIDE) as f32) * STEP;
            *distance = libm::roundf(exact(point) / UNIT).clamp(-127.0, 127.0) as i8;
        }
        let clearance = |i: usize| {
            let point = Vec2::new((i % COARSE_COLUMNS) as f32, (i / COARSE_COLUMNS) as f32) * COARSE;
            exact(point) - COARSE
        };
        Self { distances, clearances: (0..COARSE_COLUMNS * COARSE_ROWS).map(clearance).collect() }
    }

    /// Returns the radius of a disc around a point of the carpet without a line, m; may be negative.
    pub(crate) fn clearance(&self, point: Vec2) -> f32 {
        let index =
            |x: f32, most: usize| (round_wrapping((x.abs() * (1.0 / COARSE)).min(most as f32)) as usize).min(most);
        let (column, row) = (index(point.x, COARSE_COLUMNS - 1), index(point.y, COARSE_ROWS - 1));
        self.clearances[row * COARSE_COLUMNS + column]
    }

    /// Looks up the nearest points of the map for [`LANES`] points of the carpet.
    pub(crate) fn nearest(&self, x: &[f32; LANES], y: &[f32; LANES]) -> Nearest {
        let most = |count: usize| count as f32 - 1.0;
        let mut places = [0; LANES];
        for i in 0..LANES {
            let column = round_wrapping((x[i].abs() * (1.0 / STEP)).min(most(COLUMNS)));
            let row = round_wrapping((y[i].abs() * (1.0 / STEP)).min(most(ROWS)));
            places[i] = row * STRIDE as u32 + column;
        }
        Nearest(places.map(|place| self.distances[place as usize % (STRIDE * ROWS)]))
    }

    /// Returns the fraction of a round spot on the carpet that is line, 0 to 1. `spot`: its width, m.
    pub(crate) fn share(&self, x: f32, y: f32, spot: f32) -> f32 {
        (0.5 - self.distance(x, y) / spot).clamp(0.0, 1.0)
    }

    /// Returns the distance by bilinear interpolation, m.
    fn distance(&self, x: f32, y: f32) -> f32 {
        let most = |count: usize| count as f32 - 1.001;
        let (x, y) = ((x.abs() / STEP).min(most(COLUMNS)), (y.abs() / STEP).min(most(ROWS)));
        let (column, row) = (round_wrapping(x - 0.5), round_wrapping(y - 0.5));
        let (right, up) = (x - column as f32, y - row as f32);
        let start = (row as usize * STRIDE + column as usize).min(STRIDE * (ROWS - 1) - 2);
        let at = |i: usize| self.distances[start + i] as f32;
        let near = at(0) + right * (at(1) - at(0));
        let far = at(STRIDE) + right * (at(STRIDE + 1) - at(STRIDE));
        (near + up * (far - near)) * UNIT
    }
}

/// Distances at the nearest points of the map: errors up to about half of its resolution.
pub(crate) struct Nearest([i8; LANES]);

impl Nearest {
    /// Returns the fraction of a spot around a point that is line; `None` unless it is certainly 0 or 1. `spot`: its width, m.
    pub(crate) fn certain_share(&self, index: usize, spot: f32) -> Option<f32> {
        let distance = self.0[index] as f32 * UNIT;
        (distance.abs() > spot / 2.0 + STEP).then_some(if distance < 0.0 { 1.0 } else { 0.0 })
    }

    /// Adds to each sum the fraction of a spot around the point that is line. `spot`: its width, m, wider than the resolution
    /// of the map.
    pub(crate) fn add_shares(&self, spot: f32, sums: &mut [f32; LANES]) {
        let scale = UNIT / spot;
        for (sum, &distance) in sums.iter_mut().zip(&self.0) {
            *sum += (0.5 - distance as f32 * scale).clamp(0.0, 1.0);
        }
    }
}

/// Computes the signed distance, m, for a point in the quadrant of positive coordinates.
fn exact(point: Vec2) -> f32 {
    let half = LINE_WIDTH / 2.0;
    let bar = |centre: Vec2, size: Vec2| {
        let out = (point - centre).abs() - size;
        out.max(Vec2::ZERO).length() + out.max_element().min(0.0)
    };
    let to_x = |y: f32, from: f32, to: f32| {
        bar(Vec2::new(f32::midpoint(from, to), y), Vec2::new((to - from) / 2.0 + half, half))
    };
    let to_y = |x: f32, to: f32| bar(Vec2::new(x, 0.0), Vec2::new(half, to + half));
    let plus = |x: f32| {
        let centre = Vec2::new(x, 0.0);
        bar(centre, Vec2::new(MARK / 2.0, half)).min(bar(centre, Vec2::new(half, MARK / 2.0)))
    };
    let all = [
        to_x(CORNER.y, 0.0, CORNER.x),
        to_y(CORNER.x, CORNER.y),
        to_y(0.0, CORNER.y),
        to_y(PENALTY_AREA.x, PENALTY_AREA.y),
        to_x(PENALTY_AREA.y, PENALTY_AREA.x, CORNER.x),
        (point.length() - CIRCLE).abs() - half,
        plus(PENALTY_MARK),
        plus(0.0),
    ];
    all.into_iter().fold(f32::INFINITY, f32::min)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Random, Stream};

    #[test]
    fn lines_are_where_rules_put_them() {
        let map = LineMap::new();
        let share = |x, y| map.share(x, y, 0.004);
        for (x, y) in
            [(3.0, 1.0), (-3.0, 0.0), (1.0, 2.0), (0.0, -1.2), (2.4, 1.0), (-2.7, 1.5), (0.6, 0.0), (1.2, 0.04)]
        {
            assert_eq!(share(x, y), 1.0, "{x} {y}");
        }
        for (x, y) in [(3.06, 1.0), (2.95, 1.7), (0.5, 0.5), (1.2, 0.08), (2.7, 1.4), (3.0, 2.06), (0.3, 0.0)] {
            assert_eq!(share(x, y), 0.0, "{x} {y}");
        }
        assert!((map.share(3.025, 1.0, 0.01) - 0.5).abs() < 0.051);
    }

    #[test]
    fn clearances_are_lower_bounds() {
        let map = LineMap::new();
        let mut random = Random::new(6, Stream::Start);
        let mut certain = 0;
        for _ in 0..20_000 {
            let point = Vec2::new(random.between(-3.7, 3.7), random.between(-2.7, 2.7));
            assert!(map.clearance(point) <= exact(point.abs()), "{point}");
            assert!(map.clearance(point) > exact(point.abs()) - 2.0 * COARSE, "{point}");
            let spot = random.between(0.01, 0.1);
            let share = map.nearest(&[point.x; LANES], &[point.y; LANES]).certain_share(3, spot);
            if let Some(share) = share {
                certain += 1;
                assert_eq!(share, map.share(point.x, point.y, spot), "{point}");
            }
        }
        assert!((14_000..20_000).contains(&certain), "{certain}");
    }

    #[test]
    fn points_outside_carpet_or_not_finite_are_handled() {
        let map = LineMap::new();
        for x in [1e9, -1e9, f32::INFINITY, f32::NAN] {
            assert!(map.clearance(Vec2::new(x, 2.5)).is_finite());
            assert_eq!(map.nearest(&[x; LANES], &[2.5; LANES]).certain_share(0, 0.05), Some(0.0));
            assert!(map.share(x, 2.5, 0.01).is_finite());
        }
    }
}
