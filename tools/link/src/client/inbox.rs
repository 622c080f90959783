//! State of a client, from the messages that it received.

use std::time::{Duration, Instant};

use bica_wire::message::{
    Answer, AnswerResult, ComponentStates, GraphItem, LeaseState, LogLine, Offers, OutputSchema, OutputValue,
    ParamValues, WorldState,
};
use bica_wire::model::{Builder, Description, Messages};
use bica_wire::{FromRobot, ToMonitor, ToMonitorExtra};
use postcard_schema::schema::owned::OwnedNamedType;

use super::event::{Answered, Event, Snapshot};
use super::events::Events;
use super::extras::Extras;
use crate::error::Error;

/// Largest size of a schema, bytes.
const MAX_SCHEMA: usize = 1 << 14;

/// The program to which the client is attached.
pub(super) struct Attachment {
    pub(super) schema: u64,
    tree_hash: u64,
    pub(super) realtime: bool,
    pub(super) offers: Offers,
}

/// Index of [`ToMonitor::Attached`]. Its first field is the schema, in every version of the protocol.
const ATTACHED: u8 = 0;

pub(super) struct Inbox {
    pub(super) attached: Option<Attachment>,
    pub(super) description: Description,
    builder: Option<Builder>,
    pub(super) lease: Option<LeaseState>,
    pub(super) events: Events,
    pub(super) closing: Option<String>,
    /// Robot's time, and the instant at which it was received.
    time: Option<(Duration, Instant)>,
    partial: Option<Snapshot>,
    /// Owner of the schema that is being received, and the parts so far.
    schema_parts: ((u16, u16), Vec<u8>),
    /// The output whose schema was received last.
    last_schema: Option<(usize, usize)>,
    messages: [Option<OwnedNamedType>; 2],
    extras: Extras,
    world: WorldState,
}

impl Inbox {
    pub(super) fn new() -> Self {
        Self {
            attached: None,
            description: Description::default(),
            builder: Some(Builder::default()),
            lease: None,
            events: Events::default(),
            closing: None,
            time: None,
            partial: None,
            schema_parts: Default::default(),
            last_schema: None,
            messages: [None, None],
            extras: Extras::default(),
            world: WorldState::default(),
        }
    }

    /// Returns whether the description is complete.
    pub(super) const fn is_described(&self) -> bool {
        self.builder.is_none()
    }

    /// Returns whether a value of each parameter was received.
    pub(super) fn has_values(&self) -> bool {
        self.description.components.iter().flat_map(|component| &component.params).all(|param| param.value.is_some())
    }

    /// Returns whether the schemas of all outputs were received, which a program on a computer sends.
    pub(super) fn has_schemas(&self) -> bool {
        let is_computer = self.attached.as_ref().is_some_and(|attached| attached.offers.contains(Offers::CONDITIONS));
        let outputs = self.description.components.iter().map(|component| component.outputs.len()).enumerate();
        let last = outputs.rev().find(|(_, count)| *count > 0).map(|(component, count)| (component, count - 1));
        !is_computer || last.is_none() || last == self.last_schema
    }

    /// Estimates the robot's time; none if it does not advance with the clock, or is unknown.
    pub(super) fn robot_time(&self) -> Option<Duration> {
        let realtime = self.attached.as_ref().is_some_and(|attached| attached.realtime);
        let elapsed = |received: Instant| if self.world.paused { Duration::ZERO } else { received.elapsed() };
        self.time.filter(|_| realtime).map(|(time, received)| time + elapsed(received))
    }

    /// Processes a message.
    pub(super) fn receive(&mut self, message: FromRobot<'_>) -> Result<(), Error> {
        match message {
            FromRobot::GraphItem(item) => self.describe(&item)?,
            FromRobot::Monitor(bytes) => match postcard::from_bytes(bytes) {
                Ok(message) => self.add(message),
                Err(_) => self.check_version(bytes)?,
            },
            FromRobot::MonitorExtra(bytes) => {
                let event = match postcard::from_bytes(bytes) {
                    Ok(ToMonitorExtra::MessageSchema { command, last, bytes }) => {
                        let schema = self.schema((u16::MAX, command.into()), last, bytes);
                        self.messages[usize::from(command)] = schema;
                        None
                    }
                    Ok(message) => self.extras.add(message, &self.description),
                    Err(_) => None,
                };
                if let Some(Event::World(world)) = event {
                    self.set_world(world);
                }
                if let Some(event) = event {
                    self.events.push(event);
                }
            }
            FromRobot::Identity(_) | FromRobot::Command(_) | FromRobot::Telemetry(_) | FromRobot::StackUsage(_) => {}
        }
        Ok(())
    }

    /// Checks whether a message that cannot be decoded is the answer of a robot of another version to `Attach`.
    fn check_version(&self, bytes: &[u8]) -> Result<(), Error> {
        match postcard::take_from_bytes::<(u8, u64)>(bytes) {
            Ok(((ATTACHED, robot), _)) if self.attached.is_none() => Err(Error::Schema { robot }),
            _ => Ok(()),
        }
    }

    /// Sets the pause state. The estimated time of a paused world stands still, and continues from there.
    fn set_world(&mut self, world: WorldState) {
        if let Some((_, received)) = self.time.as_mut().filter(|_| self.world.paused && !world.paused) {
            *received = Instant::now();
        }
        self.world = world;
    }

    fn add(&mut self, message: ToMonitor<'_>) {
        match message {
            ToMonitor::Attached(attached) => {
                let (schema, tree_hash, realtime) = (attached.schema, attached.tree_hash, attached.realtime);
                self.attached = Some(Attachment { schema, tree_hash, realtime, offers: attached.offers });
            }
            ToMonitor::Cycle(info) => {
                self.set_time(info.time_us);
                self.partial = Some(Snapshot { info, states: Vec::new() });
            }
            ToMonitor::Components(states) => self.states(&states),
            ToMonitor::Output(value) => self.output(&value),
            ToMonitor::OutputSchema(part) => self.output_schema(&part),
            ToMonitor::Params(values) => self.params(&values),
            ToMonitor::Lease(lease) => {
                self.set_time(lease.time_us);
                self.lease = Some(lease);
                self.events.push(Event::Lease(lease));
            }
            ToMonitor::Answer(answer) => self.events.push(Event::Answer(answered(answer))),
            ToMonitor::Log(LogLine { time_us, level, source, text }) => {
                self.events.push(Event::Log(LogLine { time_us, level, source, text: text.to_owned() }));
            }
            ToMonitor::Closing { reason } => self.closing = Some(reason.to_owned()),
        }
    }

    fn set_time(&mut self, time_us: u64) {
        self.time = Some((Duration::from_micros(time_us), Instant::now()));
    }

    fn describe(&mut self, item: &GraphItem<'_>) -> Result<(), Error> {
        let Some(builder) = &mut self.builder else { return Ok(()) };
        if let Some(mut description) = builder.add(item).map_err(Error::Invalid)? {
            description.hash = self.attached.as_ref().map_or_else(String::new, |at| format!("{:016x}", at.tree_hash));
            if let [Some(sensors), Some(command)] = std::mem::take(&mut self.messages) {
                description.messages = Some(Messages { sensors, command });
            }
            (self.description, self.builder) = (description, None);
        }
        Ok(())
    }

    fn states(&mut self, part: &ComponentStates) {
        let Some(snapshot) = &mut self.partial else { return };
        if snapshot.info.cycle != part.cycle || snapshot.states.len() != usize::from(part.first) {
            self.partial = None;
            return;
        }
        snapshot.states.extend_from_slice(&part.states);
        if snapshot.states.len() >= self.description.components.len()
            && let Some(snapshot) = self.partial.take()
        {
            self.events.push(Event::Snapshot(snapshot));
        }
    }

    fn output(&mut self, value: &OutputValue<'_>) {
        let (component, output) = (usize::from(value.component), usize::from(value.output));
        self.events.push(Event::Output { cycle: value.cycle, component, output, value: value.bytes.map(Into::into) });
    }

    fn output_schema(&mut self, &OutputSchema { component, output, last, bytes }: &OutputSchema<'_>) {
        let schema = self.schema((component, output), last, bytes);
        let place = (usize::from(component), usize::from(output));
        let output = self.description.components.get_mut(place.0).and_then(|one| one.outputs.get_mut(place.1));
        if last && let Some(output) = output {
            self.last_schema = Some(place);
            output.schema = schema;
        }
    }

    /// Adds a part of a schema; returns it after the last part.
    fn schema(&mut self, of: (u16, u16), last: bool, bytes: &[u8]) -> Option<OwnedNamedType> {
        let (previous, parts) = &mut self.schema_parts;
        if std::mem::replace(previous, of) != of {
            parts.clear();
        }
        if parts.len() + bytes.len() <= MAX_SCHEMA {
            parts.extend_from_slice(bytes);
        }
        last.then(|| postcard::from_bytes(&std::mem::take(parts)).ok()).flatten()
    }

    fn params(&mut self, values: &ParamValues) {
        let component = usize::from(values.component);
        let Some(described) = self.description.components.get_mut(component) else { return };
        for (param, value) in described.params.iter_mut().skip(values.first.into()).zip(&values.values) {
            param.value = *value;
        }
        self.events.push(Event::Params { component });
    }
}

fn answered(answer: Answer<'_>) -> Answered {
    let Answer { number, cycle, arrived, result } = answer;
    let (values, refused) = match result {
        AnswerResult::Done { values } => (values.iter().copied().collect(), None),
        AnswerResult::Refused { code, entry, text } => {
            let text = if text.is_empty() { code.text() } else { text };
            (Vec::new(), Some((code, entry.into(), text.to_owned())))
        }
    };
    Answered { number, cycle, arrived, values, refused }
}
