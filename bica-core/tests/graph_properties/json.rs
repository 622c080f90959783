//! JSON of a graph, parsed by another implementation.

use bica_core::graph::{Graph, Link, LinkKind, Node, State, Transition};
use proptest::prelude::*;
use serde_json::{Value, json};

use crate::generate::{every_character, special_graph};

/// JSON cannot represent infinity and NaN; `f64` contains any `f32`.
fn figure(written: &Value, figure: Option<f32>) -> bool {
    match figure.filter(|figure| figure.is_finite()) {
        None => written.is_null(),
        Some(figure) => written.as_f64().is_some_and(|number| (number as f32).to_bits() == figure.to_bits()),
    }
}

fn link(link: &Link) -> Value {
    let kind = if link.kind == LinkKind::Requirement { "requirement" } else { "modulation" };
    json!({ "to": link.to, "kind": kind, "state": link.state })
}

fn state(state: &State) -> Value {
    json!({ "name": state.name, "doc": state.doc, "initial": state.initial, "last": state.last })
}

fn transition(transition: &Transition) -> Value {
    json!({ "name": transition.name, "doc": transition.doc, "from": transition.from, "to": transition.to, "after_ms": transition.after_ms })
}

fn node_is(written: &Value, node: &Node) -> bool {
    let list = |entries: Vec<Value>| Value::Array(entries);
    written.as_object().is_some_and(|fields| fields.len() == 8)
        && written["name"] == node.name
        && written["doc"] == node.doc
        && written["resume"] == node.resume
        && figure(&written["hz"], node.hz)
        && figure(&written["budget_us"], node.budget_us)
        && written["links"] == list(node.links.iter().map(link).collect())
        && written["states"] == list(node.states.iter().map(state).collect())
        && written["transitions"] == list(node.transitions.iter().map(transition).collect())
}

fn graph_is(written: &Value, graph: &Graph) -> bool {
    written.as_object().is_some_and(|fields| fields.len() == 6)
        && written["name"] == graph.name
        && written["doc"] == graph.doc
        && written["root"] == graph.root
        && figure(&written["cycle_hz"], Some(graph.cycle_hz))
        && figure(&written["budget_ms"], graph.budget_ms)
        && written["nodes"].as_array().is_some_and(|nodes| {
            nodes.len() == graph.nodes.len()
                && nodes.iter().zip(graph.nodes).all(|(written, node)| node_is(written, node))
        })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn json_contains_every_field(graph in special_graph(6), cycle_hz: f32) {
        let graph = Graph { cycle_hz, ..graph };
        let written: Value = serde_json::from_str(&graph.json().to_string()).expect("valid JSON");
        prop_assert!(graph_is(&written, &graph), "{:#}", written);
    }
}

#[test]
fn every_character_is_kept() {
    let graph = every_character();
    let written: Value = serde_json::from_str(&graph.json().to_string()).expect("valid JSON");
    assert!(graph_is(&written, &graph));
}
