//! Values of information in a recording.

use bica::info::{InfoSink, Information};
use bica::{ComponentId, Tree};
use bica_link::decode_info;
use postcard_schema::Schema;
use postcard_schema::schema::owned::{OwnedDataModelType, OwnedNamedType};
use serde::{Deserialize, Serialize};

use crate::header::Header;
use crate::writer::encode;

/// Size of a value in postcard's format above which it is not recorded, bytes.
const MAX_VALUE_BYTES: usize = 1024;

/// Name of the schema of values that a monitor has received: JSON in a string.
const JSON: &str = "bica.Json";

/// Values of information after a cycle.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct InformationRecord {
    /// The values, of active components.
    pub values: Vec<InformationValue>,
}

/// A value of information.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct InformationValue {
    /// Index of the component.
    pub component: u16,
    /// Index of the information in the component.
    pub index: u16,
    /// The value in postcard's format, with the schema in the header; empty if it is too large.
    pub value: Vec<u8>,
}

impl InformationValue {
    /// A value as JSON text, with the schema of a recording that a monitor made.
    #[must_use]
    pub fn in_json(component: usize, index: usize, text: &str) -> Self {
        let mut value = Vec::with_capacity(text.len() + 2);
        encode(&mut value, &text);
        Self { component: component as u16, index: index as u16, value }
    }
}

/// The schema of an output whose values are recorded as JSON text.
pub(crate) fn json_schema() -> OwnedNamedType {
    OwnedNamedType { name: JSON.to_owned(), ty: OwnedDataModelType::String }
}

/// Returns a recorded value as JSON; none for one that was too large to be recorded, and for bytes without this schema.
pub(crate) fn decode(schema: &OwnedNamedType, value: &[u8]) -> Option<serde_json::Value> {
    if value.is_empty() {
        return None;
    }
    match decode_info(schema, value)? {
        serde_json::Value::String(text) if schema.name == JSON => serde_json::from_str(&text).ok(),
        decoded => Some(decoded),
    }
}

impl Header {
    /// Returns a recorded value as JSON; none for one that was too large to be recorded, and for bytes that have not its schema.
    #[must_use]
    pub fn decode(&self, value: &InformationValue) -> Option<serde_json::Value> {
        decode(self.schema(value.component.into(), value.index.into())?, &value.value)
    }
}

/// Appends a value in postcard's format, after its length.
struct Append<'a>(&'a mut Vec<u8>);

impl InfoSink for Append<'_> {
    fn take<V: Information>(&mut self, value: &V) {
        let mut buffer = [0; MAX_VALUE_BYTES];
        let bytes: &[u8] = postcard::to_slice(value, &mut buffer).map_or(&[], |bytes| bytes);
        encode(self.0, &bytes);
    }
}

/// Reads all information of the active components of a tree, and appends it as an [`InformationRecord`] in postcard's format:
/// the loop pays for no other memory than that of the message.
pub(crate) fn append<T: Tree>(tree: &T, out: &mut Vec<u8>) {
    let count = |component: ComponentId| T::GRAPH.nodes[component.index()].info.len();
    encode(out, &tree.active().map(count).sum::<usize>());
    for component in tree.active() {
        for index in 0..count(component) {
            encode(out, &(component.index() as u16, index as u16));
            tree.read_info(component, index, &mut Append(out));
        }
    }
}

/// Takes the schema of a value.
struct SchemaOf(Option<OwnedNamedType>);

impl InfoSink for SchemaOf {
    fn take<V: Information>(&mut self, _value: &V) {
        self.0 = Some(V::SCHEMA.into());
    }
}

/// Returns the schema of an output.
pub(crate) fn schema<T: Tree>(tree: &T, component: ComponentId, index: usize) -> Option<OwnedNamedType> {
    let mut schema = SchemaOf(None);
    tree.read_info(component, index, &mut schema);
    schema.0
}
