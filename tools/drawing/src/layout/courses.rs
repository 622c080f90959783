//! Courses of links: down through the gaps of rows, aside in the corridors between them.

use std::fmt::Write;

use super::rows::apart;
use super::{Point, Rectangle};

/// Cost of a part of a corridor that another link of the trunk has taken, as a share of its length.
const SHARED: f64 = 0.05;
/// Cost of one more passage through a row, px.
const PASSAGE: f64 = 14.0;
/// Distance by which a course may lead away from both of its ends, px.
const ASIDE: f64 = 260.0;
/// White between a box and a line, px.
const CLEAR: f64 = 3.0;
/// Radius of a corner, px.
const RADIUS: f64 = 5.0;

/// The free intervals of a row from `left` to `right`.
pub(super) fn gaps<'a>(row: impl Iterator<Item = &'a Rectangle>, left: f64, right: f64) -> Vec<(f64, f64)> {
    let mut row: Vec<(f64, f64)> = row.map(|one| (one.x - one.width / 2.0, one.x + one.width / 2.0)).collect();
    row.sort_by(|a, b| a.0.total_cmp(&b.0));
    let starts = [left].into_iter().chain(row.iter().map(|(_, end)| end + CLEAR));
    let ends = row.iter().map(|(start, _)| start - CLEAR).chain([right]);
    starts.zip(ends).filter(|(start, end)| end - start > 1.0).collect()
}

/// What the courses of several links share, by row.
pub(super) struct Trunk {
    /// x of the passages through each row.
    passes: Vec<Vec<f64>>,
    /// Taken parts of the corridor below each row.
    spans: Vec<Vec<(f64, f64)>>,
}

impl Trunk {
    pub(super) fn new(rows: usize) -> Self {
        Self { passes: vec![Vec::new(); rows], spans: vec![Vec::new(); rows] }
    }

    /// The cheapest course between two rows (dynamic programming over the rows): x at the upper end, in each row that is passed,
    /// and at the lower end.
    pub(super) fn course(&mut self, from: (f64, usize), to: (f64, usize), gaps: &[Vec<(f64, f64)>]) -> Vec<f64> {
        let ends = [from.0, to.0];
        let (low, high) = (from.0.min(to.0) - ASIDE, from.0.max(to.0) + ASIDE);
        let mut layers = vec![vec![Step { x: from.0, cost: 0.0, before: 0 }]];
        for (row, free) in gaps.iter().enumerate().take(to.1).skip(from.1 + 1) {
            let near = || free.iter().filter(|gap| gap.1 >= low && gap.0 <= high);
            let all: Vec<(f64, f64)> = if near().next().is_some() { near().copied().collect() } else { free.clone() };
            let mut places: Vec<f64> = Vec::new();
            for (start, end) in all {
                let known = places.len();
                places.extend(ends.into_iter().filter(|x| (start..=end).contains(x)));
                if places.len() == known {
                    places.push(f64::midpoint(start, end));
                }
            }
            places.extend(&self.passes[row]);
            if places.is_empty() {
                places.push(f64::midpoint(from.0, to.0));
            }
            let cost = |x: &f64| if self.passes[row].contains(x) { 0.0 } else { PASSAGE };
            layers.push(places.iter().map(|x| self.step(&layers[layers.len() - 1], *x, row, cost(x))).collect());
        }
        let mut step = self.step(&layers[layers.len() - 1], to.0, to.1, 0.0);
        let mut xs = vec![to.0];
        for layer in layers.iter().rev() {
            step = layer[step.before];
            xs.insert(0, step.x);
        }
        for (at, pair) in xs.windows(2).enumerate() {
            self.spans[from.1 + at].push((pair[0].min(pair[1]), pair[0].max(pair[1])));
        }
        for (at, x) in xs[1..xs.len() - 1].iter().enumerate() {
            self.passes[from.1 + 1 + at].push(*x);
        }
        xs
    }

    /// The cheapest step from a layer to a place in a row.
    fn step(&self, layer: &[Step], x: f64, row: usize, extra: f64) -> Step {
        let steps = layer.iter().enumerate().map(|(before, one)| {
            let cost = one.cost + extra + aside(one.x, x, &self.spans[row - 1]);
            Step { x, cost, before }
        });
        steps.min_by(|a, b| a.cost.total_cmp(&b.cost)).unwrap_or(Step { x, cost: extra, before: 0 })
    }
}

/// A place on the way, with the cost of the cheapest course to it.
#[derive(Clone, Copy)]
struct Step {
    x: f64,
    cost: f64,
    /// Index of the step before it.
    before: usize,
}

/// Cost of a way along a corridor, of which the trunk has taken some parts.
fn aside(a: f64, b: f64, spans: &[(f64, f64)]) -> f64 {
    let (low, high) = (a.min(b), a.max(b));
    let shared = spans.iter().map(|(left, right)| high.min(*right) - low.max(*left)).fold(0.0, f64::max);
    high - low - (1.0 - SHARED) * shared
}

/// A course that passes rows.
pub(super) struct Passing<'a> {
    /// Number of its trunk.
    pub(super) trunk: usize,
    /// Row of its upper end.
    pub(super) row: usize,
    /// x at the upper end, in each row that is passed, and at the lower end.
    pub(super) xs: &'a mut [f64],
}

/// Moves the passages of different trunks through one gap apart.
pub(super) fn spread(courses: &mut [Passing<'_>], gaps: &[Vec<(f64, f64)>], distance: f64) {
    let mut of_rows: Vec<Vec<usize>> = vec![Vec::new(); gaps.len()];
    for (index, course) in courses.iter().enumerate() {
        (1..course.xs.len() - 1).for_each(|at| of_rows[course.row + at].push(index));
    }
    for (row, gap) in gaps.iter().enumerate().flat_map(|(row, all)| all.iter().map(move |gap| (row, *gap))) {
        let mut passes: Vec<(usize, f64, Vec<usize>)> = Vec::new();
        for &index in &of_rows[row] {
            let course = &courses[index];
            let x = course.xs[row - course.row];
            if !(gap.0..=gap.1).contains(&x) {
                continue;
            }
            match passes.iter_mut().find(|(trunk, known, _)| *trunk == course.trunk && known.total_cmp(&x).is_eq()) {
                Some((.., all)) => all.push(index),
                None => passes.push((course.trunk, x, vec![index])),
            }
        }
        passes.sort_by(|a, b| a.1.total_cmp(&b.1));
        let distance = distance.min((gap.1 - gap.0) / (passes.len().max(2) - 1) as f64);
        let wanted: Vec<f64> = passes.iter().map(|(_, x, _)| *x).collect();
        let places = apart(&wanted, &vec![0.0; wanted.len()], gap, distance);
        for ((.., all), place) in passes.iter().zip(places) {
            for index in all {
                let course = &mut courses[*index];
                course.xs[row - course.row] = place;
            }
        }
    }
}

/// A part of a corridor that a trunk takes, with its lane.
pub(super) struct Span {
    pub(super) corridor: usize,
    pub(super) trunk: usize,
    pub(super) low: f64,
    pub(super) high: f64,
    /// Number of its lane, from above.
    pub(super) lane: usize,
    /// Number of lanes of the corridor.
    pub(super) lanes: usize,
}

impl Span {
    /// Adds a part to the span of a trunk in a corridor.
    pub(super) fn add(spans: &mut Vec<Self>, corridor: usize, trunk: usize, (a, b): (f64, f64)) {
        let (low, high) = (a.min(b), a.max(b));
        match spans.iter_mut().find(|one| (one.corridor, one.trunk) == (corridor, trunk)) {
            Some(one) => (one.low, one.high) = (one.low.min(low), one.high.max(high)),
            None => spans.push(Self { corridor, trunk, low, high, lane: 0, lanes: 0 }),
        }
    }

    /// Gives each span a lane in its corridor, and sorts them for [`find`](Self::find): spans that are less than `distance` apart have
    /// different lanes.
    pub(super) fn assign(spans: &mut [Self], corridors: usize, distance: f64) {
        for corridor in 0..corridors {
            let mut here: Vec<&mut Self> = spans.iter_mut().filter(|one| one.corridor == corridor).collect();
            here.sort_by(|a, b| a.low.total_cmp(&b.low));
            let mut ends: Vec<f64> = Vec::new();
            for span in &mut here {
                span.lane = ends.iter().position(|end| *end < span.low - distance).unwrap_or(ends.len());
                ends.resize(ends.len().max(span.lane + 1), 0.0);
                ends[span.lane] = span.high;
            }
            for span in here {
                span.lanes = ends.len();
            }
        }
        spans.sort_by_key(|span| (span.corridor, span.trunk));
    }

    /// The span of a trunk in a corridor, of spans that have lanes.
    pub(super) fn find(spans: &[Self], corridor: usize, trunk: usize) -> Option<&Self> {
        let found = spans.binary_search_by_key(&(corridor, trunk), |span| (span.corridor, span.trunk));
        found.ok().map(|at| &spans[at])
    }
}

/// The corners of a course, with the height of its lane in each corridor: `corridor` counts from its upper end.
pub(super) fn corners(xs: &[f64], begin: f64, end: f64, lane: impl Fn(usize) -> f64) -> Vec<Point> {
    let (Some(first), Some(last)) = (xs.first(), xs.last()) else { return Vec::new() };
    let aside = xs.windows(2).enumerate().flat_map(|(corridor, pair)| {
        let y = lane(corridor);
        [(pair[0], y), (pair[1], y)]
    });
    [(*first, begin)].into_iter().chain(aside).chain([(*last, end)]).collect()
}

/// The path of an SVG through some points, with round corners.
#[must_use]
pub fn path(points: &[Point]) -> String {
    let mut way = points.to_vec();
    way.dedup_by(|b, a| (a.0 - b.0).hypot(a.1 - b.1) <= 0.01);
    let toward = |from: Point, to: Point| {
        let length = (to.0 - from.0).hypot(to.1 - from.1);
        let part = RADIUS.min(length / 2.0) / length;
        (from.0 + (to.0 - from.0) * part, from.1 + (to.1 - from.1) * part)
    };
    let (Some(first), Some(last)) = (way.first(), way.last()) else { return String::new() };
    let mut path = format!("M{:.1} {:.1}", first.0, first.1);
    for three in way.windows(3) {
        let (before, corner, after) = (toward(three[1], three[0]), three[1], toward(three[1], three[2]));
        // Writing into a string never fails.
        let _ = write!(
            path,
            "L{:.1} {:.1}Q{:.1} {:.1} {:.1} {:.1}",
            before.0, before.1, corner.0, corner.1, after.0, after.1
        );
    }
    path + &format!("L{:.1} {:.1}", last.0, last.1)
}
