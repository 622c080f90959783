//! The model is what the macro makes of the same text.

use std::collections::BTreeSet;

use bica::Tree;
use bica_syntax::component::model::Timer;
use bica_vicode::model::{Component, Function, HookRole, LinkKind};
use bica_wire::model::Description;
use serde_json::{Value, json};

use crate::sources;

fn list<T>(of: &[T], one: impl Fn(&T) -> Value) -> Value {
    of.iter().map(one).collect()
}

/// Converts a component to the form of [`node`].
fn model(component: &Component) -> Value {
    let number = |key| component.options.get(key).map(|one| one.value.as_ref().unwrap().text.parse::<f64>().unwrap());
    let doc = |function: &Function| function.docs.text.clone();
    let named = |function: &Function| (function.name.text.clone(), doc(function));
    let kind = |kind| if kind == LinkKind::Requirement { "requirement" } else { "modulation" };
    let links: BTreeSet<_> =
        component.links().iter().map(|one| json!([one.state, one.child, kind(one.kind)]).to_string()).collect();
    json!({
        "name": component.name.text,
        "doc": component.docs.text,
        "options": [number("hz"), number("budget_us"), component.options.get("resume").is_some()],
        "states": list(&component.states, |one| {
            let hooks = component.hooks.iter().filter(|hook| hook.role == HookRole::Before);
            let before = hooks.filter(|hook| hook.states.iter().any(|state| state.text == one.function.name.text));
            let before: Vec<_> = before.map(|hook| &hook.function.name.text).collect();
            json!([named(&one.function), one.initial, one.last, one.end, before.first()])
        }),
        "transitions": list(&component.machine().edges, |one| {
            let carries = one.condition.carries.as_ref().map(|of| &of.text);
            let doc = if one.guard.bare { String::new() } else { doc(one.condition) };
            let (timer, when) = (one.guard.timer.as_ref(), one.guard.when.as_ref().map(ToString::to_string));
            let after_ms = timer.and_then(|timer| if let Timer::Ms(ms) = timer { Some(ms) } else { None });
            let is_parameter = timer.is_some() && after_ms.is_none();
            json!([(one.name(), doc), one.from, one.to, after_ms, is_parameter, when, one.guard.times, carries])
        }),
        "links": links,
        "info": list(&component.outputs, |one| json!([named(&one.function), one.unit, one.ty.as_ref().unwrap().text])),
        "modulations": list(&component.modulations, |one| {
            json!([named(&one.function), list(&one.function.arguments, |one| json!(one.name.text))])
        }),
        "work": component.work.first().map(|one| named(&one.function)),
    })
}

/// Converts a component of a tree's description, without its parameters.
fn node(node: &Value, tree: &Value) -> Value {
    let each = |key: &str, one: &dyn Fn(&Value) -> Value| list(node[key].as_array().unwrap(), one);
    let named = |one: &Value| json!([one["name"], one["doc"]]);
    let child =
        |link: &Value| tree["components"][usize::try_from(link["to"].as_u64().unwrap()).unwrap()]["name"].clone();
    let links = node["links"].as_array().unwrap().iter();
    let links: BTreeSet<_> = links.map(|one| json!([one["state"], child(one), one["kind"]]).to_string()).collect();
    json!({
        "name": node["name"],
        "doc": node["doc"],
        "options": [node["hz"].as_f64(), node["budget_us"].as_f64(), node["resume"]],
        "states": each("states", &|one| json!([named(one), one["initial"], one["last"], one["end"], one["before"]])),
        "transitions": each("transitions", &|one| {
            let is_parameter = !one["after"].is_null();
            let after_ms = if is_parameter { Value::Null } else { one["after_ms"].clone() };
            let name = |when: &Value| child(&json!({ "to": when["child"] })).as_str().unwrap().to_owned();
            let when = one["when"].as_object().map(|_| format!("{}({})", one["when"]["end"].as_str().unwrap(), name(&one["when"])));
            json!([named(one), one["from"], one["to"], after_ms, is_parameter, when, one["times"], one["carries"]])
        }),
        "links": links,
        "info": each("info", &|one| json!([named(one), one["unit"], one["type"]])),
        "modulations": each("modulations", &|one| {
            json!([named(one), list(one["arguments"].as_array().unwrap(), |one| one["name"].clone())])
        }),
        "work": node.get("work").map(named),
    })
}

/// Compares a component with its description in a tree's description.
pub(crate) fn agrees(component: &Component, tree: &Value) {
    let mut nodes = tree["components"].as_array().unwrap().iter();
    let found = nodes.find(|node| node["name"] == component.name.text.as_str()).expect("a component of the tree");
    assert_eq!(model(component), node(found, tree));
}

#[test]
fn models_of_a_robot_are_its_graph() {
    let tree: Value = serde_json::to_value(Description::of(&crate::wall_follower::WallFollower::GRAPH)).unwrap();
    let model = bica_vicode::read(&sources::text("examples/wall_follower/robot.rs"));
    assert_eq!(model.problems, []);
    for component in &model.components {
        agrees(component, &tree);
    }
    assert_eq!(model.components.len(), tree["components"].as_array().unwrap().len());
    let mut compared = 0;
    for param in tree["components"].as_array().unwrap().iter().flat_map(|one| one["params"].as_array().unwrap()) {
        let group = model.parameters.iter().find(|group| param["group"] == group.name.text).expect("a struct");
        let field = group.parameters.iter().find(|one| param["name"] == one.name.text).expect("a field");
        assert_eq!(param["doc"], field.docs.text);
        let default: f64 = field.value("default").expect("a default").text.parse().unwrap();
        assert_eq!(Some(default.to_bits()), param["default"].as_f64().map(f64::to_bits), "{param}");
        compared += 1;
    }
    assert_eq!(compared, 4);
}
