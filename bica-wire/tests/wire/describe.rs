//! The description of a tree.

use bica_core::graph::{Graph, Link, LinkKind, Node, State, Transition};
use bica_wire::describe;
use bica_wire::message::GraphItem;

const fn state(name: &'static str, initial: bool) -> State {
    State { name, doc: "", initial, last: false }
}

static GRAPH: Graph = Graph {
    name: "Pair",
    doc: "",
    cycle_hz: 100.0,
    budget_ms: None,
    tunable: false,
    root: 1,
    nodes: &[
        Node { budget_us: Some(5.0), ..Node::new("Eye") },
        Node {
            hz: Some(30.0),
            links: &[Link { to: 0, kind: LinkKind::Requirement, state: Some(1) }],
            states: &[state("rest", true), state("look", false)],
            transitions: &[Transition { name: "wakes", doc: "", from: 0, to: 1, after_ms: None }],
            ..Node::new("Head")
        },
    ],
};

#[test]
fn every_part_of_the_graph_is_described_once_and_in_order() {
    let items: Vec<_> = describe(&GRAPH).collect();
    assert_eq!(
        items,
        [
            GraphItem::Component { index: 0, name: "Eye", hz: None, budget_us: Some(5.0), root: false },
            GraphItem::Component { index: 1, name: "Head", hz: Some(30.0), budget_us: None, root: true },
            GraphItem::Link { from: 1, to: 0, modulation: false, state: Some(1) },
            GraphItem::State { component: 1, index: 0, name: "rest", initial: true },
            GraphItem::State { component: 1, index: 1, name: "look", initial: false },
            GraphItem::Transition { component: 1, from: 0, to: 1, name: "wakes" },
            GraphItem::End { items: 6 },
        ]
    );
}
