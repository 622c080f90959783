//! Places at the sides of states where transitions begin and end.

use std::collections::BTreeMap;

use super::lanes::{Draft, Way};

/// Largest distance of two ends at a side of a state, px.
const PORT: f64 = 18.0;
/// Least distance of upright lines of different bundles in a corridor, px.
const CLEAR: f64 = 4.0;
/// Distances by which an end is moved from another bundle's line, px.
const MOVES: [f64; 8] = [5.0, -5.0, 9.0, -9.0, 13.0, -13.0, 18.0, -18.0];

/// The largest of them.
const FARTHEST: f64 = 18.0;

/// A place at a side of a state.
pub(super) struct Port {
    state: usize,
    corridor: usize,
    /// Ways that end here, each with whether it is its lower end.
    ends: Vec<(usize, bool)>,
}

/// A place at a side of a state, where ends of ways meet.
struct End {
    /// Bundle, and the arrow if it begins here.
    key: (usize, Option<usize>),
    /// x of the other end.
    other: f64,
    /// Ways that end here, each with whether it is its lower end.
    all: Vec<(usize, bool)>,
}

impl Draft<'_> {
    /// Gives each end a place at its side of the state, in the order of the other ends. Ends of a bundle at one state are one.
    pub(super) fn place_ends(&mut self) -> Vec<Port> {
        // By state and whether it is the upper side: trunk, own arrow, x of the other end, and the ends of ways.
        let mut sides: BTreeMap<(usize, bool), Vec<End>> = BTreeMap::new();
        for (index, way) in self.ways.iter().enumerate() {
            let at = |state: usize| self.boxes[state].x;
            let beside = |state: usize| at(state) + self.boxes[state].width;
            let mut add = |state, is_top, other, is_lower: bool| {
                let ends = sides.entry((state, is_top)).or_default();
                let key = (way.bundle, (is_lower != way.is_down).then_some(index));
                match ends.iter_mut().find(|end| end.key == key) {
                    Some(end) => end.all.push((index, is_lower)),
                    None => ends.push(End { key, other, all: vec![(index, is_lower)] }),
                }
            };
            match way.upper {
                None => add(way.lower, true, beside(way.lower), true),
                Some(upper) => {
                    let other = if upper == way.lower { beside(upper) } else { at(way.lower) };
                    add(upper, way.sides.0, other, false);
                    add(way.lower, !way.sides.1, at(upper), true);
                }
            }
        }
        let mut ports = Vec::new();
        for ((state, is_top), mut ends) in sides {
            ends.sort_by(|a, b| a.other.total_cmp(&b.other));
            let distance = PORT.min((self.boxes[state].width - 16.0) / (ends.len().max(2) - 1) as f64);
            for (at, end) in ends.iter().enumerate() {
                let x = self.boxes[state].x + (at as f64 - (ends.len() - 1) as f64 / 2.0) * distance;
                for (way, is_lower) in &end.all {
                    let ends = &mut self.ways[*way].ends;
                    *if *is_lower { &mut ends.1 } else { &mut ends.0 } = x;
                }
            }
            let corridor = self.row_of[state] + usize::from(!is_top);
            ports.extend(ends.into_iter().map(|end| Port { state, corridor, ends: end.all }));
        }
        ports
    }

    /// Moves ends away from upright lines of other bundles in their corridor: two lines at one x look like one.
    pub(super) fn separate(&mut self, ports: &[Port]) {
        // x and bundle of all upright lines of each corridor, from left to right.
        let mut lines: Vec<Vec<(f64, usize)>> = vec![Vec::new(); self.rows.len() + 1];
        for way in &self.ways {
            for (at, all) in lines[way.first..].iter_mut().enumerate().take(way.xs.len().max(2) - 1) {
                all.extend(way.uprights(way.first + at).iter().map(|x| (*x, way.bundle)));
            }
        }
        for all in &mut lines {
            all.sort_by(|a, b| a.0.total_cmp(&b.0));
        }
        for port in ports {
            let (bundle, all) = (self.ways[port.ends[0].0].bundle, &mut lines[port.corridor]);
            let (x, within) = (self.end(port.ends[0]), &self.boxes[port.state]);
            let first = |all: &[(f64, usize)], x: f64| all.partition_point(|line| line.0 < x);
            let near = &all[first(all, x - FARTHEST - CLEAR)..first(all, x + FARTHEST + CLEAR)];
            let is_free = |x: f64| near.iter().all(|(other, of)| *of == bundle || (other - x).abs() >= CLEAR);
            let is_inside = |x: &f64| (x - within.x).abs() < within.width / 2.0 - CLEAR;
            let mut moved = MOVES.iter().map(|step| x + step).filter(is_inside);
            let Some(free) = (!is_free(x)).then(|| moved.find(|x| is_free(*x))).flatten() else { continue };
            for (way, is_lower) in &port.ends {
                let xs = &mut self.ways[*way].xs;
                let at = if *is_lower { xs.len() - 1 } else { 0 };
                xs[at] = free;
                let old = first(all, x);
                if let Some(line) = all[old..].iter().position(|line| line.1 == bundle) {
                    all.remove(old + line);
                }
                all.insert(first(all, free), (free, bundle));
            }
        }
    }

    fn end(&self, (way, is_lower): (usize, bool)) -> f64 {
        let xs = &self.ways[way].xs;
        xs[if is_lower { xs.len() - 1 } else { 0 }]
    }
}

impl Way {
    /// Where the way goes up or down in a corridor.
    pub(super) fn uprights(&self, corridor: usize) -> &[f64] {
        let at = corridor.checked_sub(self.first).filter(|at| *at < self.xs.len().max(2) - 1);
        at.map_or(&[], |at| &self.xs[at..self.xs.len().min(at + 2)])
    }
}
