//! Constructors of graphs for tests.

use bica_core::graph::{Graph, Link, LinkKind, Node, Roles, State, Transition};

/// Tree of these components; the first one is the root.
pub(crate) const fn graph(nodes: &'static [Node]) -> Graph {
    let (version, commit) = (None, None);
    Graph {
        name: "Forward",
        doc: "",
        cycle_hz: 100.0,
        budget_ms: None,
        tunable: false,
        version,
        commit,
        root: 0,
        nodes,
        roles: &["Ball", "Legs"],
    }
}

/// Component without declarations.
pub(crate) const fn node(name: &'static str) -> Node {
    Node::new(name)
}

/// State that is neither initial nor terminal.
pub(crate) const fn state(name: &'static str) -> State {
    State { name, doc: "", initial: false, last: false, end: None, before: None }
}

/// Transition without a timer.
pub(crate) const fn transition(from: usize, to: usize) -> Transition {
    Transition::new("transition", from, to)
}

/// Requirement in all states.
pub(crate) const fn to(to: usize) -> Link {
    Link { to, kind: LinkKind::Requirement, state: None, roles: Roles::NONE }
}

/// Modulation in one state.
pub(crate) const fn in_state(to: usize, state: usize) -> Link {
    Link { to, kind: LinkKind::Modulation, state: Some(state), roles: Roles::NONE }
}
