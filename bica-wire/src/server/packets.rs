//! The packets of a connection, in the order of their priority.

use bica_core::graph::Node;
use bica_core::{ComponentId, Tree};
use heapless::String;
use postcard_schema::schema::NamedType;

use super::connection::{Connection, LogEntry, REFUSED, contains, set};
use super::output::{OutputBytes, schema_part};
use crate::message::{
    Attached, ComponentStates, CycleInfo, LeaseState, LogLine, LogSource, MAX_OUTPUT_BYTES, MAX_STATES, MAX_VALUES,
    Offers, OutputSchema, OutputValue, SCHEMA_PART_BYTES,
};
use crate::{Encoder, FromRobot, SCHEMA, ToMonitor, read};

/// Largest size of a message before it is packed, bytes.
const MAX_MESSAGE: usize = 1100;

/// Sources of the messages.
pub(super) struct Context<'a, T> {
    pub(super) tree: &'a T,
    /// Numbers of the next cycle, and time of the last one.
    pub(super) next: &'a CycleInfo,
    pub(super) lease: LeaseState,
    pub(super) realtime: bool,
    pub(super) silence_ms: u32,
}

impl<T: Tree> Context<'_, T> {
    /// Number of the last cycle.
    const fn cycle(&self) -> u64 {
        self.next.cycle.saturating_sub(1)
    }

    /// Encodes a message as a packet; returns its length, or `None` if it does not fit. Generic, so that it is compiled with the
    /// program, which has the same serializer for its outputs.
    #[inline(never)]
    fn encode(message: &ToMonitor<'_>, encoder: &mut Encoder, room: &mut [u8]) -> Option<usize> {
        let mut buffer = [0; MAX_MESSAGE];
        let bytes = postcard::to_slice(message, &mut buffer).ok()?;
        Self::pack(&FromRobot::Monitor(bytes), encoder, room)
    }

    fn pack(message: &FromRobot<'_>, encoder: &mut Encoder, room: &mut [u8]) -> Option<usize> {
        encoder.encode(message, room).ok().map(<[u8]>::len)
    }

    const fn attached(&self) -> Attached<'static> {
        Attached {
            schema: SCHEMA,
            tree_hash: T::HASH,
            name: T::GRAPH.name,
            realtime: self.realtime,
            silence_ms: self.silence_ms,
            offers: Offers::OPERATE,
        }
    }
}

impl Connection {
    /// Encodes the next packet; returns its length. `None` if there is none, or `room` is too small for it.
    pub(super) fn next_packet<T: Tree>(
        &mut self,
        context: &Context<'_, T>,
        encoder: &mut Encoder,
        room: &mut [u8],
    ) -> Option<usize> {
        self.heard?;
        if let Some(answer) = &self.answer {
            let length = Context::<T>::encode(&ToMonitor::Answer(answer.message()), encoder, room)?;
            self.answer = None;
            return Some(length);
        }
        if self.attached {
            let length = Context::<T>::encode(&ToMonitor::Attached(context.attached()), encoder, room)?;
            self.attached = false;
            return Some(length);
        }
        if self.lease {
            let length = Context::<T>::encode(&ToMonitor::Lease(context.lease), encoder, room)?;
            self.lease = false;
            return Some(length);
        }
        if let Some(entry) = self.log.front() {
            let length = Context::<T>::encode(
                &ToMonitor::Log(entry.message(T::GRAPH.nodes, &mut String::new())),
                encoder,
                room,
            )?;
            self.log.pop_front();
            return Some(length);
        }
        if let Some(length) = self.next_graph_item::<T>(encoder, room) {
            return Some(length);
        }
        self.next_params(context, encoder, room)
            .or_else(|| self.next_states(context, encoder, room))
            .or_else(|| self.next_output(context, encoder, room))
    }

    fn next_graph_item<T: Tree>(&mut self, encoder: &mut Encoder, room: &mut [u8]) -> Option<usize> {
        let mut rest = self.description.clone()?;
        let Some(item) = rest.next() else {
            self.description = None;
            return None;
        };
        let length = Context::<T>::pack(&FromRobot::GraphItem(item), encoder, room)?;
        self.description = Some(rest);
        Some(length)
    }

    fn next_params<T: Tree>(
        &mut self,
        context: &Context<'_, T>,
        encoder: &mut Encoder,
        room: &mut [u8],
    ) -> Option<usize> {
        while !self.params.is_empty() {
            let component = self.params.start;
            let Some(values) = read::params(context.tree, context.cycle(), component, self.first_param) else {
                (self.params.start, self.first_param) = (component + 1, 0);
                continue;
            };
            let length = Context::<T>::encode(&ToMonitor::Params(values), encoder, room)?;
            self.first_param += MAX_VALUES as u16;
            return Some(length);
        }
        None
    }

    fn next_states<T: Tree>(
        &mut self,
        context: &Context<'_, T>,
        encoder: &mut Encoder,
        room: &mut [u8],
    ) -> Option<usize> {
        let part = self.snapshot?;
        let cycle = context.cycle();
        let Some(before) = part.checked_sub(1) else {
            let length = Context::<T>::encode(&ToMonitor::Cycle(CycleInfo { cycle, ..*context.next }), encoder, room)?;
            self.snapshot = Some(1);
            return Some(length);
        };
        let first = usize::from(before) * MAX_STATES;
        let states = (first..T::COUNT.min(first + MAX_STATES)).filter_map(|index| read::state(context.tree, index));
        let message = ComponentStates { cycle, first: first as u16, states: states.collect() };
        let length = Context::<T>::encode(&ToMonitor::Components(message), encoder, room)?;
        self.snapshot = (first + MAX_STATES < T::COUNT).then_some(part + 1);
        Some(length)
    }

    fn next_output<T: Tree>(
        &mut self,
        context: &Context<'_, T>,
        encoder: &mut Encoder,
        room: &mut [u8],
    ) -> Option<usize> {
        let entry = self.next_due()?;
        let (component, output) = (self.watched[entry].component, self.watched[entry].output);
        let (id, index) = (ComponentId::new(component.into()), usize::from(output));
        let mut buffer = [0; MAX_OUTPUT_BYTES];
        let mut value = OutputBytes::new(&mut buffer);
        context.tree.read_output(id, index, &mut value);
        let Some(schema) = value.schema else {
            // The component has no such output.
            set(&mut self.due, entry, false);
            return None;
        };
        if !contains(&self.schemas, entry) {
            return self.next_schema::<T>(schema, entry, encoder, room);
        }
        let (cycle, bytes) = (context.cycle(), value.finish());
        let message = OutputValue { cycle, component: component.into(), output: output.into(), bytes };
        let length = Context::<T>::encode(&ToMonitor::Output(message), encoder, room)?;
        set(&mut self.due, entry, false);
        self.next_output = entry + 1;
        Some(length)
    }

    fn next_schema<T: Tree>(
        &mut self,
        schema: &NamedType,
        entry: usize,
        encoder: &mut Encoder,
        room: &mut [u8],
    ) -> Option<usize> {
        let (component, output) = (self.watched[entry].component, self.watched[entry].output);
        let mut part = [0; SCHEMA_PART_BYTES];
        let (length, more) = schema_part(schema, self.schema_offset, &mut part);
        let bytes = &part[..length];
        let message = OutputSchema { component: component.into(), output: output.into(), last: !more, bytes };
        let packet = Context::<T>::encode(&ToMonitor::OutputSchema(message), encoder, room)?;
        self.schema_offset = if more { self.schema_offset + length } else { 0 };
        set(&mut self.schemas, entry, !more);
        Some(packet)
    }
}

impl LogEntry {
    fn message<'a>(&self, nodes: &[Node], text: &'a mut String<96>) -> LogLine<&'a str> {
        let (refused, level) = if self.level == REFUSED { ("refused: ", 3) } else { ("", self.level) };
        let node = self.component.and_then(|component| nodes.get(component.index()));
        let (space, name) = node.map_or(("", ""), |node| (" ", node.name));
        // Parts that do not fit are omitted.
        let _ = [refused, self.text, space, name].iter().try_for_each(|part| text.push_str(part));
        LogLine { time_us: self.time_us, level, source: LogSource::Operator, text }
    }
}
