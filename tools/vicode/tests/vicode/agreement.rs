//! The model is what the macro makes of the same text.

use std::collections::BTreeSet;

use bica::Tree;
use bica::graph::{Graph, LinkKind, Node};
use bica_vicode::model::{Component, Edge, Graph as Read, ParameterGroup};

use crate::sources;

fn number(component: &Component, key: &str) -> Option<f32> {
    component.options.get(key).map(|one| one.value.as_ref().unwrap().text.parse().unwrap())
}

/// Compares a component with its node in `GRAPH`.
fn agrees(component: &Component, node: &Node, graph: &Graph) {
    let name = node.name;
    assert_eq!(component.docs.text, node.doc, "{name}");
    assert_eq!((number(component, "hz"), number(component, "budget_us")), (node.hz, node.budget_us), "{name}");
    assert_eq!(component.options.get("resume").is_some(), node.resume, "{name}");
    let states: Vec<_> = component
        .states
        .iter()
        .map(|one| (&*one.function.name.text, &*one.function.docs.text, one.initial, one.last))
        .collect();
    let expected: Vec<_> = node.states.iter().map(|one| (one.name, one.doc, one.initial, one.last)).collect();
    assert_eq!(states, expected, "{name}");
    let read = Read::of(component);
    let edge = |one: &bica::graph::Transition| Edge {
        name: one.name.to_owned(),
        from: one.from,
        to: one.to,
        after_ms: one.after_ms,
    };
    assert_eq!(read.edges, node.transitions.iter().map(edge).collect::<Vec<_>>(), "{name}");
    let kind = |modulation: bool| if modulation { "modulation" } else { "requirement" };
    let links: BTreeSet<_> = read
        .links
        .iter()
        .map(|link| (link.state, link.child.clone(), kind(link.kind != bica_vicode::model::LinkKind::Requirement)))
        .collect();
    let expected: BTreeSet<_> = node
        .links
        .iter()
        .map(|link| {
            let child = graph.nodes[link.to].name.to_owned();
            (link.state, child, kind(link.kind == LinkKind::Modulation))
        })
        .collect();
    assert_eq!(links, expected, "{name}");
    operator(component, node);
}

fn operator(component: &Component, node: &Node) {
    let info: Vec<_> = component
        .info
        .iter()
        .map(|one| (&*one.function.name.text, &*one.function.docs.text, one.unit.as_deref()))
        .collect();
    assert_eq!(info, node.info.iter().map(|one| (one.name, one.doc, one.unit)).collect::<Vec<_>>(), "{}", node.name);
    let modulation = |one: &bica_vicode::model::Modulation| {
        let arguments = one.function.arguments.iter().map(|argument| argument.name.text.clone()).collect::<Vec<_>>();
        (one.function.name.text.clone(), one.function.docs.text.clone(), arguments)
    };
    let expected = |one: &bica::modulation::Modulation| {
        let arguments = one.arguments.iter().map(|argument| argument.name.to_owned()).collect::<Vec<_>>();
        (one.name.to_owned(), one.doc.to_owned(), arguments)
    };
    let modulations: Vec<_> = component.modulations.iter().map(modulation).collect();
    assert_eq!(modulations, node.modulations.iter().map(expected).collect::<Vec<_>>(), "{}", node.name);
}

#[test]
fn the_model_of_every_component_of_the_forward_is_what_its_graph_says() {
    let graph = &bica_player::Forward::GRAPH;
    let mut seen = BTreeSet::new();
    let mut groups: Vec<ParameterGroup> = Vec::new();
    for (_, text) in sources::components("player/src") {
        let model = bica_vicode::read(&text);
        assert_eq!(model.problems, []);
        for component in &model.components {
            let node =
                graph.nodes.iter().find(|node| node.name == component.name.text).expect("a component of the tree");
            agrees(component, node, graph);
            seen.insert(node.name);
        }
    }
    assert_eq!(seen, graph.nodes.iter().map(|node| node.name).collect());
    for path in sources::files(&sources::root().join("player/src")) {
        groups.extend(bica_vicode::read(&std::fs::read_to_string(path).unwrap()).parameters);
    }
    let mut compared = 0;
    for expected in graph.nodes.iter().flat_map(|node| node.params) {
        let group = groups.iter().find(|group| group.name.text == expected.name).expect(expected.name);
        assert_eq!(group.docs.text, expected.doc);
        let fields: Vec<_> = group.parameters.iter().map(|one| (&*one.name.text, &*one.docs.text)).collect();
        assert_eq!(fields, expected.params.iter().map(|one| (one.name, one.doc)).collect::<Vec<_>>());
        for (parameter, of) in group.parameters.iter().zip(expected.params) {
            let default = &parameter.value("default").expect("a default").text;
            if let (Ok(number), bica::params::Value::F32(value)) = (default.parse::<f32>(), of.default) {
                assert_eq!(number.to_bits(), value.to_bits(), "{}", of.name);
                compared += 1;
            }
        }
    }
    assert!(compared > 20, "{compared}");
}
