//! Messages that wait for a monitor.

use std::collections::{BTreeMap, VecDeque};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError, TryLockError};

use bica::Graph;
use bica_wire::message::{
    Answer, AnswerResult, Attached, InfoSchema, InfoValue, LeaseState, LogLine, MAX_TEXT_BYTES, ParamValues,
    RefusalCode, SCHEMA_PART_BYTES, Value,
};
use bica_wire::{FromRobot, ToMonitor, TooLarge, describe, truncate};
use postcard_schema::schema::NamedType;

use super::snapshot::Snapshot;
use crate::frame::Packets;

/// Largest number of messages in the lossless queue. A monitor that leaves more unread is disconnected.
pub(super) const MAX_STATE: usize = 256;

/// Message of the lossless queue.
#[derive(Debug)]
pub(super) enum Message {
    Attached(Attached<'static>),
    Describe(&'static Graph),
    Lease(LeaseState),
    Params(Vec<ParamValues>),
    Schema { component: u16, info: u16, schema: &'static NamedType },
    Answer { number: u32, cycle: u64, arrived: u64, result: AnswerKind },
    Log { time_us: u64, level: u8, text: Arc<str> },
    Closing(&'static str),
}

/// Result of a request.
#[derive(Debug)]
pub(super) enum AnswerKind {
    Done(Vec<Value>),
    Refused { code: RefusalCode, entry: u16, text: String },
}

/// A value of the latest-wins queue: a new one replaces an old one of the same key.
#[derive(Debug)]
pub(super) enum Data {
    Snapshot(Arc<Snapshot>),
    Info(Arc<InfoReading>),
}

/// A value of information.
#[derive(Debug)]
pub(super) struct InfoReading {
    pub(super) cycle: u64,
    pub(super) component: u16,
    pub(super) info: u16,
    pub(super) bytes: Option<Vec<u8>>,
}

impl Data {
    fn key(&self) -> Option<(u16, u16)> {
        match self {
            Self::Snapshot(_) => None,
            Self::Info(reading) => Some((reading.component, reading.info)),
        }
    }
}

/// The newest value of each key: a snapshot, or an information.
type DataQueue = BTreeMap<Option<(u16, u16)>, Data>;

/// The two queues of a monitor.
#[derive(Debug, Default)]
pub(super) struct Outbox {
    queues: Mutex<Queues>,
    filled: Condvar,
}

#[derive(Debug, Default)]
struct Queues {
    state: VecDeque<Message>,
    data: DataQueue,
    closed: bool,
}

/// Result of handing messages to the queues without waiting.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Offered {
    /// They are in the queues.
    Taken,
    /// Another thread uses the queues; the messages are still with the caller.
    Contended,
    /// The lossless queue is full.
    Overflow,
}

impl Outbox {
    /// Adds a message to the lossless queue; returns whether there was room. For threads that may wait.
    pub(super) fn push(&self, message: Message) -> bool {
        let mut queues = self.lock();
        let room = queues.state.len() < MAX_STATE;
        if room {
            queues.state.push_back(message);
        }
        drop(queues);
        self.filled.notify_one();
        room
    }

    /// Moves messages and data into the queues, unless another thread uses these. For the loop, which never waits.
    pub(super) fn offer(&self, messages: &mut VecDeque<Message>, data: &mut Vec<Data>) -> Offered {
        let mut queues = match self.queues.try_lock() {
            Ok(queues) => queues,
            Err(TryLockError::Poisoned(poisoned)) => poisoned.into_inner(),
            Err(TryLockError::WouldBlock) => return Offered::Contended,
        };
        if queues.state.len() + messages.len() > MAX_STATE {
            return Offered::Overflow;
        }
        queues.state.append(messages);
        for data in data.drain(..) {
            queues.data.insert(data.key(), data);
        }
        drop(queues);
        self.filled.notify_one();
        Offered::Taken
    }

    /// Waits for messages and takes all; `None` after [`close`](Self::close).
    pub(super) fn take(&self) -> Option<(VecDeque<Message>, DataQueue)> {
        let queues = self.lock();
        let empty = |queues: &mut Queues| queues.state.is_empty() && queues.data.is_empty() && !queues.closed;
        let mut queues = self.filled.wait_while(queues, empty).unwrap_or_else(PoisonError::into_inner);
        let queues = &mut *queues;
        (!queues.closed).then(|| (std::mem::take(&mut queues.state), std::mem::take(&mut queues.data)))
    }

    /// Ends the thread that takes messages.
    pub(super) fn close(&self) {
        self.lock().closed = true;
        self.filled.notify_one();
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
            Self::Describe(graph) => {
                describe(graph).try_for_each(|item| packets.push_robot(&FromRobot::GraphItem(item)))
            }
            Self::Lease(lease) => packets.push(&ToMonitor::Lease(*lease)),
            Self::Params(parts) => parts.iter().try_for_each(|values| packets.push(&ToMonitor::Params(values.clone()))),
            Self::Schema { component, info, schema } => push_schema(*component, *info, schema, packets),
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
            Self::Log { time_us, level, text } => {
                let text = truncate(text, MAX_TEXT_BYTES);
                packets.push(&ToMonitor::Log(LogLine { time_us: *time_us, level: *level, text }))
            }
            Self::Closing(reason) => packets.push(&ToMonitor::Closing { reason }),
        }
    }
}

impl Data {
    /// Appends the packets of this value.
    pub(super) fn encode(&self, packets: &mut Packets) -> Result<(), TooLarge> {
        match self {
            Self::Snapshot(snapshot) => snapshot.encode(packets),
            Self::Info(reading) => {
                let InfoReading { cycle, component, info, .. } = **reading;
                packets.push(&ToMonitor::Info(InfoValue { cycle, component, info, bytes: reading.bytes.as_deref() }))
            }
        }
    }
}

fn push_schema(component: u16, info: u16, schema: &NamedType, packets: &mut Packets) -> Result<(), TooLarge> {
    let bytes = postcard::to_stdvec(schema).map_err(|_| TooLarge)?;
    let parts = bytes.chunks(SCHEMA_PART_BYTES);
    let last = parts.len() - 1;
    for (index, bytes) in parts.enumerate() {
        packets.push(&ToMonitor::InfoSchema(InfoSchema { component, info, last: index == last, bytes }))?;
    }
    Ok(())
}
