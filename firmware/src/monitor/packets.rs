//! The packets of a connection, in the order of their priority.

use bica::{ComponentId, Tree};
use bica_wire::message::{
    Answer, AnswerResult, Attached, ComponentStates, CycleInfo, InfoSchema, InfoValue, LeaseState, LogLine, LogSource,
    MAX_INFO_BYTES, MAX_STATES, MAX_VALUES, Offers, SCHEMA_PART_BYTES,
};
use bica_wire::server::read;
use bica_wire::{Encoder, FromRobot, SCHEMA, ToMonitor};
use heapless::String;
use postcard_schema::schema::NamedType;

use super::connection::{Connection, LogEntry, Outcome, contains, set};
use super::info::{OutputBytes, schema_part};
use crate::tree::{Forward, GRAPH};

/// Largest size of a message before it is packed, bytes.
const MAX_MESSAGE: usize = 1100;

/// Sources of the messages.
pub(super) struct Context<'a> {
    pub(super) tree: &'a Forward,
    /// Numbers of the next cycle, and time of the last one.
    pub(super) next: &'a CycleInfo,
    pub(super) lease: LeaseState,
    pub(super) realtime: bool,
    pub(super) silence_ms: u32,
}

impl Context<'_> {
    /// Number of the last cycle.
    const fn cycle(&self) -> u64 {
        self.next.cycle.saturating_sub(1)
    }
}

impl Connection {
    /// Encodes the next packet; returns its length. `None` if there is none, or `room` is too small for it.
    pub(super) fn next_packet(
        &mut self,
        context: &Context<'_>,
        encoder: &mut Encoder,
        room: &mut [u8],
    ) -> Option<usize> {
        self.heard?;
        if let Some(answer) = &self.answer {
            let length = encode(&ToMonitor::Answer(answer.message()), encoder, room)?;
            self.answer = None;
            return Some(length);
        }
        if self.attached {
            let length = encode(&ToMonitor::Attached(context.attached()), encoder, room)?;
            self.attached = false;
            return Some(length);
        }
        if self.lease {
            let length = encode(&ToMonitor::Lease(context.lease), encoder, room)?;
            self.lease = false;
            return Some(length);
        }
        if let Some(entry) = self.log.front() {
            let length = encode(&ToMonitor::Log(entry.message(&mut String::new())), encoder, room)?;
            self.log.pop_front();
            return Some(length);
        }
        if let Some(length) = self.next_graph_item(encoder, room) {
            return Some(length);
        }
        self.next_params(context, encoder, room)
            .or_else(|| self.next_states(context, encoder, room))
            .or_else(|| self.next_info(context, encoder, room))
    }

    fn next_graph_item(&mut self, encoder: &mut Encoder, room: &mut [u8]) -> Option<usize> {
        let mut rest = self.description.clone()?;
        let Some(item) = rest.next() else {
            self.description = None;
            return None;
        };
        let packet = encoder.encode(&FromRobot::GraphItem(item), room).ok()?;
        self.description = Some(rest);
        Some(packet.len())
    }

    fn next_params(&mut self, context: &Context<'_>, encoder: &mut Encoder, room: &mut [u8]) -> Option<usize> {
        while self.params != 0 {
            let component = self.params.trailing_zeros() as u16;
            let Some(values) = read::params(context.tree, context.cycle(), component, self.first_param) else {
                (self.params, self.first_param) = (self.params & (self.params - 1), 0);
                continue;
            };
            let length = encode(&ToMonitor::Params(values), encoder, room)?;
            self.first_param += MAX_VALUES as u16;
            return Some(length);
        }
        None
    }

    fn next_states(&mut self, context: &Context<'_>, encoder: &mut Encoder, room: &mut [u8]) -> Option<usize> {
        let part = self.snapshot?;
        let cycle = context.cycle();
        let Some(before) = part.checked_sub(1) else {
            let length = encode(&ToMonitor::Cycle(CycleInfo { cycle, ..*context.next }), encoder, room)?;
            self.snapshot = Some(1);
            return Some(length);
        };
        let first = usize::from(before) * MAX_STATES;
        let states =
            (first..Forward::COUNT.min(first + MAX_STATES)).filter_map(|index| read::state(context.tree, index));
        let message = ComponentStates { cycle, first: first as u16, states: states.collect() };
        let length = encode(&ToMonitor::Components(message), encoder, room)?;
        self.snapshot = (first + MAX_STATES < Forward::COUNT).then_some(part + 1);
        Some(length)
    }

    fn next_info(&mut self, context: &Context<'_>, encoder: &mut Encoder, room: &mut [u8]) -> Option<usize> {
        let entry = self.next_due()?;
        let (component, info) = (self.watched[entry].component, self.watched[entry].info);
        let (id, index) = (ComponentId::new(component.into()), usize::from(info));
        let mut buffer = [0; MAX_INFO_BYTES];
        let mut value = OutputBytes::new(&mut buffer);
        context.tree.read_info(id, index, &mut value);
        let Some(schema) = value.schema else {
            // The component has no such output.
            set(&mut self.due, entry, false);
            return None;
        };
        if !contains(&self.schemas, entry) {
            return self.next_schema(schema, entry, encoder, room);
        }
        let (cycle, bytes) = (context.cycle(), value.finish());
        let message = InfoValue { cycle, component: component.into(), info: info.into(), bytes };
        let length = encode(&ToMonitor::Info(message), encoder, room)?;
        set(&mut self.due, entry, false);
        self.next_info = entry + 1;
        Some(length)
    }

    fn next_schema(
        &mut self,
        schema: &NamedType,
        entry: usize,
        encoder: &mut Encoder,
        room: &mut [u8],
    ) -> Option<usize> {
        let (component, info) = (self.watched[entry].component, self.watched[entry].info);
        let mut part = [0; SCHEMA_PART_BYTES];
        let (length, more) = schema_part(schema, self.schema_offset, &mut part);
        let bytes = &part[..length];
        let message = InfoSchema { component: component.into(), info: info.into(), last: !more, bytes };
        let packet = encode(&ToMonitor::InfoSchema(message), encoder, room)?;
        self.schema_offset = if more { self.schema_offset + length } else { 0 };
        set(&mut self.schemas, entry, !more);
        Some(packet)
    }
}

impl Context<'_> {
    const fn attached(&self) -> Attached<'static> {
        Attached {
            schema: SCHEMA,
            tree_hash: Forward::HASH,
            name: GRAPH.name,
            realtime: self.realtime,
            silence_ms: self.silence_ms,
            offers: Offers::OPERATE,
        }
    }
}

impl LogEntry {
    fn message<'a>(&self, text: &'a mut String<96>) -> LogLine<'a> {
        let _ = text.push_str(self.text);
        if let Some(node) = self.component.and_then(|component| GRAPH.nodes.get(usize::from(component))) {
            let _ = text.push_str(" ").and_then(|()| text.push_str(node.name));
        }
        LogLine { time_us: self.time_us, level: self.level, source: LogSource::Operator, text }
    }
}

impl super::connection::PendingAnswer {
    fn message(&self) -> Answer<'_> {
        let result = match &self.outcome {
            Outcome::Done(values) => AnswerResult::Done { values: values.clone() },
            Outcome::Refused { code, entry, text } => AnswerResult::Refused { code: *code, entry: *entry, text },
        };
        Answer { number: self.number, cycle: self.cycle, arrived: self.cycle, result }
    }
}

/// Encodes a message as a packet; returns its length, or `None` if it does not fit.
#[inline(never)]
fn encode(message: &ToMonitor<'_>, encoder: &mut Encoder, room: &mut [u8]) -> Option<usize> {
    let mut buffer = [0; MAX_MESSAGE];
    let bytes = postcard::to_slice(message, &mut buffer).ok()?;
    encoder.encode(&FromRobot::Monitor(bytes), room).ok().map(<[u8]>::len)
}
