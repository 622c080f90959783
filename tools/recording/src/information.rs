//! Values of information in a recording.

use bica::info::{InfoSink, Information};
use bica::{ComponentId, Tree};
use postcard_schema::Schema;
use postcard_schema::schema::owned::OwnedNamedType;
use serde::{Deserialize, Serialize};

/// Size of a value in postcard's format above which it is not recorded, bytes.
const MAX_VALUE_BYTES: usize = 1024;

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

/// Takes a value as bytes.
struct Bytes<'a>(&'a mut Vec<u8>);

impl InfoSink for Bytes<'_> {
    fn take<V: Information>(&mut self, value: &V) {
        let mut buffer = [0; MAX_VALUE_BYTES];
        // A value that is larger than the buffer is left out.
        if let Ok(bytes) = postcard::to_slice(value, &mut buffer) {
            self.0.extend_from_slice(bytes);
        }
    }
}

/// Reads all information of the active components of a tree.
pub(crate) fn read<T: Tree>(tree: &T) -> InformationRecord {
    let mut values = Vec::new();
    for component in tree.active() {
        for index in 0..T::GRAPH.nodes[component.index()].info.len() {
            let mut value = Vec::new();
            if tree.read_info(component, index, &mut Bytes(&mut value)) {
                values.push(InformationValue { component: component.index() as u16, index: index as u16, value });
            }
        }
    }
    InformationRecord { values }
}

/// Takes the schema of a value.
struct SchemaOf(Option<OwnedNamedType>);

impl InfoSink for SchemaOf {
    fn take<V: Information>(&mut self, _value: &V) {
        self.0 = Some(V::SCHEMA.into());
    }
}

/// Returns the schema of an information.
pub(crate) fn schema<T: Tree>(tree: &T, component: ComponentId, index: usize) -> Option<OwnedNamedType> {
    let mut schema = SchemaOf(None);
    tree.read_info(component, index, &mut schema);
    schema.0
}
