//! Several components that write one child in one cycle.

use super::worst_case::{modulates_by, most_writers};
use super::{Choice, Path, Set, WorstCase, steps};
use crate::graph::{Graph, LinkKind};

/// Components that modulate one child in one cycle.
#[derive(Clone, Copy, Debug)]
pub struct Writers {
    /// The components, in the order in which they run: by `&mut C` or `&mut Rate<C>`.
    pub order: Path,
    /// How many of them run before the child.
    pub before: usize,
    /// What the machines do in that cycle.
    pub case: WorstCase,
}

/// Returns the largest set of components that can modulate a child in one cycle; `None` if never more than one does. States of one machine
/// exclude each other.
///
/// # Panics
/// If there are more than [`CAPACITY`](super::CAPACITY) nodes, or states in one of them.
#[must_use]
pub fn writers(graph: &Graph, child: usize) -> Option<Writers> {
    let case = most_writers(graph, child, steps(graph));
    if case.sum < 2.0 {
        return None;
    }
    let mut runs = Runs { graph, case: &case, visited: Set::EMPTY, order: Path::EMPTY };
    runs.visit(graph.root);
    let (mut order, mut before) = (Path::EMPTY, 0);
    for index in runs.order.iter() {
        if index == child {
            before = order.len();
        } else if modulates_by(&graph.nodes[index], case.choices[index], child) {
            order.push(index);
        }
    }
    Some(Writers { order, before, case })
}

/// The runs of a cycle in which each machine does what a case says, and all components are due.
struct Runs<'a> {
    graph: &'a Graph,
    case: &'a WorstCase,
    visited: Set,
    order: Path,
}

impl Runs<'_> {
    fn visit(&mut self, index: usize) {
        if self.visited.contains(index) {
            return;
        }
        self.visited = self.visited.with(index);
        let (from, to) = match self.case.choices[index] {
            Choice::State(state) => (Some(state), Some(state)),
            Choice::Transition(transition) => {
                let transition = &self.graph.nodes[index].transitions[transition];
                (Some(transition.from), Some(transition.to))
            }
            Choice::None | Choice::Any => (None, None),
        };
        self.children(index, LinkKind::Requirement, from);
        self.children(index, LinkKind::Requirement, to);
        self.order.push(index);
        self.children(index, LinkKind::Modulation, to);
    }

    fn children(&mut self, index: usize, kind: LinkKind, state: Option<usize>) {
        for link in self.graph.nodes[index].links {
            if link.kind == kind && (link.state.is_none() || state.is_none() || link.state == state) {
                self.visit(link.to);
            }
        }
    }
}
