//! Expected results of the checks, from a graph library and from brute force.

use std::collections::BTreeSet;

use bica_core::check::{CAPACITY, Choice, ranks};
use bica_core::graph::{Graph, InForce, LinkKind, Node};
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

/// The components that modulate a child, in the order in which they run if every component has its given behaviour, and how many of them
/// run before the child.
pub(crate) fn writers(graph: &Graph, choices: &[Choice], child: usize) -> (Vec<usize>, usize) {
    let (mut order, mut put_off) = (Vec::new(), BTreeSet::new());
    let mut visited = vec![false; graph.nodes.len()];
    visit(graph, choices, graph.root, &mut (&mut order, &mut visited, &mut put_off));
    // Whatever is put off while this goes on comes after what puts it off.
    let ranks: [usize; CAPACITY] = ranks(graph.nodes);
    while let Some(next) = put_off.iter().copied().min_by_key(|index| ranks[*index]) {
        put_off.remove(&next);
        visit(graph, choices, next, &mut (&mut order, &mut visited, &mut put_off));
    }
    let of_child = |index: &usize| {
        let link = |link: &&bica_core::graph::Link| link.to == child && link.kind == LinkKind::Modulation;
        graph.nodes[*index].links.iter().filter(link).any(|link| match (link.state, choices[*index]) {
            (None, _) | (Some(_), Choice::None | Choice::Any) => true,
            (Some(of), Choice::State(state)) => of == state,
            (Some(of), Choice::Transition(transition)) => {
                let transition = &graph.nodes[*index].transitions[transition];
                of == transition.from || of == transition.to
            }
        })
    };
    let until = order.iter().position(|index| *index == child).unwrap_or(0);
    let before = order[..until].iter().filter(|index| of_child(index)).count();
    (order.into_iter().filter(of_child).collect(), before)
}

type Run<'a> = (&'a mut Vec<usize>, &'a mut Vec<bool>, &'a mut BTreeSet<usize>);

fn visit(graph: &Graph, choices: &[Choice], index: usize, run: &mut Run<'_>) {
    if std::mem::replace(&mut run.1[index], true) {
        return;
    }
    let (from, to) = match choices[index] {
        Choice::State(state) => (Some(state), Some(state)),
        Choice::Transition(transition) => {
            let transition = &graph.nodes[index].transitions[transition];
            (Some(transition.from), Some(transition.to))
        }
        Choice::None | Choice::Any => (None, None),
    };
    let children = |kind: LinkKind, state: Option<usize>, run: &mut Run<'_>| {
        let holds = |link: &&bica_core::graph::Link| {
            link.kind == kind && (link.state.is_none() || state.is_none() || link.state == state)
        };
        for link in graph.nodes[index].links.iter().filter(holds) {
            if graph.nodes[link.to].writers == Some(InForce::Last) {
                run.2.insert(link.to);
            } else {
                visit(graph, choices, link.to, run);
            }
        }
    };
    children(LinkKind::Requirement, from, run);
    children(LinkKind::Requirement, to, run);
    run.0.push(index);
    children(LinkKind::Modulation, to, run);
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
