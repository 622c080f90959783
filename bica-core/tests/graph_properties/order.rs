//! Cycles, ranks and reachability, compared with the graph library.

use std::collections::BTreeSet;

use bica_core::check::{Violation, cycle, first_violation, ranks, reachable, states_reached, unreachable};
use petgraph::algo::{is_cyclic_directed, tarjan_scc};
use petgraph::graph::NodeIndex;
use proptest::prelude::*;

use crate::graph_properties::generate::{acyclic_graph, any_graph};
use crate::graph_properties::naive;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn cycle_is_found_iff_there_is_one(graph in any_graph(12)) {
        let found = cycle(graph.nodes);
        prop_assert_eq!(found.is_some(), is_cyclic_directed(&naive::library(graph.nodes)));
        if let Some(path) = found {
            let path: Vec<_> = path.iter().collect();
            for pair in path.windows(2) {
                prop_assert!(graph.nodes[pair[0]].links.iter().any(|link| link.to == pair[1]));
            }
            let round: BTreeSet<_> = path.iter().copied().collect();
            prop_assert!(path.len() > 1);
            prop_assert_eq!(path.len(), round.len() + 1, "each component once, except for the first");
            prop_assert_eq!(path.first(), path.last());
            prop_assert_eq!(path.first(), round.first());
        }
    }

    #[test]
    fn acyclic_graphs_have_no_cycle(graph in acyclic_graph(12)) {
        prop_assert!(cycle(graph.nodes).is_none());
    }

    #[test]
    fn ranks_put_activators_first(graph in acyclic_graph(12)) {
        let ranks: [usize; 12] = ranks(graph.nodes);
        prop_assert!(is_permutation(&ranks, graph.nodes.len()));
        for (from, node) in graph.nodes.iter().enumerate() {
            for link in node.links {
                prop_assert!(ranks[from] < ranks[link.to]);
            }
        }
    }

    #[test]
    fn ranks_of_cyclic_graphs_are_a_permutation(graph in any_graph(12)) {
        let ranks: [usize; 12] = ranks(graph.nodes);
        prop_assert!(is_permutation(&ranks, graph.nodes.len()));
        let behind = on_or_behind_cycles(graph.nodes);
        let free = graph.nodes.len() - behind.len();
        for node in behind {
            prop_assert!(ranks[node] >= free);
        }
    }

    #[test]
    fn reachability_equals_that_of_the_library(graph in any_graph(12)) {
        let reached = naive::reachable(&graph);
        for node in 0..graph.nodes.len() {
            prop_assert_eq!(reachable(&graph).contains(node), reached.contains(&node));
            let states = naive::states(&graph.nodes[node]);
            for state in 0..graph.nodes[node].states.len() {
                prop_assert_eq!(states_reached(&graph.nodes[node]).contains(state), states.contains(&state));
            }
        }
        let missed: Vec<_> = (0..graph.nodes.len()).filter(|node| !reached.contains(node)).collect();
        prop_assert_eq!(unreachable(&graph).iter().collect::<Vec<_>>(), missed);
    }

    #[test]
    fn cycles_are_reported_before_their_consequences(graph in any_graph(12)) {
        let cyclic = is_cyclic_directed(&naive::library(graph.nodes));
        let whole = naive::reachable(&graph).len() == graph.nodes.len();
        match first_violation(&graph) {
            Some(Violation::Cycle(_)) => prop_assert!(cyclic),
            Some(Violation::Unreachable(_)) => prop_assert!(!cyclic && !whole),
            _ => prop_assert!(!cyclic && whole),
        }
    }
}

fn is_permutation(ranks: &[usize], len: usize) -> bool {
    let (ranks, rest) = ranks.split_at(len);
    ranks.iter().copied().collect::<BTreeSet<_>>() == (0..len).collect() && rest.iter().all(|&rank| rank == 12)
}

fn on_or_behind_cycles(nodes: &[bica_core::graph::Node]) -> BTreeSet<usize> {
    let graph = naive::library(nodes);
    let knots = tarjan_scc(&graph).into_iter().filter(|knot| knot.len() > 1 || graph.contains_edge(knot[0], knot[0]));
    knots.flatten().map(NodeIndex::index).flat_map(|node| naive::from_start(&graph, node)).collect()
}
