//! Short forms for graphs by hand.

use bica_core::graph::{Graph, Link, LinkKind, Node, State, Transition};

/// A tree of these components, with the first for its root.
pub(crate) const fn graph(nodes: &'static [Node]) -> Graph {
    Graph { name: "Forward", doc: "", cycle_hz: 100.0, budget_ms: None, tunable: false, root: 0, nodes }
}

/// A component that declares nothing.
pub(crate) const fn node(name: &'static str) -> Node {
    Node::new(name)
}

/// A state that is neither the first nor the last.
pub(crate) const fn state(name: &'static str) -> State {
    State { name, doc: "", initial: false, last: false }
}

/// A transition without a timer.
pub(crate) const fn way(from: usize, to: usize) -> Transition {
    Transition { name: "way", doc: "", from, to, after_ms: None }
}

/// A requirement that always holds.
pub(crate) const fn to(to: usize) -> Link {
    Link { to, kind: LinkKind::Requirement, state: None }
}

/// A modulation that holds in one state.
pub(crate) const fn in_state(to: usize, state: usize) -> Link {
    Link { to, kind: LinkKind::Modulation, state: Some(state) }
}
