//! Curves between placed states, and positions of their labels: apart from each other and from states, as far as possible.

use super::parts::{Edge, Node};

type Point = (f32, f32);

/// Number of parts of a curve.
const PARTS: u8 = 64;
/// Minimum distance of a curve from states that it does not connect, points.
const APART: f32 = 6.0;
/// Candidates for the additional bend of a curve, points; negative values bend it to the other side.
const TRIES: [f32; 11] = [0.0, 40.0, 80.0, -44.0, 130.0, -90.0, 190.0, -140.0, 250.0, -200.0, 320.0];
/// Candidates for the position of a label along its curve, 0 to 1, the preferred one first.
const ALONG: [f32; 9] = [0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74, 0.18, 0.82];
/// Width of a letter and height of a line of a label, points.
pub(super) const LETTER: (f32, f32) = (6.0, 13.0);

/// Returns the curve from one state to another. It bends to the right of the straight line, so that the curves of both directions are
/// apart. It bends more, or to the left, if it would cross other states.
pub(super) fn course(from: &Node, to: &Node, all: &[Node]) -> Vec<Point> {
    let (dx, dy) = (to.centre.0 - from.centre.0, to.centre.1 - from.centre.1);
    let length = dx.hypot(dy).max(1.0);
    let usual = 0.16 * length + 14.0;
    let others: Vec<&Node> = all.iter().filter(|node| !std::ptr::eq(*node, from) && !std::ptr::eq(*node, to)).collect();
    let mut best = (usize::MAX, Vec::new());
    for more in TRIES {
        let bend = if more < 0.0 { more - usual } else { usual + more };
        let middle = (from.centre.0 + dx / 2.0 - dy / length * bend, from.centre.1 + dy / 2.0 + dx / length * bend);
        let points: Vec<Point> = (0..=PARTS)
            .map(|part| curve(from.centre, middle, to.centre, f32::from(part) / f32::from(PARTS)))
            .filter(|point| !from.contains(*point, 0.0) && !to.contains(*point, 0.0))
            .collect();
        let crossed = points.iter().filter(|point| others.iter().any(|node| node.contains(**point, APART))).count();
        if crossed < best.0 {
            best = (crossed, points);
        }
        if crossed == 0 {
            break;
        }
    }
    if best.1.len() < 2 { vec![from.centre, to.centre] } else { best.1 }
}

fn curve(from: Point, middle: Point, to: Point, t: f32) -> Point {
    let (a, b, c) = ((1.0 - t) * (1.0 - t), 2.0 * t * (1.0 - t), t * t);
    let mix = |from: f32, middle: f32, to: f32| a * from + b * middle + c * to;
    (mix(from.0, middle.0, to.0), mix(from.1, middle.1, to.1))
}

/// A rectangle: left, top, right, bottom.
type Area = [f32; 4];

/// Moves the labels of transitions along their curves to where they least overlap states and other labels.
pub(super) fn place_names(edges: &mut [Edge], nodes: &[Node]) {
    let mut taken: Vec<Area> = nodes.iter().map(|node| around(node.centre, node.size)).collect();
    for edge in edges {
        let longest = edge.labels.iter().map(|label| label.text.chars().count()).max().unwrap_or(0);
        let size = (LETTER.0 * longest as f32, LETTER.1 * edge.labels.len() as f32);
        if edge.points.len() > ALONG.len() {
            let last = (edge.points.len() - 1) as f32;
            let places = ALONG.iter().map(|part| edge.points[(part * last) as usize]);
            let cost = |at: &Point| taken.iter().map(|area| overlap(*area, around(*at, size))).sum::<f32>();
            // Of equal costs the first is taken.
            let best =
                places.map(|at| (cost(&at), at)).reduce(|best, other| if other.0 < best.0 { other } else { best });
            edge.label_at = best.map_or(edge.label_at, |(_, at)| at);
        }
        taken.push(around(edge.label_at, size));
    }
}

fn around((x, y): Point, (width, height): Point) -> Area {
    [x - width / 2.0, y - height / 2.0, x + width / 2.0, y + height / 2.0]
}

fn overlap(a: Area, b: Area) -> f32 {
    (a[2].min(b[2]) - a[0].max(b[0])).max(0.0) * (a[3].min(b[3]) - a[1].max(b[1])).max(0.0)
}

impl Node {
    /// Returns whether a point lies within a distance of the state.
    fn contains(&self, (x, y): Point, distance: f32) -> bool {
        (x - self.centre.0).abs() <= self.size.0 / 2.0 + distance
            && (y - self.centre.1).abs() <= self.size.1 / 2.0 + distance
    }
}
