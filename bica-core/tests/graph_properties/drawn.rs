//! Content that drawings of a graph must show, in all formats.

use std::collections::BTreeSet;

use bica_core::check::writers;
use bica_core::graph::{Graph, LinkKind, Node, QueryKind};

/// Text as a drawing can show it.
fn shown(text: &str) -> String {
    text.replace(|character: char| character.is_control(), " ")
}

/// Arrow: from, to, whether it is dashed, label.
pub(crate) type Arrow = (usize, usize, bool, String);

pub(crate) fn figures(graph: &Graph, index: usize) -> String {
    let node = &graph.nodes[index];
    let rate = node.hz.map_or("every cycle".into(), |hz| format!("{hz} Hz"));
    let budget = node.budget_us.map_or(String::new(), |budget| format!(" · {budget} µs"));
    let written = writers(graph, index).map_or(String::new(), |writers| {
        let names: Vec<_> = writers.order.iter().map(|index| shown(graph.nodes[index].name)).collect();
        let in_force = shown(graph.nodes[writers.in_force()].name);
        format!(" · written by {}; in force: {in_force}", names.join(", then "))
    });
    rate + &budget + &written
}

pub(crate) fn names(graph: &Graph) -> Vec<String> {
    graph.nodes.iter().map(|node| shown(node.name)).collect()
}

pub(crate) fn arrows(graph: &Graph) -> BTreeSet<Arrow> {
    let links = graph.nodes.iter().enumerate().flat_map(|(from, node)| node.links.iter().map(move |link| (from, link)));
    links.map(|(from, link)| (from, link.to, link.kind == LinkKind::Requirement, label(graph, from, link))).collect()
}

/// Queries: from, of, word.
pub(crate) fn queries(graph: &Graph) -> BTreeSet<(usize, usize, String)> {
    let all =
        graph.nodes.iter().enumerate().flat_map(|(from, node)| node.queries.distinct().map(move |one| (from, one)));
    let word = |kind| if kind == QueryKind::Age { "age" } else { "outcome" };
    all.map(|(from, query)| (from, query.of, word(query.kind).to_owned())).collect()
}

fn label(graph: &Graph, from: usize, like: &bica_core::graph::Link) -> String {
    let same = graph.nodes[from].links.iter().filter(|link| link.to == like.to && link.kind == like.kind);
    let asks = |role: &usize| same.clone().any(|link| link.roles.contains(*role));
    let roles: Vec<_> = (0..graph.roles.len()).filter(asks).map(|role| shown(graph.roles[role])).collect();
    let is_any = !roles.is_empty();
    let (roles, states) = (roles.join(", "), when(graph, from, like));
    let separator = if is_any && states.is_some() { " · " } else { "" };
    roles + separator + &states.unwrap_or_default()
}

fn when(graph: &Graph, from: usize, like: &bica_core::graph::Link) -> Option<String> {
    let node = &graph.nodes[from];
    let same = node.links.iter().filter(|link| link.to == like.to && link.kind == like.kind);
    let states: BTreeSet<_> = same.map(|link| link.state).collect();
    if states.contains(&None) || states.len() == node.states.len() {
        return None;
    }
    Some(shown(&states.into_iter().flatten().map(|state| node.states[state].name).collect::<Vec<_>>().join(", ")))
}

/// Transitions of a machine: from, to, label. In order, because several may look the same.
pub(crate) fn transitions(node: &Node) -> Vec<(usize, usize, String)> {
    let after = |transition: &bica_core::graph::Transition| {
        transition.after_ms.map_or(String::new(), |ms| format!(", after {ms} ms"))
    };
    node.transitions
        .iter()
        .map(|transition| (transition.from, transition.to, shown(transition.name) + &after(transition)))
        .collect()
}

/// States of a machine: name, whether it is initial, whether it is terminal.
pub(crate) fn states(node: &Node) -> Vec<(String, bool, bool)> {
    node.states.iter().map(|state| (shown(state.name), state.initial, state.last)).collect()
}
