//! Messages that wait for a monitor.

use std::collections::VecDeque;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError, TryLockError};
use std::time::Duration;

use bica::Graph;
use bica::action::Action;
use bica_wire::message::{
    Answer, AnswerResult, Attached, Happened, LeaseState, LogLine, LogSource, MAX_TEXT_BYTES, OutputSchema,
    ParamValues, Reached, RefusalCode, Requested, SCHEMA_PART_BYTES, Taken, Value, WorldState,
};
use bica_wire::{FromRobot, ToMonitor, ToMonitorExtra, TooLarge, describe, truncate};
use postcard_schema::schema::NamedType;

use super::cycle_data::{Due, Part};
use super::key::Key;
use super::scene::Sent;
use crate::frame::Packets;
use crate::image::Image;
use crate::pending::Pending;

/// Largest number of messages that the loop keeps while the writer uses the queues.
const MAX_UNSENT: usize = 1 << 16;
/// Maximum number of cycles whose data wait as they are. Of older cycles only the newest value of each key waits.
const MAX_DATA: usize = 8;
/// Number of messages that wake the writer.
const WAKE_MESSAGES: usize = 256;
/// Time between two checks of the writer: to wake it in each cycle would cost the loop a call of the operating system, which
/// takes longer than everything else.
const POLL: Duration = Duration::from_millis(2);
/// Number of checks without a result after which the writer sleeps until it is woken.
const POLLS: u32 = 16;

/// Message of the lossless queue.
#[derive(Clone, Debug)]
pub(super) enum Message {
    Attached(Attached<'static>),
    Describe(&'static Graph, &'static [Action], MessageSchemas),
    Schemas(Arc<[KnownSchema]>),
    Lease(LeaseState),
    Params(Vec<ParamValues>),
    Answer {
        number: u32,
        cycle: u64,
        arrived: u64,
        result: AnswerKind,
    },
    Log {
        time_us: u64,
        level: u8,
        source: LogSource,
        text: Arc<str>,
    },
    World(WorldState),
    Taken(Taken),
    Reached(Reached),
    Scene(Sent),
    Requested(Arc<Requested>),
    /// Time, µs, kind and detail.
    Happened(u64, Arc<str>, Arc<str>),
    Result(Arc<str>),
    Closing(&'static str),
}

/// Schemas of sensor values and command.
pub(super) type MessageSchemas = [&'static NamedType; 2];

/// Schema of an output.
#[derive(Clone, Copy, Debug)]
pub(super) struct KnownSchema {
    pub(super) component: u16,
    pub(super) output: u16,
    pub(super) schema: &'static NamedType,
}

/// Result of a request.
#[derive(Clone, Debug)]
pub(super) enum AnswerKind {
    Done(Vec<Value>),
    Refused { code: RefusalCode, entry: u16, text: String },
}

/// Data of the loop for a monitor that the writer has not received yet.
#[derive(Debug, Default)]
pub(super) struct Unsent {
    pub(super) messages: VecDeque<Message>,
    /// Data of cycles, the oldest first.
    pub(super) data: VecDeque<Due>,
    /// The newest image of which no part was sent.
    pub(super) image: Option<Image>,
}

impl Unsent {
    pub(super) fn is_empty(&self) -> bool {
        self.messages.is_empty() && self.data.is_empty() && self.image.is_none()
    }
}

/// The queues of a monitor. Their lock is held for moves only, unless a monitor is slow.
#[derive(Debug, Default)]
pub(super) struct Outbox {
    queues: Mutex<Queues>,
    filled: Condvar,
}

/// Data that the writer sends next: messages and the newest values of older cycles, and the data of the last ones.
pub(super) struct Batch {
    pub(super) waiting: Pending<Message, Key, Part>,
    pub(super) data: VecDeque<Due>,
    pub(super) image: Option<Image>,
}

#[derive(Debug, Default)]
struct Queues {
    waiting: Pending<Message, Key, Part>,
    /// The newest data of cycles.
    data: VecDeque<Due>,
    image: Option<Image>,
    sleep: Sleep,
    closed: bool,
}

/// Sleep state of the writer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Sleep {
    #[default]
    Awake,
    /// The writer checks the queues again soon.
    Short,
    /// Only a wake-up ends the sleep.
    Long,
}

impl Queues {
    /// Splits the oldest data if there are too many: only the newest value of each key waits.
    fn limit_data(&mut self) {
        while self.data.len() > MAX_DATA {
            for part in self.data.pop_front().iter().flat_map(Due::parts) {
                self.waiting.show(part.key(), part, |newer, _| newer);
            }
        }
    }
}

impl Outbox {
    /// Adds a message to the lossless queue; returns whether there was room. For threads that may wait, not for the loop.
    pub(super) fn push(&self, message: Message) -> bool {
        let mut queues = self.lock();
        // Messages are small, so it suffices to bound their number.
        let room = queues.waiting.push(message, 0);
        self.wake(queues);
        room
    }

    /// Takes over the loop's data, unless the writer is using the queues. Returns whether there was room for the messages.
    pub(super) fn offer(&self, unsent: &mut Unsent) -> bool {
        let mut guard = match self.queues.try_lock() {
            Ok(queues) => queues,
            Err(TryLockError::Poisoned(poisoned)) => poisoned.into_inner(),
            Err(TryLockError::WouldBlock) => {
                let surplus = unsent.data.len().saturating_sub(MAX_DATA);
                unsent.data.drain(..surplus);
                return unsent.messages.len() < MAX_UNSENT;
            }
        };
        let queues = &mut *guard;
        let mut room = true;
        for message in unsent.messages.drain(..) {
            room &= queues.waiting.push(message, 0);
        }
        queues.data.append(&mut unsent.data);
        queues.limit_data();
        if let Some(image) = unsent.image.take() {
            queues.image = Some(image);
        }
        let is_much = queues.data.len() >= MAX_DATA / 2 || queues.waiting.messages() >= WAKE_MESSAGES;
        if is_much || queues.sleep == Sleep::Long {
            self.wake(guard);
        }
        room
    }

    /// Waits for messages, data or an image and takes all; `None` after [`close`](Self::close). It checks [`POLLS`] times, then
    /// sleeps until it is woken. With `is_sending`, while an image is being sent, it does not wait, and leaves the next image.
    pub(super) fn take(&self, is_sending: bool) -> Option<Batch> {
        let (mut queues, mut polls) = (self.lock(), 0);
        let is_idle = |queues: &Queues| queues.waiting.is_empty() && queues.data.is_empty() && queues.image.is_none();
        while !is_sending && is_idle(&queues) && !queues.closed {
            if polls < POLLS {
                polls += 1;
                queues.sleep = Sleep::Short;
                queues = self.filled.wait_timeout(queues, POLL).unwrap_or_else(PoisonError::into_inner).0;
            } else {
                queues.sleep = Sleep::Long;
                queues = self.filled.wait(queues).unwrap_or_else(PoisonError::into_inner);
            }
        }
        queues.sleep = Sleep::Awake;
        if queues.closed {
            return None;
        }
        let image = if is_sending { None } else { queues.image.take() };
        Some(Batch { waiting: std::mem::take(&mut queues.waiting), data: std::mem::take(&mut queues.data), image })
    }

    /// Ends the thread that takes messages.
    pub(super) fn close(&self) {
        let mut queues = self.lock();
        queues.closed = true;
        self.wake(queues);
    }

    fn wake(&self, mut queues: MutexGuard<'_, Queues>) {
        let sleep = std::mem::take(&mut queues.sleep);
        drop(queues);
        if sleep != Sleep::Awake {
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
            Self::Schemas(outputs) => outputs.iter().try_for_each(|&KnownSchema { component, output, schema }| {
                in_parts(schema, |last, bytes| {
                    packets.push(&ToMonitor::OutputSchema(OutputSchema { component, output, last, bytes }))
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
            Self::Requested(requested) => packets.push_extra(&ToMonitorExtra::Requested((**requested).clone())),
            Self::Happened(time_us, kind, detail) => {
                let (kind, detail) = (truncate(kind, MAX_TEXT_BYTES), truncate(detail, MAX_TEXT_BYTES));
                packets.push_extra(&ToMonitorExtra::Happened(Happened { time_us: *time_us, kind, detail }))
            }
            Self::Result(text) => packets.push_extra(&ToMonitorExtra::Result(truncate(text, MAX_TEXT_BYTES))),
            Self::Closing(reason) => packets.push(&ToMonitor::Closing { reason }),
        }
    }
}

/// Passes a schema on in parts; the flag marks the last part.
fn in_parts(
    schema: &'static NamedType,
    mut part: impl FnMut(bool, &[u8]) -> Result<(), TooLarge>,
) -> Result<(), TooLarge> {
    let bytes = postcard::to_stdvec(schema).map_err(|_| TooLarge)?;
    let count = bytes.len().div_ceil(SCHEMA_PART_BYTES);
    bytes.chunks(SCHEMA_PART_BYTES).zip(1..).try_for_each(|(bytes, number)| part(number == count, bytes))
}

#[cfg(test)]
mod tests {
    use super::super::cycle_data::{Watched, tests::data};
    use super::*;

    /// Offers a message and data in each of 20 cycles; none of them is taken.
    fn offer(outbox: &Outbox, unsent: &mut Unsent) {
        let watched = Arc::new(Watched::from([(Key::Output(0, 0), 1), (Key::Output(0, 1), 1000)]));
        for cycle in 0..20 {
            unsent.messages.push_back(Message::Happened(cycle, "".into(), "".into()));
            let data = data(cycle, &[0, 1]);
            unsent.data.push_back(Due { data, snapshot: true, watched: Arc::clone(&watched) });
            assert!(outbox.offer(unsent));
        }
    }

    /// Takes everything: the times of the messages, and the keys of the data with their cycles.
    fn take(outbox: &Outbox) -> (Vec<u64>, Vec<(Key, u64)>) {
        let Batch { mut waiting, data, .. } = outbox.take(false).unwrap();
        let time = |message| match message {
            Message::Happened(time_us, ..) => time_us,
            _ => panic!("another message"),
        };
        let times = std::iter::from_fn(|| waiting.message()).map(time).collect();
        let parts = std::iter::from_fn(|| waiting.data()).chain(data.iter().flat_map(Due::parts));
        (times, parts.map(|part| (part.key(), part.cycle())).collect())
    }

    /// The data of the last cycles.
    fn last() -> impl Iterator<Item = (Key, u64)> {
        (12..20).flat_map(|cycle| [(Key::Snapshot, cycle), (Key::Output(0, 0), cycle)])
    }

    #[test]
    fn slow_writer_gets_all_messages_and_newest_values() {
        let (outbox, mut unsent) = (Outbox::default(), Unsent::default());
        offer(&outbox, &mut unsent);
        assert!(unsent.is_empty());
        let older = [(Key::Snapshot, 11), (Key::Output(0, 0), 11), (Key::Output(0, 1), 0)];
        assert_eq!(take(&outbox), ((0..20).collect(), older.into_iter().chain(last()).collect()));
    }

    #[test]
    fn loop_keeps_little_while_the_writer_is_busy() {
        let (outbox, mut unsent) = (Outbox::default(), Unsent::default());
        let busy = outbox.lock();
        offer(&outbox, &mut unsent);
        drop(busy);
        assert_eq!((unsent.messages.len(), unsent.data.len()), (20, MAX_DATA));
        assert!(outbox.offer(&mut unsent) && unsent.is_empty());
        assert_eq!(take(&outbox), ((0..20).collect(), last().collect()));
    }
}
