//! Weight of a component: the time of one run, or its share of a processor.

use super::CAPACITY;
use crate::graph::{Graph, Node};

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

/// The sum that is searched.
#[derive(Clone, Copy)]
pub(super) enum Weight {
    Time,
    Load,
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
            };
            index += 1;
        }
        weights
    }
}
