//! Lanes of transitions in the corridors between rows of states.

use std::collections::BTreeMap;

use super::Rectangle;
use super::courses::{Passing, Span, Trunk, corners, gaps, spread};
use super::parts::{Arrow, Course, Look, Machine};
use super::rows::Graph;

/// White beside a name, and between two lanes of one height, px.
const BESIDE: f64 = 12.0;
/// Height of a corridor without lanes, px.
const EMPTY: f64 = 34.0;
/// Room at the left for the mark of the initial state, px.
const INITIAL: f64 = 44.0;
/// Room that an arrow head needs, px.
const TIP: f64 = 7.0;
/// Largest distance of two lines between which no name stands, px.
const NEAR: f64 = 40.0;
/// Room outside of all states, for lines, px.
const OUTSIDE: f64 = 90.0;

/// The way of an arrow through the rows.
pub(super) struct Way {
    /// The upper state; `None` for an arrow from all states.
    pub(super) upper: Option<usize>,
    pub(super) lower: usize,
    /// The first corridor through which it goes; corridor n is above row n.
    pub(super) first: usize,
    /// Whether it leads from the upper to the lower state.
    pub(super) is_down: bool,
    /// Whether its upper end is at the upper side of a state, and its lower end at the lower side: within a row.
    pub(super) sides: (bool, bool),
    pub(super) bundle: usize,
    /// x of the upper and of the lower end.
    pub(super) ends: (f64, f64),
    pub(super) xs: Vec<f64>,
}

/// The lane that has the name of a bundle.
struct Named {
    corridor: usize,
    /// Middle of the name.
    x: f64,
    /// Ends of the line to a name that stands beside its lane.
    leader: Option<(f64, f64)>,
}

/// A machine that is being laid out.
pub(super) struct Draft<'a> {
    arrows: &'a [Arrow],
    look: &'a Look,
    pub(super) rows: Vec<Vec<usize>>,
    pub(super) row_of: Vec<usize>,
    pub(super) boxes: Vec<Rectangle>,
    width: f64,
    pub(super) ways: Vec<Way>,
    /// Arrows of each bundle.
    bundles: Vec<Vec<usize>>,
}

impl<'a> Draft<'a> {
    pub(super) fn new(
        sizes: &[(f64, f64)],
        arrows: &'a [Arrow],
        look: &'a Look,
        graph: &Graph,
        mut rows: Vec<Vec<usize>>,
    ) -> Self {
        graph.sort(&mut rows);
        let widths: Vec<f64> = sizes.iter().map(|(width, _)| *width).collect();
        let length = |row: &Vec<usize>| row.iter().map(|state| widths[*state] + look.gap).sum::<f64>();
        let width = rows.iter().map(length).fold(0.0, f64::max);
        let columns = graph.columns(&rows, &widths, width, look.gap);
        let boxes = columns.iter().zip(sizes).map(|(x, (width, height))| Rectangle {
            x: *x,
            y: 0.0,
            width: *width,
            height: *height,
        });
        let mut row_of = vec![0; sizes.len()];
        for (number, row) in rows.iter().enumerate() {
            for state in row {
                row_of[*state] = number;
            }
        }
        let (mut numbers, mut bundles) = (BTreeMap::new(), Vec::new());
        let of_arrow = arrows.iter().enumerate().map(|(index, arrow)| {
            let is_alone = arrow.from.is_none_or(|from| from == arrow.to);
            let key = (&arrow.name, arrow.to, is_alone.then_some(index));
            let number = *numbers.entry(key).or_insert_with(|| {
                bundles.push(Vec::new());
                bundles.len() - 1
            });
            bundles[number].push(index);
            number
        });
        let of_arrow: Vec<usize> = of_arrow.collect();
        let boxes: Vec<Rectangle> = boxes.collect();
        let ways = arrows.iter().zip(of_arrow).map(|(arrow, bundle)| Way::of(arrow, bundle, &row_of, &boxes)).collect();
        Self { arrows, look, rows, row_of, boxes, width, ways, bundles }
    }

    pub(super) fn laid_out(mut self) -> Machine {
        let ports = self.place_ends();
        self.pass_rows();
        self.separate(&ports);
        let (spans, named) = self.lanes();
        let tops = self.heights(&spans);
        let Look { above, lane, .. } = *self.look;
        let y = |corridor: usize, bundle: usize| {
            let span = Span::find(&spans, corridor, bundle);
            tops[corridor] + above + (span.map_or(0.0, |span| span.lane as f64) + 0.5) * lane
        };
        let low = spans.iter().map(|span| span.low).fold(0.0, f64::min) - INITIAL;
        let high = spans.iter().map(|span| span.high).fold(self.width, f64::max) + BESIDE;
        let bottom = tops.last().map_or(0.0, |top| top + self.corridor(&spans, self.rows.len()));
        let (width, height) = (high - low, bottom);
        let area = Rectangle { x: low + width / 2.0, y: height / 2.0, width, height };
        let courses = (0..self.ways.len()).map(|index| self.course(index, &named, &y)).collect();
        Machine { courses, area, boxes: self.boxes }
    }

    /// Finds the ways through the rows.
    fn pass_rows(&mut self) {
        let boxes = &self.boxes;
        let gaps: Vec<_> = self
            .rows
            .iter()
            .map(|row| gaps(row.iter().map(|state| &boxes[*state]), -OUTSIDE, self.width + OUTSIDE - 2.0))
            .collect();
        let mut trunks: Vec<Trunk> = self.bundles.iter().map(|_| Trunk::new(self.rows.len() + 1)).collect();
        for way in &mut self.ways {
            way.xs = match way.upper {
                None => vec![way.ends.1],
                Some(_) if way.sides != (false, false) => vec![way.ends.0, way.ends.1],
                Some(upper) => {
                    let [from, to] = [(way.ends.0, self.row_of[upper]), (way.ends.1, self.row_of[way.lower])];
                    trunks[way.bundle].course(from, to, &gaps)
                }
            };
        }
        let long = self.ways.iter_mut().filter(|way| way.xs.len() > 2);
        let mut passing: Vec<Passing<'_>> =
            long.map(|way| Passing { trunk: way.bundle, row: way.first - 1, xs: &mut way.xs }).collect();
        spread(&mut passing, &gaps, self.look.apart);
    }

    /// A lane in each corridor for each bundle, and where the name of each bundle stands.
    fn lanes(&self) -> (Vec<Span>, Vec<Named>) {
        let uprights = self.uprights();
        let (mut spans, mut named): (Vec<Span>, Vec<Named>) = (Vec::new(), Vec::new());
        for (bundle, all) in self.bundles.iter().enumerate() {
            let mut own = Vec::new();
            for way in all.iter().map(|index| &self.ways[*index]) {
                let parts = way.xs.windows(2).map(|pair| (pair[0], pair[1]));
                let alone = (way.xs.len() == 1).then(|| (way.xs[0], way.xs[0]));
                for (at, part) in parts.chain(alone).enumerate() {
                    Span::add(&mut own, way.first + at, bundle, part);
                }
            }
            let longest =
                own.iter_mut().reduce(|best, one| if one.high - one.low > best.high - best.low { one } else { best });
            let Some(longest) = longest else { continue };
            let mut name =
                Named { corridor: longest.corridor, x: f64::midpoint(longest.low, longest.high), leader: None };
            if let Some(least) = self.look.name {
                let (arrow, way) = (&self.arrows[all[0]], &self.ways[all[0]]);
                let half = (arrow.width / 2.0).max(least / 2.0);
                if way.upper.is_some() {
                    let of = uprights.get(&longest.corridor).map_or(&[][..], Vec::as_slice);
                    name.stand_aside(longest, (half, arrow.width / 2.0), of, way.upper == Some(way.lower));
                }
                (longest.low, longest.high) = (longest.low.min(name.x - half), longest.high.max(name.x + half));
            }
            named.push(name);
            spans.extend(own);
        }
        Span::assign(&mut spans, self.rows.len() + 1, BESIDE);
        (spans, named)
    }

    /// Where lines go up and down in each corridor, from left to right.
    fn uprights(&self) -> BTreeMap<usize, Vec<f64>> {
        let mut found: BTreeMap<usize, Vec<f64>> = BTreeMap::new();
        for way in &self.ways {
            for at in 0..way.xs.len().max(2) - 1 {
                found.entry(way.first + at).or_default().extend(&way.xs[at..way.xs.len().min(at + 2)]);
            }
        }
        for all in found.values_mut() {
            all.sort_by(f64::total_cmp);
        }
        found
    }

    /// Height of a corridor.
    fn corridor(&self, spans: &[Span], corridor: usize) -> f64 {
        let lanes = spans.iter().find(|span| span.corridor == corridor).map_or(0, |span| span.lanes);
        let height = lanes as f64 * self.look.lane + 2.0 * self.look.above;
        if lanes > 0 { height } else { EMPTY }
    }

    /// Puts the rows below each other; the upper edge of each corridor.
    fn heights(&mut self, spans: &[Span]) -> Vec<f64> {
        let mut y = 0.0;
        let mut tops = Vec::new();
        for corridor in 0..=self.rows.len() {
            tops.push(y);
            y += self.corridor(spans, corridor);
            let row = self.rows.get(corridor).map_or(&[][..], Vec::as_slice);
            let tallest = row.iter().map(|state| self.boxes[*state].height).fold(0.0, f64::max);
            for state in row {
                self.boxes[*state].y = y + tallest / 2.0;
            }
            y += tallest;
        }
        tops
    }

    fn course(&self, index: usize, named: &[Named], y: &impl Fn(usize, usize) -> f64) -> Course {
        let way = &self.ways[index];
        let name = &named[way.bundle];
        let (label, owner) = ((name.x, y(name.corridor, way.bundle)), self.bundles[way.bundle][0]);
        let lower = &self.boxes[way.lower];
        let Some(upper) = way.upper.map(|upper| &self.boxes[upper]) else {
            let points = vec![(way.xs[0], label.1 + 8.0), (way.xs[0], lower.y - lower.height / 2.0 - TIP)];
            return Course { points, leader: Vec::new(), label, owner };
        };
        let edge = |of: &Rectangle, is_top: bool, has_tip: bool| {
            let away = of.height / 2.0 + if has_tip { TIP } else { 1.0 };
            of.y + if is_top { -away } else { away }
        };
        let (begin, end) = (edge(upper, way.sides.0, !way.is_down), edge(lower, !way.sides.1, way.is_down));
        let mut points = corners(&way.xs, begin, end, |corridor| y(way.first + corridor, way.bundle));
        if !way.is_down {
            points.reverse();
        }
        let leader = name.leader.filter(|_| index == owner);
        let leader = leader.map_or_else(Vec::new, |(from, to)| vec![(from, label.1), (to, label.1)]);
        Course { points, leader, label, owner }
    }
}

impl Way {
    fn of(arrow: &Arrow, bundle: usize, row_of: &[usize], boxes: &[Rectangle]) -> Self {
        let to = row_of[arrow.to];
        let way = |upper, lower, first| Self {
            upper,
            lower,
            first,
            is_down: true,
            sides: (false, false),
            bundle,
            ends: (0.0, 0.0),
            xs: Vec::new(),
        };
        let Some(from) = arrow.from else { return way(None, arrow.to, to) };
        let row = row_of[from];
        if row == to {
            let is_above = boxes[from].x < boxes[arrow.to].x;
            let sides = (is_above, !is_above);
            return Self { sides, ..way(Some(from), arrow.to, if is_above { to } else { to + 1 }) };
        }
        let is_down = row < to;
        let (upper, lower) = if is_down { (from, arrow.to) } else { (arrow.to, from) };
        Self { is_down, ..way(Some(upper), lower, row_of[upper] + 1) }
    }
}

impl Named {
    /// Moves a name that is wider than its lane, and would cover lines of others or its own loop, beside all of them; `uprights` are in
    /// order.
    fn stand_aside(&mut self, span: &Span, (half, own): (f64, f64), uprights: &[f64], is_loop: bool) {
        let Span { low, high, .. } = *span;
        let from = |end: f64| &uprights[uprights.partition_point(|x| *x < end)..];
        let mut under = from(self.x - half).iter().take_while(|x| **x < self.x + half);
        let is_covered = under.any(|x| (x - self.x).abs() < half && (*x < low || *x > high));
        if high - low >= 2.0 * half || !(is_covered || is_loop) {
            return;
        }
        let beside = |mut end: f64, lines: &mut dyn Iterator<Item = &f64>| {
            lines.take_while(|x| (*x - std::mem::replace(&mut end, **x)).abs() < NEAR).last().copied()
        };
        let before = &uprights[..uprights.len() - from(low).len()];
        let left = beside(low, &mut before.iter().rev()).unwrap_or(low);
        let right = beside(high, &mut from(high).iter()).unwrap_or(high);
        if right - high <= low - left {
            self.x = right + BESIDE + half;
            self.leader = Some((high, self.x - own));
        } else {
            self.x = left - BESIDE - half;
            self.leader = Some((low, self.x + own));
        }
    }
}
