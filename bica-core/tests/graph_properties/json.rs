//! JSON of a graph, parsed by another implementation.

use bica_core::graph::{Graph, Link, LinkKind, Node, State, Transition, hash};
use bica_core::info::Info;
use bica_core::modulation::Modulation;
use bica_core::params::{self, Kind, Param, ParamGroup};
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

fn list_is<T>(written: &Value, entries: &[T], is: impl Fn(&Value, &T) -> bool) -> bool {
    written.as_array().is_some_and(|written| {
        written.len() == entries.len() && written.iter().zip(entries).all(|(written, entry)| is(written, entry))
    })
}

fn group_is(written: &Value, group: &ParamGroup) -> bool {
    written.as_object().is_some_and(|fields| fields.len() == 3)
        && written["name"] == group.name
        && written["doc"] == group.doc
        && list_is(&written["params"], group.params, param_is)
}

fn info_is(written: &Value, info: &Info) -> bool {
    *written
        == json!({ "name": info.name, "doc": info.doc.text(), "unit": info.unit, "type": info.ty,
        "shape": info.placement.map(|one| one.shape), "frame": info.placement.map(|one| one.frame), "child": info.placement.and_then(|one| one.child) })
}

fn modulation_is(written: &Value, modulation: &Modulation) -> bool {
    written.as_object().is_some_and(|fields| fields.len() == 3)
        && written["name"] == modulation.name
        && written["doc"] == modulation.doc
        && list_is(&written["arguments"], modulation.arguments, param_is)
}

fn param_is(written: &Value, param: &Param) -> bool {
    let (min, max, step, default) = (&written["min"], &written["max"], &written["step"], &written["default"]);
    let (count, same) = match (param.kind, param.default) {
        (Kind::F32 { min: low, max: high, step: by }, params::Value::F32(value)) => {
            (8, figure(min, Some(low)) && figure(max, Some(high)) && figure(step, by) && figure(default, Some(value)))
        }
        (Kind::I32 { min: low, max: high, step: by }, params::Value::I32(value)) => {
            (8, *min == low && *max == high && *step == json!(by) && *default == value)
        }
        (Kind::U32 { min: low, max: high, step: by }, params::Value::U32(value)) => {
            (8, *min == low && *max == high && *step == json!(by) && *default == value)
        }
        (Kind::Bool, params::Value::Bool(value)) => (5, *default == value),
        (Kind::Choice { variants }, params::Value::Choice(index)) => {
            let all: Vec<_> = variants.iter().map(|one| json!({ "name": one.name, "doc": one.doc })).collect();
            let name = variants.get(index as usize).map(|one| one.name);
            (6, written["variants"] == json!(all) && *default == json!(name))
        }
        _ => return false,
    };
    written.as_object().is_some_and(|fields| fields.len() == count)
        && same
        && written["name"] == param.name
        && written["doc"] == param.doc.text()
        && written["unit"] == json!(param.unit)
        && written["kind"] == param.kind.name()
}

fn node_is(written: &Value, node: &Node) -> bool {
    let list = |entries: Vec<Value>| Value::Array(entries);
    written.as_object().is_some_and(|fields| fields.len() == 11)
        && list_is(&written["info"], node.info, info_is)
        && list_is(&written["modulations"], node.modulations, modulation_is)
        && list_is(&written["params"], node.params, group_is)
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
    written.as_object().is_some_and(|fields| fields.len() == 8)
        && written["tunable"] == graph.tunable
        && written["hash"] == format!("{:016x}", hash(graph))
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
