//! Coordinates of the items, px.

use super::layers::{Item, Layers, Segment};

/// Width of a component, px.
pub const BOX_WIDTH: f64 = 104.0;
/// Height of a component, px.
pub const BOX_HEIGHT: f64 = 38.0;
/// Width of a dummy node, px.
const DUMMY_WIDTH: f64 = 2.0;
/// Least distance between two items of a layer, px.
const GAP: f64 = 11.0;
/// Distance from layer to layer, px.
const LAYER_DISTANCE: f64 = 96.0;
/// Margin around the drawing, px.
const MARGIN: f64 = 14.0;
/// Number of passes that move the items towards their neighbours.
const SWEEPS: usize = 60;

/// Coordinates of all items.
#[derive(Debug)]
pub struct Placement {
    /// Width of the drawing, px.
    pub width: f64,
    /// Height of the drawing, px.
    pub height: f64,
    /// Centre of each item.
    x: Vec<f64>,
    /// Upper edge of each item.
    y: Vec<f64>,
    /// x of each segment at its upper and at its lower item.
    ports: Vec<(f64, f64)>,
    segments: Vec<Segment>,
}

impl Placement {
    /// Coordinates for these layers.
    #[must_use]
    pub fn new(layers: &Layers) -> Self {
        let x = columns(layers);
        let left = bounds(layers, &x).0;
        let x: Vec<f64> = x.into_iter().map(|x| x - left + MARGIN).collect();
        let mut y = vec![0.0; x.len()];
        for (row, items) in layers.rows.iter().enumerate() {
            for &item in items {
                y[item] = MARGIN + row as f64 * LAYER_DISTANCE;
            }
        }
        Self {
            width: bounds(layers, &x).1 + MARGIN,
            height: MARGIN * 2.0 + BOX_HEIGHT + LAYER_DISTANCE * layers.rows.len().saturating_sub(1) as f64,
            ports: ports(layers, &x),
            segments: layers.segments.clone(),
            x,
            y,
        }
    }

    /// Returns the middle of the upper edge of an item.
    #[must_use]
    pub fn of(&self, item: usize) -> (f64, f64) {
        (self.x[item], self.y[item])
    }

    /// Returns the start and the end of a segment.
    #[must_use]
    pub fn ends(&self, segment: &Segment) -> ((f64, f64), (f64, f64)) {
        let ports = self.segments.iter().zip(&self.ports).find(|(other, _)| *other == segment);
        let (from, to) = ports.map_or((self.x[segment.upper], self.x[segment.lower]), |(_, ports)| *ports);
        ((from, self.y[segment.upper] + BOX_HEIGHT), (to, self.y[segment.lower]))
    }
}

fn width(item: Item) -> f64 {
    match item {
        Item::Component(_) => BOX_WIDTH,
        Item::Dummy => DUMMY_WIDTH,
    }
}

fn bounds(layers: &Layers, x: &[f64]) -> (f64, f64) {
    let half = |item: usize| width(layers.items[item]) / 2.0;
    let left = (0..x.len()).map(|item| x[item] - half(item)).fold(f64::INFINITY, f64::min);
    let right = (0..x.len()).map(|item| x[item] + half(item)).fold(0.0, f64::max);
    (if left.is_finite() { left } else { 0.0 }, right)
}

/// Returns the x of each item. Each layer in turn is moved towards its neighbours, as far as its order and the gaps allow.
fn columns(layers: &Layers) -> Vec<f64> {
    let mut x = vec![0.0; layers.items.len()];
    for row in &layers.rows {
        spread(layers, row, &mut x);
    }
    for sweep in 0..SWEEPS {
        for step in 0..layers.rows.len() {
            let row = if sweep % 2 == 0 { step } else { layers.rows.len() - 1 - step };
            spread(layers, &layers.rows[row], &mut x);
        }
    }
    x
}

/// Sets the items of a layer to the positions with the least sum of squared distances from the means of their neighbours.
/// Without the gaps this is isotonic regression, solved by pooling adjacent violators.
fn spread(layers: &Layers, row: &[usize], x: &mut [f64]) {
    let mut offset = 0.0;
    let mut offsets = Vec::new();
    let mut pools: Vec<(f64, f64, usize)> = Vec::new();
    for (place, &item) in row.iter().enumerate() {
        if place > 0 {
            offset += f64::midpoint(width(layers.items[row[place - 1]]), width(layers.items[item])) + GAP;
        }
        offsets.push(offset);
        let weight = if layers.items[item] == Item::Dummy { 2.0 } else { 1.0 };
        pools.push((barycentre(layers, item, x) - offset, weight, 1));
        while let [.., before, last] = pools[..]
            && before.0 >= last.0
        {
            let weight = before.1 + last.1;
            pools.truncate(pools.len() - 2);
            pools.push(((before.0 * before.1 + last.0 * last.1) / weight, weight, before.2 + last.2));
        }
    }
    let bases = pools.into_iter().flat_map(|(base, _, count)| std::iter::repeat_n(base, count));
    for ((base, offset), &item) in bases.zip(offsets).zip(row) {
        x[item] = base + offset;
    }
}

/// Returns the mean x of an item's neighbours; its own x without neighbours.
fn barycentre(layers: &Layers, item: usize, x: &[f64]) -> f64 {
    let neighbours = layers.neighbours(item, true).chain(layers.neighbours(item, false)).map(|other| x[other]);
    let (sum, count) = neighbours.fold((0.0, 0.0), |(sum, count), x| (sum + x, count + 1.0));
    if count > 0.0 { sum / count } else { x[item] }
}

/// Spreads the ends of the segments over the edges of the boxes, in the order of their other ends.
fn ports(layers: &Layers, x: &[f64]) -> Vec<(f64, f64)> {
    let mut ports: Vec<_> = layers.segments.iter().map(|segment| (x[segment.upper], x[segment.lower])).collect();
    for item in (0..layers.items.len()).filter(|&item| layers.items[item] != Item::Dummy) {
        for (index, x) in along_edge(layers, x, item, |segment| (segment.upper, segment.lower)) {
            ports[index].0 = x;
        }
        for (index, x) in along_edge(layers, x, item, |segment| (segment.lower, segment.upper)) {
            ports[index].1 = x;
        }
    }
    ports
}

/// Returns the indices of the segments at one edge of a box, each with the x of its port.
fn along_edge(
    layers: &Layers,
    x: &[f64],
    item: usize,
    ends: impl Fn(&Segment) -> (usize, usize),
) -> impl Iterator<Item = (usize, f64)> {
    let here = layers.segments.iter().map(&ends).enumerate().filter(|&(_, (this, _))| this == item);
    let mut here: Vec<(f64, usize)> = here.map(|(index, (_, other))| (x[other], index)).collect();
    here.sort_by(|a, b| a.0.total_cmp(&b.0));
    let step = (BOX_WIDTH - 16.0) / (here.len() as f64);
    let step = step.min(16.0);
    let first = x[item] - step * (here.len() as f64 - 1.0) / 2.0;
    here.into_iter().enumerate().map(move |(place, (_, index))| (index, first + step * place as f64))
}
