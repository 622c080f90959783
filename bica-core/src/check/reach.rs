//! Reachability: of components from the root, of states from the initial one.

use super::{Path, Set};
use crate::graph::{Graph, LinkKind, Node};

/// Returns the components that some sequence of states can activate.
///
/// # Panics
/// If there are more than [`CAPACITY`](super::CAPACITY) nodes.
#[must_use]
pub const fn reachable(graph: &Graph) -> Set {
    let mut reached = Set::EMPTY.with(graph.root);
    let mut expanded = Set::EMPTY;
    let mut changed = true;
    while changed {
        changed = false;
        let mut node = 0;
        while node < graph.nodes.len() {
            if reached.contains(node) && !expanded.contains(node) {
                reached = reached.union(all_links(&graph.nodes[node]));
                expanded = expanded.with(node);
                changed = true;
            }
            node += 1;
        }
    }
    reached
}

/// Returns the components that no component reachable from the root can activate, in the order of the list.
///
/// # Panics
/// If there are more than [`CAPACITY`](super::CAPACITY) nodes.
#[must_use]
pub const fn unreachable(graph: &Graph) -> Path {
    let reached = reachable(graph);
    let mut path = Path::EMPTY;
    let mut node = 0;
    while node < graph.nodes.len() {
        if !reached.contains(node) {
            path.push(node);
        }
        node += 1;
    }
    path
}

/// Returns what a component can activate in any of its states.
pub(super) const fn all_links(node: &Node) -> Set {
    let states = states_reached(node);
    let mut to = Set::EMPTY;
    let mut link = 0;
    while link < node.links.len() {
        let possible = match node.links[link].state {
            None => true,
            Some(state) => states.contains(state),
        };
        if possible {
            to = to.with(node.links[link].to);
        }
        link += 1;
    }
    to
}

/// Returns what a component activates through the links of one state, or those that always hold.
pub(super) const fn links_in(node: &Node, state: Option<usize>, requirements_only: bool) -> Set {
    let mut to = Set::EMPTY;
    let mut link = 0;
    while link < node.links.len() {
        let wanted = !requirements_only || matches!(node.links[link].kind, LinkKind::Requirement);
        let holds = match (node.links[link].state, state) {
            (None, None) => true,
            (Some(of), Some(state)) => of == state,
            _ => false,
        };
        if wanted && holds {
            to = to.with(node.links[link].to);
        }
        link += 1;
    }
    to
}

/// Returns the states that a machine can reach, by index in [`Node::states`].
///
/// # Panics
/// If there are more than [`CAPACITY`](super::CAPACITY) states.
#[must_use]
pub const fn states_reached(node: &Node) -> Set {
    let mut reached = Set::EMPTY;
    let mut state = 0;
    while state < node.states.len() {
        if node.states[state].initial {
            reached = reached.with(state);
        }
        state += 1;
    }
    let mut transition = 0;
    while transition < node.transitions.len() {
        let edge = &node.transitions[transition];
        if reached.contains(edge.from) && !reached.contains(edge.to) {
            reached = reached.with(edge.to);
            transition = 0;
        } else {
            transition += 1;
        }
    }
    reached
}
