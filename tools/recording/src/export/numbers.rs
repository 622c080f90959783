//! Fields of sensor values and command as messages of named numbers.

use postcard_schema::schema::owned::{OwnedDataModelType, OwnedNamedType};

use super::identifier;
use super::protobuf::{Field, Kind, Protobuf, descriptor_set};
use crate::fields;
use crate::header::{Header, Messages};
use crate::mcap::{ChannelRecord, SchemaRecord};
use crate::recording::RecordedCycle;

/// Topic of a field that holds numbers only.
pub(super) struct NumbersTopic {
    /// Number of the channel.
    pub(super) id: u16,
    /// Topic, as `/sensors/angles`.
    name: String,
    is_command: bool,
    /// Path of the field in the message, as `.angles`.
    prefix: String,
    /// Paths of the numbers in the field.
    paths: Vec<String>,
}

/// Returns the topics of a robot's sensor values and command, numbered from `first` on.
pub(super) fn topics(header: &Header, first: u16) -> Vec<NumbersTopic> {
    let mut topics = Vec::new();
    let Some(Messages { sensors, command }) = &header.messages else { return topics };
    for (root, is_command, OwnedNamedType { ty, .. }) in [("/sensors", false, sensors), ("/command", true, command)] {
        let mut add = |prefix: String, ty: &OwnedDataModelType| {
            let Some(paths) = fields::numbers(ty) else { return };
            let name = prefix.strip_prefix('.').map_or_else(|| root.to_owned(), |field| format!("{root}/{field}"));
            topics.push(NumbersTopic { id: first + topics.len() as u16, name, is_command, prefix, paths });
        };
        match ty {
            OwnedDataModelType::Struct(fields) => {
                for field in fields {
                    add(format!(".{}", field.name), &field.ty.ty);
                }
            }
            ty => add(String::new(), ty),
        }
    }
    topics
}

/// Returns the messages of a cycle, each with the number of its channel.
pub(super) fn messages(header: &Header, topics: &[NumbersTopic], cycle: &RecordedCycle) -> Vec<(u16, Protobuf)> {
    let Some(Messages { sensors, command }) = &header.messages else { return Vec::new() };
    let all = |schema, bytes: &Option<Vec<u8>>| bytes.as_ref().and_then(|bytes| fields::fields(schema, bytes));
    let values = [all(sensors, &cycle.sensors), all(command, &cycle.command)];
    let message = |topic: &NumbersTopic| {
        let values = values[usize::from(topic.is_command)].as_ref()?;
        let begin = values
            .iter()
            .position(|value| value.path.strip_prefix(&*topic.prefix) == topic.paths.first().map(|path| &**path))?;
        let mut message = Protobuf::default();
        for (value, number) in values[begin..].iter().take(topic.paths.len()).zip(1..) {
            message.float(number, value.number?);
        }
        Some((topic.id, message))
    };
    topics.iter().filter_map(message).collect()
}

impl NumbersTopic {
    /// Returns schema and channel, with a number for the schema.
    pub(super) fn declare(&self, schema: u16) -> (SchemaRecord, ChannelRecord) {
        let name = format!("bica{}", self.name.replace('/', "."));
        let field = |(path, number): (&String, u32)| {
            let path = path.trim_start_matches(['.', '[']).trim_end_matches(']');
            let name = if path.is_empty() { "value".to_owned() } else { identifier(path) };
            // A name does not begin with a digit.
            let name = if name.starts_with(|first: char| first.is_ascii_digit()) { format!("_{name}") } else { name };
            Field { name, number, kind: Kind::Float }
        };
        let fields: Vec<_> = self.paths.iter().zip(1..).map(field).collect();
        let data = descriptor_set(&name, &fields);
        let record = SchemaRecord { id: schema, name, encoding: "protobuf".to_owned(), data };
        let channel = ChannelRecord { id: self.id, schema, topic: self.name.clone(), encoding: "protobuf".to_owned() };
        (record, channel)
    }
}
