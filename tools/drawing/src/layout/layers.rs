//! Layers of a drawing: the layer of a component by its longest path from the root, the order in a layer by the
//! barycentre heuristic.

use std::collections::BTreeMap;

use bica_wire::model::{Description, LinkKind};

/// Number of sorting passes over the layers.
const SWEEPS: usize = 24;

/// Node of the layered graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Item {
    /// The component with this index.
    Component(usize),
    /// A dummy node: a link passes through this layer to a lower one.
    Dummy,
}

/// Part of one or more links between neighbouring layers, from item to item.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Segment {
    /// Index of the item in the upper layer.
    pub upper: usize,
    /// Index of the item in the lower layer.
    pub lower: usize,
    /// Whether the link leads to the upper item, which only happens in a cycle.
    pub upward: bool,
    /// Kind of the links.
    pub kind: LinkKind,
}

/// Layers of a drawing.
#[derive(Debug)]
pub struct Layers {
    /// The components in the order of the tree, then the dummy nodes.
    pub items: Vec<Item>,
    /// All segments, sorted, without duplicates.
    pub segments: Vec<Segment>,
    /// The items of each layer, from left to right.
    pub rows: Vec<Vec<usize>>,
}

impl Layers {
    /// Layers of a tree.
    #[must_use]
    pub fn new(tree: &Description) -> Self {
        let depths = depths(tree);
        let count = depths.iter().max().map_or(0, |depth| depth + 1);
        let mut layers = Self {
            items: (0..tree.components.len()).map(Item::Component).collect(),
            segments: Vec::new(),
            rows: vec![Vec::new(); count],
        };
        depths.iter().enumerate().for_each(|(node, &depth)| layers.rows[depth].push(node));
        layers.connect(tree, &depths);
        layers.sort();
        layers
    }

    /// Splits all links into segments. Links of one kind to one component share their dummy nodes.
    fn connect(&mut self, tree: &Description, depths: &[usize]) {
        let mut dummies = BTreeMap::new();
        for (from, node) in tree.components.iter().enumerate() {
            for link in node.links.iter().filter(|link| link.to != from) {
                let upward = depths[link.to] < depths[from];
                let (top, bottom) = if upward { (link.to, from) } else { (from, link.to) };
                let mut upper = top;
                for row in depths[top] + 1..depths[bottom] {
                    let key = (bottom, row, link.kind == LinkKind::Modulation, upward.then_some(top));
                    let lower = *dummies.entry(key).or_insert_with(|| {
                        self.items.push(Item::Dummy);
                        self.rows[row].push(self.items.len() - 1);
                        self.items.len() - 1
                    });
                    self.segments.push(Segment { upper, lower, upward, kind: link.kind });
                    upper = lower;
                }
                self.segments.push(Segment { upper, lower: bottom, upward, kind: link.kind });
            }
        }
        self.segments.sort_by_key(|s| (s.upper, s.lower, s.upward, s.kind == LinkKind::Modulation));
        self.segments.dedup();
    }

    /// Sorts the layers by the mean position of their neighbours above and below, in turn, and keeps the order with the
    /// fewest crossings.
    fn sort(&mut self) {
        let mut best = (self.crossings(), self.rows.clone());
        for sweep in 0..SWEEPS {
            let downward = sweep % 2 == 0;
            for step in 1..self.rows.len() {
                let row = if downward { step } else { self.rows.len() - 1 - step };
                self.sort_row(row, downward);
            }
            let crossings = self.crossings();
            if crossings < best.0 {
                best = (crossings, self.rows.clone());
            }
        }
        self.rows = best.1;
    }

    fn sort_row(&mut self, row: usize, by_upper: bool) {
        let places = self.places();
        let mean = |item: usize| {
            let neighbours = self.neighbours(item, by_upper).map(|other| places[other]);
            let (sum, count) = neighbours.fold((0.0, 0.0), |(sum, count), place| (sum + place, count + 1.0));
            if count > 0.0 { sum / count } else { places[item] }
        };
        let mut sorted: Vec<(f64, usize)> = self.rows[row].iter().map(|&item| (mean(item), item)).collect();
        sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
        self.rows[row] = sorted.into_iter().map(|(_, item)| item).collect();
    }

    /// Returns the items above (`upper`) or below that a segment connects to this one.
    pub fn neighbours(&self, item: usize, upper: bool) -> impl Iterator<Item = usize> {
        let ends = self.segments.iter().map(move |s| if upper { (s.lower, s.upper) } else { (s.upper, s.lower) });
        ends.filter(move |&(this, _)| this == item).map(|(_, other)| other)
    }

    /// Position of each item in its layer, 0 to 1.
    fn places(&self) -> Vec<f64> {
        let mut places = vec![0.0; self.items.len()];
        for row in &self.rows {
            for (place, &item) in row.iter().enumerate() {
                places[item] = (place as f64 + 0.5) / row.len() as f64;
            }
        }
        places
    }

    /// Number of pairs of segments that cross.
    fn crossings(&self) -> usize {
        let places = self.places();
        let mut row_of = vec![0; self.items.len()];
        self.rows.iter().enumerate().for_each(|(index, row)| row.iter().for_each(|&item| row_of[item] = index));
        let cross = |a: &Segment, b: &Segment| {
            row_of[a.upper] == row_of[b.upper]
                && (places[a.upper] - places[b.upper]) * (places[a.lower] - places[b.lower]) < 0.0
        };
        let pairs = self.segments.iter().enumerate();
        pairs.map(|(index, a)| self.segments[index + 1..].iter().filter(|b| cross(a, b)).count()).sum()
    }
}

/// Returns the layer of each component: below all its activators; the lowest layer if it has no links. Links that close a cycle lead up.
fn depths(tree: &Description) -> Vec<usize> {
    let (ranks, nodes) = (ranks(tree), &tree.components);
    let links = nodes.iter().enumerate().flat_map(|(from, node)| node.links.iter().map(move |link| (from, link.to)));
    let downward = links.map(|(from, to)| if ranks[from] < ranks[to] { (from, to) } else { (to, from) });
    let mut downward: Vec<_> = downward.filter(|(upper, lower)| upper != lower).collect();
    downward.sort_by_key(|&(upper, _)| ranks[upper]);
    let mut depths = vec![0; nodes.len()];
    for (upper, lower) in downward {
        depths[lower] = depths[lower].max(depths[upper] + 1);
    }
    let is_leaf = |node: usize| nodes[node].links.is_empty();
    let bottom = (0..depths.len()).filter(|&node| !is_leaf(node)).map(|node| depths[node] + 1).max().unwrap_or(0);
    (0..depths.len()).map(|node| if is_leaf(node) { bottom } else { depths[node] }).collect()
}

/// Returns the rank of each component in an order with activators first. Components on a cycle and below it come last.
fn ranks(tree: &Description) -> Vec<usize> {
    let count = tree.components.len();
    let (mut ranks, mut activators) = (vec![count; count], vec![0_usize; count]);
    tree.components.iter().flat_map(|node| &node.links).for_each(|link| activators[link.to] += 1);
    for rank in 0..count {
        let waiting = |node: &usize| ranks[*node] == count;
        let free = (0..count).filter(waiting).find(|&node| activators[node] == 0);
        let Some(next) = free.or_else(|| (0..count).find(waiting)) else { break };
        ranks[next] = rank;
        tree.components[next].links.iter().for_each(|link| activators[link.to] -= 1);
    }
    ranks
}
