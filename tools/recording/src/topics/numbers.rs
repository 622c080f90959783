//! Values as JSON.

use bica_wire::model::Description;
use postcard_schema::schema::owned::OwnedNamedType;
use serde_json::{Map, Value, json};

use crate::fields::fields;
use crate::message::Costs;

/// Returns a value as an object in JSON; one that is no object is its field `value`.
pub(super) fn object(value: Value) -> Vec<u8> {
    let object = if value.is_object() { value } else { json!({ "value": value }) };
    object.to_string().into_bytes()
}

/// Returns a message that was encoded without its large data; `None` if the bytes do not have this schema.
pub(super) fn message(schema: &OwnedNamedType, bytes: &[u8]) -> Option<Value> {
    let mut message = Value::Null;
    for field in fields(schema, bytes)? {
        let leaf = field.number.map_or(json!(field.text), |number| json!(number));
        *place(&mut message, &field.path) = leaf;
    }
    Some(message)
}

/// Returns the place of a path, such as `.inertial.gyro.x` or `.ranges[3]`, and makes it if it is missing.
fn place<'a>(mut value: &'a mut Value, path: &str) -> &'a mut Value {
    for part in path.split(['.', '[']).filter(|part| !part.is_empty()) {
        if !(value.is_object() || value.is_array()) {
            *value = if part.ends_with(']') { json!([]) } else { json!({}) };
        }
        value = match value {
            // The elements come in their order.
            Value::Array(values) => {
                let index = part.trim_end_matches(']').parse().unwrap_or(values.len());
                if index >= values.len() {
                    values.push(Value::Null);
                }
                let last = values.len() - 1;
                &mut values[index.min(last)]
            }
            value => &mut value[part],
        };
    }
    value
}

/// Returns the time of each component, µs.
pub(super) fn costs(tree: &Description, costs: &Costs) -> Value {
    let times = tree.components.iter().zip(&costs.components);
    Value::Object(times.map(|(one, cost)| (one.name.clone(), json!(cost.ns as f64 * 1e-3))).collect::<Map<_, _>>())
}
