//! Expected results of the checks, from a graph library and from brute force.

use std::collections::BTreeSet;

use bica_core::check::Choice;
use bica_core::graph::{Graph, LinkKind, Node};
use petgraph::graph::{DiGraph, NodeIndex};
use petgraph::visit::Dfs;

/// Converts all links to the graph library's form.
pub(crate) fn library(nodes: &[Node]) -> DiGraph<(), ()> {
    of_edges(
        nodes.len(),
        nodes.iter().enumerate().flat_map(|(from, node)| node.links.iter().map(move |l| (from, l.to))),
    )
}

fn of_edges(len: usize, edges: impl Iterator<Item = (usize, usize)>) -> DiGraph<(), ()> {
    let mut graph = DiGraph::new();
    for _ in 0..len {
        graph.add_node(());
    }
    graph.extend_with_edges(edges.map(|(from, to)| (NodeIndex::new(from), NodeIndex::new(to))));
    graph
}

/// Components that can be reached in a graph of the library.
pub(crate) fn from_start(graph: &DiGraph<(), ()>, start: usize) -> BTreeSet<usize> {
    let mut search = Dfs::new(graph, NodeIndex::new(start));
    std::iter::from_fn(|| search.next(graph)).map(NodeIndex::index).collect()
}

/// States that a machine can enter.
pub(crate) fn states(node: &Node) -> BTreeSet<usize> {
    let graph = of_edges(node.states.len(), node.transitions.iter().map(|transition| (transition.from, transition.to)));
    let initial = (0..node.states.len()).filter(|&state| node.states[state].initial);
    initial.flat_map(|state| from_start(&graph, state)).collect()
}

/// Components that can become active.
pub(crate) fn reachable(graph: &Graph) -> BTreeSet<usize> {
    let edges = graph.nodes.iter().enumerate().flat_map(|(from, node)| {
        let states = states(node);
        node.links.iter().filter(move |l| l.state.is_none_or(|of| states.contains(&of))).map(move |l| (from, l.to))
    });
    from_start(&of_edges(graph.nodes.len(), edges), graph.root)
}

/// Behaviours of a component in one cycle.
pub(crate) fn choices(node: &Node, transitions: bool) -> Vec<Choice> {
    let possible = states(node);
    let ways = (0..node.transitions.len())
        .filter(|&transition| transitions && possible.contains(&node.transitions[transition].from));
    let mut choices: Vec<_> = ways.map(Choice::Transition).chain(possible.iter().copied().map(Choice::State)).collect();
    if choices.is_empty() {
        choices.push(Choice::None);
    }
    choices
}

/// Active components if every component has its given behaviour.
pub(crate) fn active(graph: &Graph, choices: &[Choice]) -> BTreeSet<usize> {
    let edges = graph.nodes.iter().enumerate().flat_map(|(from, node)| {
        let choice = choices[from];
        let holds = move |link: &&bica_core::graph::Link| match (link.state, choice) {
            (None, _) | (Some(_), Choice::Any) => true,
            (Some(_), Choice::None) => false,
            (Some(of), Choice::State(state)) => of == state,
            (Some(of), Choice::Transition(transition)) => {
                let transition = &node.transitions[transition];
                of == transition.to || of == transition.from && link.kind == LinkKind::Requirement
            }
        };
        node.links.iter().filter(holds).map(move |l| (from, l.to))
    });
    from_start(&of_edges(graph.nodes.len(), edges), graph.root)
}

/// Largest sum of weights over all combinations of behaviours.
pub(crate) fn worst(graph: &Graph, weights: &[f64], transitions: bool) -> f64 {
    largest(graph, transitions, |picked| active(graph, picked).iter().map(|&node| weights[node]).sum())
}

/// Largest number of components that modulate a child, over all combinations of behaviours.
pub(crate) fn most_writers(graph: &Graph, child: usize) -> usize {
    let modulates = |node: usize, choice: Choice| {
        let states = match choice {
            Choice::State(state) => vec![state],
            Choice::Transition(transition) => {
                let transition = &graph.nodes[node].transitions[transition];
                vec![transition.from, transition.to]
            }
            Choice::None | Choice::Any => Vec::new(),
        };
        let mut links = graph.nodes[node].links.iter().filter(|l| l.to == child && l.kind == LinkKind::Modulation);
        links.any(|l| l.state.is_none_or(|of| states.contains(&of)))
    };
    let count = |picked: &[Choice]| active(graph, picked).iter().filter(|&&node| modulates(node, picked[node])).count();
    largest(graph, true, |picked| count(picked) as f64) as usize
}

fn largest(graph: &Graph, transitions: bool, value: impl Fn(&[Choice]) -> f64) -> f64 {
    let choices: Vec<_> = graph.nodes.iter().map(|node| choices(node, transitions)).collect();
    let combinations = choices.iter().map(Vec::len).product();
    let sum = |combination: usize| {
        let mut rest = combination;
        let mut pick = |choices: &Vec<Choice>| {
            let choice = choices[rest % choices.len()];
            rest /= choices.len();
            choice
        };
        let picked: Vec<_> = choices.iter().map(&mut pick).collect();
        value(&picked)
    };
    (0..combinations).map(sum).fold(0.0, f64::max)
}
