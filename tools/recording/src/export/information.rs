//! Information as JSON.

use serde_json::json;

use crate::header::{InformationInfo, TreeInfo};
use crate::information::InformationValue;
use crate::mcap::{ChannelRecord, SchemaRecord};

/// Topic of an output.
pub(super) struct InformationTopic {
    /// Number of the channel.
    pub(super) id: u16,
    name: String,
    component: u16,
    index: u16,
    info: InformationInfo,
}

/// Returns the topics of all information whose values are recorded, numbered from `first` on.
pub(super) fn topics(tree: &TreeInfo, first: u16) -> Vec<InformationTopic> {
    let mut topics = Vec::new();
    for (component, info) in (0..).zip(&tree.components) {
        for (index, information) in (0..).zip(&info.information) {
            if information.schema.is_none() {
                continue;
            }
            let name = format!("/information/{}/{}", info.name, information.name);
            topics.push(InformationTopic {
                id: first + topics.len() as u16,
                name,
                component,
                index,
                info: information.clone(),
            });
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
        let value = self.info.decode(&value.value)?;
        Some(if value.is_object() { value.to_string() } else { json!({ "value": value }).to_string() })
    }
}
