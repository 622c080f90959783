//! The `GRAPH` that the model interprets agrees with the source: two graphs written by hand, and the order of lists.

use bica::ComponentId;
use bica::Tree;
use bica::graph::{Graph, LinkKind, Node};

use crate::support::test_tree::TestTree;
use crate::trees::chain::Chain;
use crate::trees::modulated::Modulated;
use crate::trees::resume::Resume;
use crate::trees::swap::Swap;
use crate::trees::timers::Timers;

/// Links of a component: end, kind and state by name, sorted.
fn links(graph: Graph, of: &str) -> Vec<(&'static str, &'static str, &'static str)> {
    let node = node(graph, of);
    let kind = |kind: LinkKind| if kind == LinkKind::Requirement { "reads" } else { "writes" };
    let state = |state: Option<usize>| state.map_or("", |state| node.states[state].name);
    let mut links: Vec<_> = node.links.iter().map(|l| (state(l.state), kind(l.kind), graph.nodes[l.to].name)).collect();
    links.sort_unstable();
    links
}

fn transitions(graph: Graph, of: &str) -> Vec<(&'static str, &'static str, &'static str, Option<u32>)> {
    let node = node(graph, of);
    let name = |state: usize| node.states[state].name;
    node.transitions.iter().map(|way| (way.name, name(way.from), name(way.to), way.after_ms)).collect()
}

fn node(graph: Graph, of: &str) -> &'static Node {
    graph.nodes.iter().find(|node| node.name == of).expect("a component of the tree")
}

#[test]
fn the_links_are_those_of_the_signatures() {
    assert_eq!(links(Chain::GRAPH, "Middle"), [("", "writes", "Lower")]);
    assert_eq!(links(Chain::GRAPH, "Lower"), [("", "reads", "Sensor")]);
    let swap = [
        ("left", "reads", "Both"),
        ("left", "writes", "Left"),
        ("rest", "reads", "Left"),
        ("rest", "reads", "Sensor"),
        ("right", "reads", "Right"),
        ("right", "reads", "Sensor"),
        ("right", "writes", "Both"),
    ];
    assert_eq!(links(Swap::GRAPH, "Chooser"), swap);
    assert_eq!(
        links(Swap::GRAPH, "Left"),
        [("busy", "writes", "Motor"), ("idle", "reads", "Motor"), ("idle", "reads", "Sensor"),]
    );
    let worker = [("alert", "writes", "Eye"), ("alert", "writes", "Hand"), ("calm", "reads", "Eye")];
    assert_eq!(links(Modulated::GRAPH, "Worker"), worker);
}

#[test]
fn hooks_and_transitions_have_links_in_their_states() {
    let clockwork = [
        ("done", "writes", "Lamp"),
        ("fallen", "reads", "Eye"),
        ("wait", "reads", "Eye"),
        ("wait", "reads", "Sensor"),
        ("work", "reads", "Sensor"),
        ("work", "writes", "Lamp"),
        ("work", "writes", "Motor"),
    ];
    assert_eq!(links(Timers::GRAPH, "Clockwork"), clockwork);
}

#[test]
fn transitions_are_in_source_order() {
    let chooser = [
        ("go_left", "rest", "left", None),
        ("go_right", "rest", "right", None),
        ("go_right", "left", "right", None),
        ("back", "right", "left", None),
        ("stop", "left", "rest", None),
        ("stop", "right", "rest", None),
    ];
    assert_eq!(transitions(Swap::GRAPH, "Chooser"), chooser);
    let clockwork = [
        ("falls", "wait", "fallen", None),
        ("falls", "work", "fallen", None),
        ("timer_wait", "wait", "work", Some(100)),
        ("pause", "work", "wait", Some(250)),
        ("timer_work", "work", "wait", Some(900)),
        ("finish", "work", "done", None),
        ("up", "fallen", "wait", Some(1)),
    ];
    assert_eq!(transitions(Timers::GRAPH, "Clockwork"), clockwork);
}

#[test]
fn indices_are_positions_in_the_component_list() {
    for (index, node) in Timers::GRAPH.nodes.iter().enumerate() {
        assert_eq!(Timers::new().unit(index).read().0, node.name);
        assert!(!Timers::new().is_active(ComponentId::new(index)));
    }
    assert_eq!(Timers::GRAPH.nodes[Timers::GRAPH.root].name, "Owner");
}

#[test]
fn attributes_are_as_declared() {
    let resuming = Resume::GRAPH.nodes.iter().filter(|node| node.resume).map(|node| node.name);
    assert_eq!(resuming.collect::<Vec<_>>(), ["Resuming"]);
    assert_eq!(
        node(Resume::GRAPH, "Resuming").states.iter().map(|s| s.initial).collect::<Vec<_>>(),
        [false, true, false]
    );
    assert_eq!(node(Chain::GRAPH, "Middle").hz, Some(20.0));
    assert_eq!(node(Chain::GRAPH, "Top").hz, None);
    let last = node(Timers::GRAPH, "Clockwork").states.iter().filter(|state| state.last).map(|state| state.name);
    assert_eq!(last.collect::<Vec<_>>(), ["done"]);
}
