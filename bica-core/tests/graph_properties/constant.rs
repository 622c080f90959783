//! The checks in constants, as the macros use them.

use bica_core::check::{Worst, check, cycle, longest_chain, ranks};
use bica_core::graph::{Graph, Link, LinkKind, Node};

use crate::build::{graph, node, to};

const NODES: [Node; 3] = [
    Node { links: &[to(1)], ..node("Look") },
    Node { links: &[to(2)], budget_us: Some(30.0), ..node("FaceBall") },
    Node { budget_us: Some(12.5), ..node("Head") },
];
const GRAPH: Graph = graph(&NODES);
const _: () = check(&GRAPH);
const RANKS: [usize; 3] = ranks(&NODES);
const CHAIN: Worst = longest_chain(&GRAPH, 10);
const CYCLE: bool =
    cycle(&[Node { links: &[Link { to: 0, kind: LinkKind::Requirement, state: None }], ..NODES[2] }]).is_some();

#[test]
fn constants_say_what_calls_say() {
    assert_eq!(RANKS, [0, 1, 2]);
    assert_eq!(CHAIN.sum, 42.5);
    assert!(CYCLE);
}

/// As large as can be checked, with as much to search as the limit allows: the compiler's own limit is not reached.
mod largest {
    use bica_core::check::{CAPACITY, check, first, longest_chain, steps};
    use bica_core::graph::{Graph, Node, State, Transition};

    use crate::build::{graph, in_state, node, state, way};

    const STATES: [State; 3] = [State { initial: true, ..state("a") }, state("b"), state("c")];
    const WAYS: [Transition; 3] = [way(0, 1), way(1, 2), way(2, 0)];

    /// Machines whose states activate one of the next three components each.
    const MACHINES: [Node; CAPACITY] = {
        let mut nodes = [node("Last"); CAPACITY];
        let mut index = 0;
        while index < CAPACITY - 3 {
            nodes[index] = Node {
                links: LINKS[index],
                states: &STATES,
                transitions: &WAYS,
                budget_us: Some(1.0 + (index * 7 % 13) as f32),
                ..node("Machine")
            };
            index += 1;
        }
        nodes
    };
    const LINKS: [&[bica_core::graph::Link]; CAPACITY] = {
        const NEXT: [[bica_core::graph::Link; 3]; CAPACITY] = {
            let mut links = [[in_state(0, 0); 3]; CAPACITY];
            let mut index = 0;
            while index < CAPACITY {
                links[index] = [in_state(index + 1, 0), in_state(index + 2, 1), in_state(index + 3, 2)];
                index += 1;
            }
            links
        };
        let mut slices: [&[bica_core::graph::Link]; CAPACITY] = [&[]; CAPACITY];
        let mut index = 0;
        while index < CAPACITY {
            slices[index] = &NEXT[index];
            index += 1;
        }
        slices
    };
    const LARGEST: Graph = Graph { budget_ms: Some(1e6), ..graph(&MACHINES) };
    const _: () = check(&LARGEST);

    #[test]
    fn the_search_is_limited() {
        assert!(first(&LARGEST).is_none());
        assert!(!longest_chain(&LARGEST, steps(&LARGEST)).exact);
    }
}
