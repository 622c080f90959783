//! Messages that wait for a monitor.

use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};

use bica::Graph;
use bica::action::Action;
use bica_wire::message::{
    Answer, AnswerResult, Attached, InfoSchema, LeaseState, LogLine, LogSource, MAX_TEXT_BYTES, ParamValues, Reached,
    RefusalCode, SCHEMA_PART_BYTES, Taken, Value, WorldState,
};
use bica_wire::{FromRobot, ToMonitor, ToMonitorExtra, TooLarge, describe, truncate};
use postcard_schema::schema::NamedType;

use super::encoded::{Encoded, EncodedPart, Watched};
use super::key::Key;
use super::picture::Picture;
use super::scene::Sent;
use crate::frame::Packets;
use crate::pending::Pending;

/// Message of the lossless queue.
#[derive(Clone, Debug)]
pub(super) enum Message {
    Attached(Attached<'static>),
    Describe(&'static Graph, &'static [Action], MessageSchemas),
    Schemas(Arc<[OutputSchema]>),
    Lease(LeaseState),
    Params(Vec<ParamValues>),
    Answer { number: u32, cycle: u64, arrived: u64, result: AnswerKind },
    Log { time_us: u64, level: u8, source: LogSource, text: Arc<str> },
    World(WorldState),
    Taken(Taken),
    Reached(Reached),
    Scene(Sent),
    Result(Arc<str>),
    Closing(&'static str),
}

/// Schemas of sensor values and command.
pub(super) type MessageSchemas = [&'static NamedType; 2];

/// Schema of an output.
#[derive(Clone, Copy, Debug)]
pub(super) struct OutputSchema {
    pub(super) component: u16,
    pub(super) info: u16,
    pub(super) schema: &'static NamedType,
}

/// Result of a request.
#[derive(Clone, Debug)]
pub(super) enum AnswerKind {
    Done(Vec<Value>),
    Refused { code: RefusalCode, entry: u16, text: String },
}

/// The two queues of a monitor, and the place for an image.
#[derive(Debug, Default)]
pub(super) struct Outbox {
    queues: Mutex<Queues>,
    filled: Condvar,
}

/// What the writer sends next.
pub(super) struct Batch {
    pub(super) waiting: Pending<Message, Key, EncodedPart>,
    pub(super) image: Option<Picture>,
}

#[derive(Debug, Default)]
struct Queues {
    waiting: Pending<Message, Key, EncodedPart>,
    /// The newest image that was not begun.
    image: Option<Picture>,
    /// Whether the writer waits; waking it costs a call of the operating system.
    sleeps: bool,
    closed: bool,
}

impl Outbox {
    /// Adds a message to the lossless queue; returns whether there was room.
    pub(super) fn push(&self, message: Message) -> bool {
        let mut queues = self.lock();
        // Each is small: their number is bounded.
        let room = queues.waiting.push(message, 0);
        self.wake(queues);
        room
    }

    /// Adds data of a cycle, which replaces what was not sent.
    pub(super) fn show(&self, data: &Arc<Encoded>, snapshot: bool, watched: &Watched) {
        let mut queues = self.lock();
        for part in Encoded::parts(data, snapshot, watched) {
            queues.waiting.show(part.key(), part, |newer, _| newer);
        }
        self.wake(queues);
    }

    /// Sets the image that is sent next; one that was not begun is replaced.
    pub(super) fn show_image(&self, picture: Picture) {
        let mut queues = self.lock();
        queues.image = Some(picture);
        self.wake(queues);
    }

    /// Waits for messages and takes all; `None` after [`close`](Self::close). It does not wait, and leaves the next image, while
    /// `is_sending` an image.
    pub(super) fn take(&self, is_sending: bool) -> Option<Batch> {
        let mut queues = self.lock();
        let is_idle = |queues: &Queues| queues.waiting.is_empty() && queues.image.is_none();
        while !is_sending && is_idle(&queues) && !queues.closed {
            queues.sleeps = true;
            queues = self.filled.wait(queues).unwrap_or_else(PoisonError::into_inner);
        }
        queues.sleeps = false;
        let queues = &mut *queues;
        (!queues.closed).then(|| Batch {
            waiting: std::mem::take(&mut queues.waiting),
            image: if is_sending { None } else { queues.image.take() },
        })
    }

    /// Ends the thread that takes messages.
    pub(super) fn close(&self) {
        let mut queues = self.lock();
        queues.closed = true;
        self.wake(queues);
    }

    fn wake(&self, mut queues: MutexGuard<'_, Queues>) {
        let sleeps = std::mem::take(&mut queues.sleeps);
        drop(queues);
        if sleeps {
            self.filled.notify_one();
        }
    }

    fn lock(&self) -> MutexGuard<'_, Queues> {
        self.queues.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Message {
    /// Appends the packets of this message.
    pub(super) fn encode(&self, packets: &mut Packets) -> Result<(), TooLarge> {
        match self {
            Self::Attached(attached) => packets.push(&ToMonitor::Attached(*attached)),
            Self::Describe(graph, actions, schemas) => {
                for (command, schema) in [false, true].into_iter().zip(schemas) {
                    in_parts(schema, |last, bytes| {
                        packets.push_extra(&ToMonitorExtra::MessageSchema { command, last, bytes })
                    })?;
                }
                let mut items = describe(graph).with_actions(actions);
                items.try_for_each(|item| packets.push_robot(&FromRobot::GraphItem(item)))
            }
            Self::Schemas(outputs) => outputs.iter().try_for_each(|&OutputSchema { component, info, schema }| {
                in_parts(schema, |last, bytes| {
                    packets.push(&ToMonitor::InfoSchema(InfoSchema { component, info, last, bytes }))
                })
            }),
            Self::Lease(lease) => packets.push(&ToMonitor::Lease(*lease)),
            Self::Params(parts) => parts.iter().try_for_each(|values| packets.push(&ToMonitor::Params(values.clone()))),
            Self::Answer { number, cycle, arrived, result } => {
                let result = match result {
                    AnswerKind::Done(values) => AnswerResult::Done { values: values.iter().copied().collect() },
                    AnswerKind::Refused { code, entry, text } => {
                        let text = truncate(text, MAX_TEXT_BYTES);
                        AnswerResult::Refused { code: *code, entry: *entry, text }
                    }
                };
                packets.push(&ToMonitor::Answer(Answer { number: *number, cycle: *cycle, arrived: *arrived, result }))
            }
            Self::Log { time_us, level, source, text } => {
                let text = truncate(text, MAX_TEXT_BYTES);
                packets.push(&ToMonitor::Log(LogLine { time_us: *time_us, level: *level, source: *source, text }))
            }
            Self::World(state) => packets.push_extra(&ToMonitorExtra::World(*state)),
            Self::Taken(taken) => packets.push_extra(&ToMonitorExtra::Taken(*taken)),
            Self::Reached(reached) => packets.push_extra(&ToMonitorExtra::Reached(*reached)),
            Self::Scene(sent) => sent.messages(|message| packets.push_extra(message)),
            Self::Result(text) => packets.push_extra(&ToMonitorExtra::Result(truncate(text, MAX_TEXT_BYTES))),
            Self::Closing(reason) => packets.push(&ToMonitor::Closing { reason }),
        }
    }
}

/// Passes a schema on in parts, each with whether it is the last one.
fn in_parts(
    schema: &'static NamedType,
    mut part: impl FnMut(bool, &[u8]) -> Result<(), TooLarge>,
) -> Result<(), TooLarge> {
    let bytes = postcard::to_stdvec(schema).map_err(|_| TooLarge)?;
    let count = bytes.len().div_ceil(SCHEMA_PART_BYTES);
    bytes.chunks(SCHEMA_PART_BYTES).zip(1..).try_for_each(|(bytes, number)| part(number == count, bytes))
}
