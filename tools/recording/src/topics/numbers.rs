//! Values as JSON.

use bica_wire::model::Description;
use serde_json::{Map, Value, json};

use crate::message::Costs;

/// Returns a value as an object in JSON; one that is no object is its field `value`.
pub(super) fn object(value: Value) -> Vec<u8> {
    let object = if value.is_object() { value } else { json!({ "value": value }) };
    object.to_string().into_bytes()
}

/// Returns the time of each component, µs.
pub(super) fn costs(tree: &Description, costs: &Costs) -> Value {
    let times = tree.components.iter().zip(&costs.components);
    Value::Object(times.map(|(one, cost)| (one.name.clone(), json!(cost.ns as f64 * 1e-3))).collect::<Map<_, _>>())
}
