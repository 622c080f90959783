//! Information as JSON.

use serde_json::json;

use postcard_schema::schema::owned::OwnedNamedType;

use crate::header::Header;
use crate::information::{InformationValue, decode};
use crate::mcap::{ChannelRecord, SchemaRecord};

/// Topic of an output.
pub(super) struct InformationTopic {
    /// Number of the channel.
    pub(super) id: u16,
    name: String,
    component: u16,
    index: u16,
    schema: OwnedNamedType,
}

/// Returns the topics of all information whose values are recorded, numbered from `first` on.
pub(super) fn topics(header: &Header, first: u16) -> Vec<InformationTopic> {
    let mut topics = Vec::new();
    for (component, owner) in header.tree.components.iter().enumerate() {
        for (index, info) in owner.info.iter().enumerate() {
            let Some(schema) = header.schema(component, index).cloned() else { continue };
            let (id, name) = (first + topics.len() as u16, format!("/information/{}/{}", owner.name, info.name));
            topics.push(InformationTopic { id, name, component: component as u16, index: index as u16, schema });
        }
    }
    topics
}

/// The schema of all topics: any object. Its number is not set.
pub(super) fn schema() -> SchemaRecord {
    let data = json!({ "type": "object", "additionalProperties": true }).to_string().into_bytes();
    SchemaRecord { id: 0, name: "bica.Information".to_owned(), encoding: "jsonschema".to_owned(), data }
}

impl InformationTopic {
    pub(super) fn channel(&self, schema: u16) -> ChannelRecord {
        ChannelRecord { id: self.id, schema, topic: self.name.clone(), encoding: "json".to_owned() }
    }

    pub(super) fn is_of(&self, value: &InformationValue) -> bool {
        (self.component, self.index) == (value.component, value.index)
    }

    /// Returns a value as a JSON object; one that is no object is its field `value`. None for a value that was too large to be
    /// recorded.
    pub(super) fn json(&self, value: &InformationValue) -> Option<String> {
        let value = decode(&self.schema, &value.value)?;
        Some(if value.is_object() { value.to_string() } else { json!({ "value": value }).to_string() })
    }
}
