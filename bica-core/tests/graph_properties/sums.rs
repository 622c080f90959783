//! Longest chain and load, compared with all combinations of states.

use std::collections::BTreeSet;

use bica_core::check::{
    Choice, Violation, WorstCase, first_violation, load, longest_chain, most_writers, steps, writers,
};
use bica_core::graph::{Graph, Node};
use proptest::prelude::*;

use crate::graph_properties::build;
use crate::graph_properties::generate::acyclic_graph;
use crate::graph_properties::naive;

/// Number of steps that is sufficient for the graphs here.
const STEPS: usize = 1_000_000;

fn budgets(graph: &Graph) -> Vec<f64> {
    graph.nodes.iter().map(|node| f64::from(node.budget_us.unwrap_or(0.0))).collect()
}

fn loads(graph: &Graph) -> Vec<f64> {
    let hz = |node: &Node| f64::from(node.hz.unwrap_or(graph.cycle_hz));
    graph.nodes.iter().zip(budgets(graph)).map(|(node, budget)| budget * 1e-6 * hz(node)).collect()
}

fn members(worst: &WorstCase) -> BTreeSet<usize> {
    (0..bica_core::check::CAPACITY).filter(|&node| worst.active.contains(node)).collect()
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * a.abs().max(b.abs())
}

/// Whether the reported components are those that the reported choices activate, and their sum is the reported one.
fn is_consistent(graph: &Graph, worst: &WorstCase, weights: &[f64]) -> bool {
    let active = naive::active(graph, &worst.choices[..graph.nodes.len()]);
    let silent = |node: usize| active.contains(&node) || worst.choices[node] == Choice::None;
    members(worst) == active
        && close(active.iter().map(|&node| weights[node]).sum(), worst.sum)
        && (0..graph.nodes.len()).all(silent)
}

#[test]
fn a_budget_includes_its_limit() {
    for budget_us in 1..=20_000_u32 {
        let of = |budget_us: u32| {
            let node = Node { budget_us: Some(budget_us as f32), ..build::node("Only") };
            Graph { nodes: vec![node].leak(), budget_ms: None, cycle_hz: 1.0, ..build::graph(&[]) }
        };
        let budget_ms = Some(budget_us as f32 / 1e3);
        let exact = first_violation(&Graph { budget_ms, ..of(budget_us) });
        assert!(exact.is_none(), "{budget_us} µs: {exact:?}");
        let over = first_violation(&Graph { budget_ms, ..of(budget_us + 1) });
        assert!(matches!(over, Some(Violation::OverBudget(_))), "{budget_us} µs: {over:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]

    #[test]
    fn longest_chain_is_the_maximum(graph in acyclic_graph(5)) {
        let found = longest_chain(&graph, STEPS);
        prop_assert!(found.exact);
        prop_assert!(close(found.sum, naive::worst(&graph, &budgets(&graph), true)));
        prop_assert!(is_consistent(&graph, &found, &budgets(&graph)));
    }

    #[test]
    fn load_is_the_maximum_over_all_combinations(graph in acyclic_graph(5)) {
        let found = load(&graph, STEPS);
        prop_assert!(found.exact);
        prop_assert!(close(found.sum, naive::worst(&graph, &loads(&graph), false)));
        prop_assert!(is_consistent(&graph, &found, &loads(&graph)));
    }

    #[test]
    fn writers_of_a_child_are_all_that_can_meet(graph in acyclic_graph(5), child in 0..5_usize) {
        let child = child % graph.nodes.len();
        let found = most_writers(&graph, child, STEPS);
        prop_assert!(found.exact);
        prop_assert_eq!(found.sum as usize, naive::most_writers(&graph, child));
        let listed = writers(&graph, child);
        let count = listed.map_or(0, |writers| writers.order.len());
        prop_assert_eq!(count, if found.sum < 2.0 { 0 } else { found.sum as usize });
        if let Some(listed) = listed {
            let expected = naive::writers(&graph, &listed.case.choices, child);
            prop_assert_eq!((listed.order.iter().collect(), listed.before), expected);
        }
    }

    #[test]
    fn several_writers_ask_for_a_word(graph in acyclic_graph(5)) {
        // Budgets and rates have no other violations then.
        let nodes: Vec<_> = graph.nodes.iter().map(|node| Node { budget_us: None, hz: None, ..*node }).collect();
        let graph = Graph { nodes: nodes.leak(), ..graph };
        let open = |child: &usize| graph.nodes[*child].writers.is_none() && naive::most_writers(&graph, *child) > 1;
        match first_violation(&graph) {
            Some(Violation::Unreachable(_)) => {}
            Some(Violation::Unordered(child)) => prop_assert_eq!((0..graph.nodes.len()).find(open), Some(child)),
            None => prop_assert_eq!((0..graph.nodes.len()).find(open), None),
            Some(other) => prop_assert!(false, "{:?}", other),
        }
    }

    #[test]
    fn limited_search_is_never_below(graph in acyclic_graph(5), steps in 0..12_usize) {
        for (found, weights, ways) in [
            (longest_chain(&graph, steps), budgets(&graph), true),
            (load(&graph, steps), loads(&graph), false),
        ] {
            let worst = naive::worst(&graph, &weights, ways);
            let all: f64 = naive::reachable(&graph).iter().map(|&node| weights[node]).sum();
            prop_assert!(found.sum >= worst * (1.0 - 1e-12));
            prop_assert!(found.sum <= all * (1.0 + 1e-12));
            prop_assert!(!found.exact || close(found.sum, worst));
        }
    }

    #[test]
    fn sums_are_compared_with_the_declared_limits(graph in acyclic_graph(5), budget_us in 1..20_000_u32) {
        let graph = Graph { budget_ms: Some(budget_us as f32 / 1e3), ..graph };
        let time = naive::worst(&graph, &budgets(&graph), true);
        let share = naive::worst(&graph, &loads(&graph), false);
        match first_violation(&graph) {
            Some(Violation::Unreachable(_) | Violation::Unordered(_)) => {}
            Some(Violation::OverBudget(found)) => prop_assert!(time > f64::from(budget_us) && close(found.sum, time)),
            Some(Violation::Overload(found)) => prop_assert!(time <= f64::from(budget_us) && share > 1.0 && found.exact),
            None => prop_assert!(time <= f64::from(budget_us) && share <= 1.0),
            Some(other) => prop_assert!(false, "{:?}", other),
        }
    }

    #[test]
    fn small_trees_are_searched_exactly(graph in acyclic_graph(12)) {
        prop_assert!(longest_chain(&graph, steps(&graph)).exact);
        prop_assert!(load(&graph, steps(&graph)).exact);
    }
}
