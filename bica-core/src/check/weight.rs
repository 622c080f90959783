//! Weight of a component: the time of one run, its share of a processor, or whether it modulates a child.

use super::CAPACITY;
use crate::graph::{Graph, LinkKind, Node};

/// The declared time of one run in µs; 0 if none is declared.
pub(super) const fn budget_us(node: &Node) -> f64 {
    match node.budget_us {
        Some(budget) => budget as f64,
        None => 0.0,
    }
}

/// How often a component runs, 1/s: its rate, or the cycle's if it declares none.
pub(super) const fn hz(graph: &Graph, node: &Node) -> f64 {
    match node.hz {
        Some(hz) => hz as f64,
        None => graph.cycle_hz as f64,
    }
}

/// Whether a component modulates a child: in one of its states, or in any.
pub(super) const fn modulates(node: &Node, state: Option<usize>, child: usize) -> bool {
    let mut index = 0;
    while index < node.links.len() {
        let link = &node.links[index];
        let holds = match (link.state, state) {
            (Some(of), Some(state)) => of == state,
            _ => true,
        };
        if holds && link.to == child && matches!(link.kind, LinkKind::Modulation) {
            return true;
        }
        index += 1;
    }
    false
}

/// The sum that is searched.
#[derive(Clone, Copy)]
pub(super) enum Weight {
    Time,
    Load,
    /// Whether the component modulates a child.
    Modulates(usize),
}

impl Weight {
    /// The weight of each node.
    pub(super) const fn of_all(self, graph: &Graph) -> [f64; CAPACITY] {
        let mut weights = [0.0; CAPACITY];
        let mut index = 0;
        while index < graph.nodes.len() {
            let node = &graph.nodes[index];
            weights[index] = match self {
                Self::Time => budget_us(node),
                Self::Load => budget_us(node) * hz(graph, node) * 1e-6,
                Self::Modulates(child) => modulates(node, None, child) as u8 as f64,
            };
            index += 1;
        }
        weights
    }
}
