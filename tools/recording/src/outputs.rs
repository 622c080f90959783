//! Values of outputs in a recording.

use bica::output::{OutputSink, OutputType};
use bica::{ComponentId, Tree};
use bica_link::decode_output;
use postcard_schema::Schema;
use serde::{Deserialize, Serialize};

use crate::encode::encode;
use crate::header::Header;

/// Size of a value in postcard's format above which it is not recorded, bytes.
const MAX_VALUE_BYTES: usize = 1024;

/// Values of outputs after a cycle.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct OutputsRecord {
    /// The values, of active components.
    pub values: Vec<OutputRecord>,
}

/// A value of an output.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct OutputRecord {
    /// Index of the component.
    pub component: u16,
    /// Index of the output in the component.
    pub index: u16,
    /// The value in postcard's format, with the schema in the description; empty if it is too large.
    pub value: Vec<u8>,
}

impl Header {
    /// Returns a recorded value as JSON; none if it was too large to be recorded, or if the bytes do not have its schema.
    #[must_use]
    pub fn decode(&self, value: &OutputRecord) -> Option<serde_json::Value> {
        let OutputRecord { component, index, ref value } = *value;
        if value.is_empty() {
            return None;
        }
        decode_output(&self.tree, component.into(), index.into(), value)
    }
}

/// Appends a value in postcard's format, after its length.
struct Append<'a>(&'a mut Vec<u8>);

impl OutputSink for Append<'_> {
    fn take<V: OutputType>(&mut self, value: &V) {
        let mut buffer = [0; MAX_VALUE_BYTES];
        let bytes: &[u8] = postcard::to_slice(value, &mut buffer).map_or(&[], |bytes| bytes);
        encode(self.0, &bytes);
    }
}

/// Reads all outputs of the active components of a tree, and appends them as an [`OutputsRecord`] in postcard's format: the
/// loop needs no memory except that of the message.
pub(crate) fn append<T: Tree>(tree: &T, out: &mut Vec<u8>) {
    let count = |component: ComponentId| T::GRAPH.nodes[component.index()].outputs.len();
    encode(out, &tree.active().map(count).sum::<usize>());
    for component in tree.active() {
        for index in 0..count(component) {
            encode(out, &(component.index() as u16, index as u16));
            tree.read_output(component, index, &mut Append(out));
        }
    }
}
