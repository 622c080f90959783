//! Evaluation of the checks in constants, as in generated code.

use bica_core::check::{CAPACITY, check, cycle, first_violation, longest_chain, ranks, steps};
use bica_core::graph::{Graph, InForce, Link, Node, State, Transition};

use crate::graph_properties::build::{graph, in_state, node, state, to, transition};

static NODES: [Node; 3] = [
    Node { links: &[to(1)], ..node("Look") },
    Node { links: &[to(2)], budget_us: Some(30.0), ..node("FaceBall") },
    Node { budget_us: Some(12.5), ..node("Head") },
];
const GRAPH: Graph = graph(&NODES);
const RANKS: [usize; 3] = ranks(&NODES);
const CHAIN_US: u32 = longest_chain(&GRAPH, 10).sum as u32;

const _: () = check(&GRAPH);
const _: () = assert!(cycle(&[Node { links: &[to(0)], ..node("Player") }]).is_some());

#[test]
fn constants_equal_the_results_of_calls() {
    assert_eq!(RANKS, [0, 1, 2]);
    assert_eq!(CHAIN_US, 42);
}

const STATES: [State; 3] = [State { initial: true, ..state("a") }, state("b"), state("c")];
const TRANSITIONS: [Transition; 3] = [transition(0, 1), transition(1, 2), transition(2, 0)];

/// In each of three states each component activates another one of the next three.
static LINKS: [[Link; 3]; CAPACITY] = {
    let mut links = [[in_state(0, 0); 3]; CAPACITY];
    let mut index = 0;
    while index < CAPACITY {
        links[index] = [in_state(index + 1, 0), in_state(index + 2, 1), in_state(index + 3, 2)];
        index += 1;
    }
    links
};

static MACHINES: [Node; CAPACITY] = {
    let writers = Some(InForce::First);
    let mut nodes = [Node { writers, ..node("Last") }; CAPACITY];
    let mut index = 0;
    while index < CAPACITY - 3 {
        let budget_us = Some(1.0 + (index * 7 % 13) as f32);
        let (states, transitions) = (&STATES, &TRANSITIONS);
        nodes[index] = Node { links: &LINKS[index], states, transitions, budget_us, writers, ..node("Machine") };
        index += 1;
    }
    nodes
};

/// Largest tree that can be checked; it needs more search steps than the limit.
const LARGEST: Graph = Graph { budget_ms: Some(1e6), ..graph(&MACHINES) };
const _: () = check(&LARGEST);

#[test]
fn largest_tree_is_within_compiler_limits() {
    assert!(first_violation(&LARGEST).is_none());
    assert!(!longest_chain(&LARGEST, steps(&LARGEST)).exact);
}
