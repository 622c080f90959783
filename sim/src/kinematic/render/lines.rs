//! How far every point of the carpet is from the edge of a line.

use bica_field::FIELD;
use glam::Vec2;

use crate::camera::pinhole::{LANES, whole};

const CARPET: Vec2 = FIELD.carpet_corner();
const CIRCLE: f32 = FIELD.centre_circle_radius();
const CORNER: Vec2 = FIELD.field_corner();
const LINE_WIDTH: f32 = FIELD.line_width();
const MARK: f32 = FIELD.penalty_mark_size();
const PENALTY_AREA: Vec2 = FIELD.penalty_area_corner();
const PENALTY_MARK: f32 = FIELD.penalty_mark();

/// Distance between neighbouring points of the map, m.
const STEP: f32 = 0.01;
/// Points along x and y: a quarter of the carpet, since the lines are symmetric.
const SIZE: (usize, usize) = ((CARPET.x / STEP) as usize + 2, (CARPET.y / STEP) as usize + 2);
/// The map's unit, m: distances reach ±63.5 mm.
const UNIT: f32 = 0.0005;
/// Points from one row of the map to the next.
const STRIDE: usize = SIZE.0.next_power_of_two();
/// Distance between neighbouring points of the coarse map, m, and how many there are along x and y.
const COARSE: f32 = 0.05;
const COARSE_SIZE: (usize, usize) = ((CARPET.x / COARSE) as usize + 2, (CARPET.y / COARSE) as usize + 2);

/// Signed distances to the lines: negative on them.
#[derive(Clone, Debug)]
pub(crate) struct LineMap {
    distances: Vec<i8>,
    /// How far it is to the nearest line at least, anywhere nearest to a coarse point, m.
    rooms: Vec<f32>,
}

impl LineMap {
    pub(crate) fn new() -> Self {
        let mut distances = vec![0; STRIDE * SIZE.1];
        for (i, distance) in distances.iter_mut().enumerate() {
            let point = Vec2::new((i % STRIDE) as f32, (i / STRIDE) as f32) * STEP;
            *distance = libm::roundf(exact(point) / UNIT).clamp(-127.0, 127.0) as i8;
        }
        let room = |i: usize| {
            let point = Vec2::new((i % COARSE_SIZE.0) as f32, (i / COARSE_SIZE.0) as f32) * COARSE;
            exact(point) - COARSE
        };
        Self { distances, rooms: (0..COARSE_SIZE.0 * COARSE_SIZE.1).map(room).collect() }
    }

    /// A radius around a point of the carpet in which there is no line, m; may be negative.
    pub(crate) fn room_around(&self, point: Vec2) -> f32 {
        let index = |x: f32, most: usize| (whole((x.abs() * (1.0 / COARSE)).min(most as f32)) as usize).min(most);
        let (column, row) = (index(point.x, COARSE_SIZE.0 - 1), index(point.y, COARSE_SIZE.1 - 1));
        self.rooms[row * COARSE_SIZE.0 + column]
    }

    /// What the map's nearest points say about many points of the carpet.
    pub(crate) fn nearest(&self, x: &[f32; LANES], y: &[f32; LANES]) -> Nearest {
        let most = |count: usize| count as f32 - 1.0;
        let mut places = [0; LANES];
        for i in 0..LANES {
            let column = whole((x[i].abs() * (1.0 / STEP)).min(most(SIZE.0)));
            let row = whole((y[i].abs() * (1.0 / STEP)).min(most(SIZE.1)));
            places[i] = row * STRIDE as u32 + column;
        }
        Nearest(places.map(|place| self.distances[place as usize % (STRIDE * SIZE.1)]))
    }

    /// Which share of a round spot on the carpet is line, 0 to 1. `spot` is its width, m.
    pub(crate) fn share(&self, x: f32, y: f32, spot: f32) -> f32 {
        (0.5 - self.distance(x, y) / spot).clamp(0.0, 1.0)
    }

    /// Bilinear between the map's points, m.
    fn distance(&self, x: f32, y: f32) -> f32 {
        let most = |count: usize| count as f32 - 1.001;
        let (x, y) = ((x.abs() / STEP).min(most(SIZE.0)), (y.abs() / STEP).min(most(SIZE.1)));
        let (column, row) = (whole(x - 0.5), whole(y - 0.5));
        let (right, up) = (x - column as f32, y - row as f32);
        let start = (row as usize * STRIDE + column as usize).min(STRIDE * (SIZE.1 - 1) - 2);
        let at = |i: usize| self.distances[start + i] as f32;
        let near = at(0) + right * (at(1) - at(0));
        let far = at(STRIDE) + right * (at(STRIDE + 1) - at(STRIDE));
        (near + up * (far - near)) * UNIT
    }
}

/// Distances to the lines, to half a step or so.
pub(crate) struct Nearest([i8; LANES]);

impl Nearest {
    /// Which share of a spot around the point of that index is line, if it is all or nothing for certain. `spot` is its
    /// width, m.
    pub(crate) fn sure_share(&self, index: usize, spot: f32) -> Option<f32> {
        let distance = self.0[index] as f32 * UNIT;
        (distance.abs() > spot / 2.0 + STEP).then_some(if distance < 0.0 { 1.0 } else { 0.0 })
    }

    /// Adds to every point's sum which share of a spot around it is line, 0 to 1. `spot` is its width, m, wider than the
    /// map's steps.
    pub(crate) fn add_shares(&self, spot: f32, sums: &mut [f32; LANES]) {
        let scale = UNIT / spot;
        for (sum, &distance) in sums.iter_mut().zip(&self.0) {
            *sum += (0.5 - distance as f32 * scale).clamp(0.0, 1.0);
        }
    }
}

/// The distance itself, m; the point in the quarter of positive coordinates.
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
    fn lines_are_where_the_rules_put_them() {
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
    fn rooms_hold_no_line_and_coarse_answers_agree_with_fine_ones() {
        let map = LineMap::new();
        let mut random = Random::new(6, Stream::Start);
        for _ in 0..20_000 {
            let point = Vec2::new(random.between(-3.7, 3.7), random.between(-2.7, 2.7));
            assert!(map.room_around(point) <= exact(point.abs()), "{point}");
            assert!(map.room_around(point) > exact(point.abs()) - 2.0 * COARSE, "{point}");
            let spot = random.between(0.01, 0.1);
            let share = map.nearest(&[point.x; LANES], &[point.y; LANES]).sure_share(3, spot);
            assert!(share.is_none_or(|share| share == map.share(point.x, point.y, spot)), "{point}");
        }
    }

    #[test]
    fn points_beyond_the_carpet_or_no_numbers_do_no_harm() {
        let map = LineMap::new();
        for x in [1e9, -1e9, f32::INFINITY, f32::NAN] {
            assert!(map.room_around(Vec2::new(x, 2.5)).is_finite());
            assert_eq!(map.nearest(&[x; LANES], &[2.5; LANES]).sure_share(0, 0.05), Some(0.0));
            assert!(map.share(x, 2.5, 0.01).is_finite());
        }
    }
}
