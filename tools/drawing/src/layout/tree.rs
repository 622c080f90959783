//! Layout of an activation tree: rows by the longest path from the root, with the courses of its links between them.

use std::collections::BTreeMap;

use super::courses::{Passing, Span, Trunk, corners, gaps, spread};
use super::rows::{Graph, MARGIN};
use super::{Point, Rectangle};

/// Usual and least distance of two boxes of a row, and of two rows, px.
const GAP: f64 = 14.0;
const LEAST: f64 = 5.0;
const CORRIDOR: f64 = 9.0;
/// Largest distance of two boxes of the longest row, and of two rows, px: the boxes of a small tree stay together.
const FAR: f64 = 110.0;
const DISTANT: f64 = 64.0;
/// Least scale at which the names of a tree can be read.
const READABLE: f64 = 0.96;
/// Distance of the lines of two trunks, px.
const LANE: f64 = 4.0;

/// A link of a tree.
#[derive(Clone, Copy, Debug)]
pub struct Link {
    /// Index of the upper box.
    pub from: usize,
    /// Index of the lower box.
    pub to: usize,
    /// Number of its trunk: links of one trunk share their lines.
    pub trunk: usize,
    /// Distance of its ends from the middles of the boxes, px.
    pub side: f64,
}

/// Adds the lines of queries, `(from, of)`. They are no links: one that leads to a component above keeps that above.
pub fn add_queries(links: &mut Vec<Link>, queries: impl IntoIterator<Item = (usize, usize)>) {
    let first = links.iter().map(|link| link.trunk + 1).max().unwrap_or(0);
    for (from, of) in queries {
        let (upper, lower) = if is_above(links, of, from) { (of, from) } else { (from, of) };
        links.push(Link { from: upper, to: lower, trunk: first + from, side: 0.0 });
    }
}

/// Returns whether links lead from a box down to another one.
fn is_above(links: &[Link], upper: usize, lower: usize) -> bool {
    let mut reached = vec![upper];
    let mut next = 0;
    while let Some(&from) = reached.get(next) {
        for link in links.iter().filter(|link| link.from == from) {
            if !reached.contains(&link.to) {
                reached.push(link.to);
            }
        }
        next += 1;
    }
    reached.contains(&lower)
}

/// A laid-out tree.
#[derive(Clone, Debug, Default)]
pub struct Tree {
    /// The boxes.
    pub boxes: Vec<Rectangle>,
    /// Corners of the line of each link, from its upper to its lower box; none of a link within a row.
    pub lines: Vec<Vec<Point>>,
    /// Width, px.
    pub width: f64,
    /// Height, px.
    pub height: f64,
}

impl Tree {
    /// Lays boxes of given widths out in a panel of this width and height, px; the drawing is larger if its boxes need more. The
    /// height of a box lies within `heights`.
    #[must_use]
    pub fn new(links: &[Link], widths: &[f64], panel: (f64, f64), heights: (f64, f64)) -> Self {
        if widths.is_empty() {
            return Self { width: panel.0, height: panel.1, ..Self::default() };
        }
        let graph = downward(widths.len(), links);
        let mut rows = graph.depth_rows(widths);
        graph.sort(&mut rows);
        // Names can be read: a row that is wider than the panel becomes several. What is higher than the panel is moved.
        if rows.iter().any(|row| (length(row, widths, LEAST) + 2.0 * MARGIN) * READABLE > panel.0) {
            rows = rows.iter().flat_map(|row| broken(row, widths, panel.0 - 2.0 * MARGIN)).collect();
        }
        let longest = |gap| rows.iter().map(|row| length(row, widths, gap)).fold(0.0, f64::max) + 2.0 * MARGIN;
        let (width, used) = (panel.0.max(longest(LEAST)), panel.0.max(longest(LEAST)).min(longest(FAR)));
        let count = rows.len() as f64;
        let height = panel.1.max(count * (heights.0 + CORRIDOR) - CORRIDOR + 2.0 * MARGIN);
        let tall = ((height - 2.0 * MARGIN) / count - 3.0 * CORRIDOR).min(heights.1).max(heights.0);
        let step = ((height - 2.0 * MARGIN - tall) / (count - 1.0).max(1.0)).min(tall + DISTANT);
        let (left, top) = ((width - used) / 2.0, (height - (count - 1.0) * step) / 2.0);
        let columns = graph.columns(&rows, widths, used, GAP);
        let mut boxes: Vec<Rectangle> = columns
            .iter()
            .zip(widths)
            .map(|(x, width)| Rectangle { x: left + x, y: 0.0, width: *width, height: tall })
            .collect();
        let mut row_of = vec![0; boxes.len()];
        for (number, index) in
            rows.iter().enumerate().flat_map(|(number, row)| row.iter().map(move |one| (number, *one)))
        {
            boxes[index].y = top + number as f64 * step;
            row_of[index] = number;
        }
        let lines = lines(links, &boxes, &row_of, &rows, width);
        Self { boxes, lines, width, height }
    }

    /// Moves all to the upper left, so that only a margin of this width, px, is around the tree.
    #[must_use]
    pub fn cropped(mut self, margin: f64) -> Self {
        let corners = self.boxes.iter().flat_map(|one| {
            [(one.x - one.width / 2.0, one.y - one.height / 2.0), (one.x + one.width / 2.0, one.y + one.height / 2.0)]
        });
        let points: Vec<Point> = corners.chain(self.lines.iter().flatten().copied()).collect();
        let bound =
            |of: fn(&Point) -> f64, pick: fn(f64, f64) -> f64| points.iter().map(of).reduce(pick).unwrap_or_default();
        let (left, top) = (bound(|one| one.0, f64::min) - margin, bound(|one| one.1, f64::min) - margin);
        self.width = bound(|one| one.0, f64::max) + margin - left;
        self.height = bound(|one| one.1, f64::max) + margin - top;
        self.boxes.iter_mut().for_each(|one| (one.x, one.y) = (one.x - left, one.y - top));
        self.lines.iter_mut().flatten().for_each(|one| *one = (one.0 - left, one.1 - top));
        self
    }
}

/// Length of a row with a distance of its boxes.
fn length(row: &[usize], widths: &[f64], gap: f64) -> f64 {
    row.iter().map(|index| widths[*index] + gap).sum::<f64>() - gap
}

/// The parts of a row that are not longer than the room.
fn broken(row: &[usize], widths: &[f64], room: f64) -> Vec<Vec<usize>> {
    let mut parts: Vec<Vec<usize>> = Vec::new();
    for &index in row {
        match parts.last_mut() {
            Some(part) if length(part, widths, LEAST) + LEAST + widths[index] <= room => part.push(index),
            _ => parts.push(vec![index]),
        }
    }
    parts
}

/// The links of a tree, each downward in an order in which sources come first; with a circle, what is on it and after it comes last.
fn downward(count: usize, links: &[Link]) -> Graph {
    let written = Graph::new(count, links.iter().map(|link| (link.from, link.to)));
    let (mut ranks, mut open) = (vec![count; count], written.sources.iter().map(Vec::len).collect::<Vec<_>>());
    for rank in 0..count {
        let waiting = |node: &usize| ranks[*node] == count;
        let free = (0..count).filter(waiting).find(|node| open[*node] == 0);
        let Some(next) = free.or_else(|| (0..count).find(waiting)) else { break };
        ranks[next] = rank;
        written.targets[next].iter().for_each(|to| open[*to] -= 1);
    }
    let ends =
        |link: &Link| if ranks[link.from] < ranks[link.to] { (link.from, link.to) } else { (link.to, link.from) };
    Graph::new(count, links.iter().map(ends))
}

/// The length of the longest path to each box, from one that nothing leads to.
fn depths(next: &[Vec<usize>]) -> Vec<usize> {
    let mut depths = vec![0; next.len()];
    // No path has more parts than there are boxes.
    for (from, all) in next.iter().enumerate().cycle().take(next.len() * next.len()) {
        for to in all {
            depths[*to] = depths[*to].max(depths[from] + 1);
        }
    }
    depths
}

impl Graph {
    /// Rows by depth. A box that may stand in several rows goes to the one with most room.
    fn depth_rows(&self, widths: &[f64]) -> Vec<Vec<usize>> {
        let (first, below) = (depths(&self.targets), depths(&self.sources));
        let deepest = first.iter().max().copied().unwrap_or(0);
        let (mut rows, mut used) = (vec![Vec::new(); deepest + 1], vec![0.0; deepest + 1]);
        let mut row_of: Vec<Option<usize>> = vec![None; widths.len()];
        let last = |index: usize| deepest.saturating_sub(below[index]);
        let mut order: Vec<usize> = (0..widths.len()).collect();
        order.sort_by_key(|index| first[*index]);
        let (fixed, movable): (Vec<usize>, Vec<usize>) =
            order.into_iter().partition(|index| first[*index] >= last(*index));
        for (index, is_movable) in
            fixed.into_iter().map(|one| (one, false)).chain(movable.into_iter().map(|one| (one, true)))
        {
            let mut row = first[index];
            if is_movable {
                let above = self.sources[index].iter().filter_map(|one| row_of[*one]).map(|row| row + 1);
                let from = above.fold(row, usize::max);
                row = (from..=last(index)).fold(from, |best, at| if used[at] < used[best] { at } else { best });
            }
            row_of[index] = Some(row);
            rows[row].push(index);
            used[row] += widths[index] + GAP;
        }
        rows
    }
}

/// The corners of the line of each link.
fn lines(links: &[Link], boxes: &[Rectangle], row_of: &[usize], rows: &[Vec<usize>], width: f64) -> Vec<Vec<Point>> {
    let gaps: Vec<_> = rows.iter().map(|row| gaps(row.iter().map(|index| &boxes[*index]), 2.0, width - 2.0)).collect();
    let mut trunks: BTreeMap<usize, Trunk> = BTreeMap::new();
    // Short links first: long ones follow what is there. A link upward, which only a circle has, is drawn from its lower end.
    let ends =
        |link: &Link| if row_of[link.from] <= row_of[link.to] { (link.from, link.to) } else { (link.to, link.from) };
    let rise = |link: &Link| row_of[ends(link).1] - row_of[ends(link).0];
    let mut order: Vec<usize> = (0..links.len()).filter(|index| rise(&links[*index]) > 0).collect();
    order.sort_by_key(|index| rise(&links[*index]));
    let mut courses: Vec<(usize, Vec<f64>)> = Vec::new();
    for index in order {
        let (link, (upper, lower)) = (&links[index], ends(&links[index]));
        let end = |of: usize| (boxes[of].x + link.side, row_of[of]);
        let trunk = trunks.entry(link.trunk).or_insert_with(|| Trunk::new(rows.len()));
        courses.push((index, trunk.course(end(upper), end(lower), &gaps)));
    }
    let first = |index: usize| row_of[ends(&links[index]).0];
    let mut passing: Vec<Passing<'_>> =
        courses.iter_mut().map(|(index, xs)| Passing { trunk: links[*index].trunk, row: first(*index), xs }).collect();
    spread(&mut passing, &gaps, LANE);
    let mut of_trunks: BTreeMap<usize, Vec<Span>> = BTreeMap::new();
    for (index, xs) in &courses {
        let (trunk, own) = (links[*index].trunk, of_trunks.entry(links[*index].trunk).or_default());
        for (at, pair) in xs.windows(2).enumerate() {
            Span::add(own, first(*index) + at, trunk, (pair[0], pair[1]));
        }
    }
    let mut spans: Vec<Span> = of_trunks.into_values().flatten().collect();
    Span::assign(&mut spans, rows.len(), LANE);
    let half = boxes[0].height / 2.0;
    let mut lines = vec![Vec::new(); links.len()];
    for (index, xs) in &courses {
        let (link, (upper, lower)) = (&links[*index], ends(&links[*index]));
        let lane = |corridor: usize| {
            let corridor = first(*index) + corridor;
            let (top, bottom) = (boxes[rows[corridor][0]].y + half, boxes[rows[corridor + 1][0]].y - half);
            let part = Span::find(&spans, corridor, link.trunk)
                .map_or(0.5, |span| (span.lane as f64 + 1.0) / (span.lanes as f64 + 1.0));
            top + part * (bottom - top)
        };
        lines[*index] = corners(xs, boxes[upper].y + half, boxes[lower].y - half, lane);
    }
    lines
}
