//! Layout of a state machine: states in rows by their distance from the initial one. Each transition has a lane of its own where it
//! goes aside, with its name on it, so that no line runs through a state, and no name covers a name or a state.

use super::lanes::Draft;
use super::parts::{Arrow, Look, Machine};
use super::rows::Graph;

/// Number of states above which only one number of columns is tried.
const FEW: usize = 40;

impl Machine {
    /// Lays a machine out for a panel of a shape, width by height; `sizes` are width and height of each state, px.
    #[must_use]
    pub fn new(sizes: &[(f64, f64)], initial: usize, arrows: &[Arrow], shape: f64, look: &Look) -> Self {
        let links = arrows.iter().filter_map(|arrow| Some((arrow.from?, arrow.to)));
        let graph = Graph::new(sizes.len(), links);
        let order = graph.order(initial);
        let usual = (sizes.len() as f64 * shape * look.cell.1 / look.cell.0).sqrt().round().max(1.0) as usize;
        let tries = if sizes.len() > FEW { vec![usual] } else { vec![usual, usual + 1, usual + 2, (usual - 1).max(1)] };
        let scale = |one: &Self| (shape / one.area.width).min(1.0 / one.area.height);
        let tried = tries.into_iter().map(|columns| {
            let rows = order.chunks(columns).map(<[usize]>::to_vec).collect();
            Draft::new(sizes, arrows, look, &graph, rows).laid_out()
        });
        tried.reduce(|best, one| if scale(&one) > scale(&best) { one } else { best }).unwrap_or_default()
    }
}

impl Graph {
    /// States by their distance from the initial one; those that it does not reach last.
    fn order(&self, initial: usize) -> Vec<usize> {
        let mut order: Vec<usize> = Vec::new();
        let mut at = 0;
        for start in [initial].into_iter().chain(0..self.targets.len()).filter(|start| *start < self.targets.len()) {
            if !order.contains(&start) {
                order.push(start);
            }
            while let Some(&state) = order.get(at) {
                at += 1;
                for to in &self.targets[state] {
                    if !order.contains(to) {
                        order.push(*to);
                    }
                }
            }
        }
        order
    }
}
