//! Data of one cycle, shared by all monitors.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::sync::Arc;

use bica::info::{InfoSink, Information};
use bica::{ComponentId, Tree};
use bica_wire::message::{InfoSchema, InfoValue, MAX_INFO_BYTES, SCHEMA_PART_BYTES};
use bica_wire::{FromRobot, ToMonitor, TooLarge};
use postcard_schema::schema::NamedType;
use serde::Serialize;

use super::extras::Extra;
use super::key::Key;
use super::snapshot::Snapshot;
use super::watcher::Watcher;
use crate::frame::Packets;

/// What is watched, with n for every n-th cycle.
pub(super) type Watched = BTreeMap<Key, u16>;

/// Data of one cycle: what at least one monitor watches. The loop fills it, and its memory is used again.
#[derive(Debug, Default)]
pub(super) struct CycleData {
    pub(super) cycle: u64,
    /// The monitors in this cycle.
    pub(super) watchers: Arc<[Watcher]>,
    pub(super) snapshot: Snapshot,
    readings: Vec<Reading>,
    pub(super) extras: Vec<Extra>,
    /// Values of all readings in postcard's format, and room for one more.
    bytes: Vec<u8>,
    /// Number of bytes that values occupy.
    used: usize,
}

#[derive(Debug)]
struct Reading {
    component: u16,
    info: u16,
    schema: &'static NamedType,
    /// Place of the value in the bytes; none if it is too large.
    place: Option<Range<usize>>,
}

impl CycleData {
    /// Removes the contents; the memory is kept.
    pub(super) fn begin(&mut self, cycle: u64) {
        self.cycle = cycle;
        self.snapshot.clear();
        self.readings.clear();
        self.extras.clear();
        self.used = 0;
    }

    /// Whether there is nothing to send.
    pub(super) const fn is_empty(&self) -> bool {
        self.snapshot.is_empty() && self.readings.is_empty() && self.extras.is_empty()
    }

    /// Reads an output.
    pub(super) fn read<T: Tree>(&mut self, tree: &T, component: u16, info: u16) {
        // The room bounds the time that a large value takes.
        if self.bytes.len() < self.used + MAX_INFO_BYTES {
            self.bytes.resize(2 * (self.used + MAX_INFO_BYTES), 0);
        }
        let mut sink = Bytes { room: &mut self.bytes[self.used..self.used + MAX_INFO_BYTES], taken: None };
        tree.read_info(ComponentId::new(component.into()), usize::from(info), &mut sink);
        let Some((schema, length)) = sink.taken else { return };
        let place = length.map(|length| self.used..self.used + length);
        self.used = place.as_ref().map_or(self.used, |place| place.end);
        self.readings.push(Reading { component, info, schema, place });
    }

    /// Encodes everything once for all monitors.
    pub(super) fn encode(&self) -> Result<Encoded, TooLarge> {
        let cycle = self.cycle;
        let (mut bytes, mut snapshot, mut readings) =
            (Vec::with_capacity(2 * self.used + 1024), Vec::new(), Vec::new());
        self.snapshot.messages(|message| append(&mut bytes, message).map(|place| snapshot.push(place)))?;
        for Reading { component, info, schema, place } in &self.readings {
            let (component, info) = (*component, *info);
            let value = place.clone().and_then(|place| self.bytes.get(place));
            let place = append(&mut bytes, &ToMonitor::Info(InfoValue { cycle, component, info, bytes: value }))?;
            readings.push(EncodedReading {
                key: Key::Info(component, info),
                schema: Some(schema),
                places: vec![place],
            });
        }
        for extra in &self.extras {
            let mut places = Vec::new();
            extra.messages(cycle, |message| append(&mut bytes, message).map(|place| places.push(place)))?;
            readings.push(EncodedReading { key: extra.key(), schema: None, places });
        }
        Ok(Encoded { cycle, snapshot, readings, bytes })
    }
}

/// Appends a message in postcard's format; returns its place.
fn append(bytes: &mut Vec<u8>, message: &impl Serialize) -> Result<Range<usize>, TooLarge> {
    let start = bytes.len();
    *bytes = postcard::to_extend(message, std::mem::take(bytes)).map_err(|_| TooLarge)?;
    Ok(start..bytes.len())
}

/// Puts a value in postcard's format into the room.
struct Bytes<'a> {
    room: &'a mut [u8],
    /// Schema and length of the value; no length if it has no room.
    taken: Option<(&'static NamedType, Option<usize>)>,
}

impl InfoSink for Bytes<'_> {
    fn take<V: Information>(&mut self, value: &V) {
        let length = postcard::to_slice(value, self.room).ok().map(|bytes| bytes.len());
        self.taken = Some((V::SCHEMA, length));
    }
}

/// Messages with the data of one cycle.
#[derive(Debug, Default)]
pub(super) struct Encoded {
    pub(super) cycle: u64,
    /// Places of the messages of the snapshot; none if it is due for nobody.
    snapshot: Vec<Range<usize>>,
    readings: Vec<EncodedReading>,
    bytes: Vec<u8>,
}

impl Encoded {
    /// Whether there is a snapshot: the true state of a cycle comes alone.
    pub(super) const fn has_snapshot(&self) -> bool {
        !self.snapshot.is_empty()
    }
}

#[derive(Debug)]
struct EncodedReading {
    key: Key,
    /// Of an output; none for what has messages of its own.
    schema: Option<&'static NamedType>,
    /// Places of its messages.
    places: Vec<Range<usize>>,
}

/// Data of a cycle for one monitor: a snapshot, or a value.
#[derive(Debug)]
pub(super) struct EncodedPart {
    data: Arc<Encoded>,
    /// Place of the value among the readings; none for the snapshot.
    reading: Option<usize>,
}

impl Encoded {
    /// What is due for a monitor.
    pub(super) fn parts(data: &Arc<Self>, snapshot: bool, watched: &Watched) -> impl Iterator<Item = EncodedPart> {
        let is_due = |(_, reading): &(usize, &EncodedReading)| {
            watched.get(&reading.key).is_some_and(|&every| data.cycle.is_multiple_of(every.into()))
        };
        let values = data.readings.iter().enumerate().filter(is_due).map(|(index, _)| Some(index));
        let parts = snapshot.then_some(None).into_iter().chain(values);
        parts.map(|reading| EncodedPart { data: Arc::clone(data), reading })
    }
}

impl EncodedPart {
    pub(super) fn key(&self) -> Key {
        self.reading.map_or(Key::Snapshot, |index| self.data.readings[index].key)
    }

    /// Appends the packets; `schemas` are those that were sent.
    pub(super) fn frame(&self, schemas: &mut BTreeSet<Key>, packets: &mut Packets) -> Result<(), TooLarge> {
        let data = &self.data;
        let Some(index) = self.reading else {
            return data.snapshot.iter().try_for_each(|place| packets.push_encoded(&data.bytes[place.clone()]));
        };
        let EncodedReading { key, schema, places } = &data.readings[index];
        if let (Key::Info(component, info), Some(schema)) = (key, schema)
            && schemas.insert(*key)
        {
            push_schema((*component, *info), schema, packets)?;
        }
        places.iter().try_for_each(|place| {
            let bytes = &data.bytes[place.clone()];
            match schema {
                Some(_) => packets.push_encoded(bytes),
                None => packets.push_robot(&FromRobot::MonitorExtra(bytes)),
            }
        })
    }
}

fn push_schema(
    (component, info): (u16, u16),
    schema: &'static NamedType,
    packets: &mut Packets,
) -> Result<(), TooLarge> {
    let bytes = postcard::to_stdvec(schema).map_err(|_| TooLarge)?;
    let parts = bytes.chunks(SCHEMA_PART_BYTES);
    let last = parts.len() - 1;
    for (index, bytes) in parts.enumerate() {
        packets.push(&ToMonitor::InfoSchema(InfoSchema { component, info, last: index == last, bytes }))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pending::Pending;

    /// Data of a cycle with the values of these outputs.
    fn encoded(cycle: u64, outputs: &[u16]) -> Arc<Encoded> {
        let reading = |&info: &u16| EncodedReading { key: Key::Info(0, info), schema: None, places: Vec::new() };
        Arc::new(Encoded { cycle, readings: outputs.iter().map(reading).collect(), ..Encoded::default() })
    }

    #[test]
    fn of_data_that_nobody_takes_the_newest_value_of_each_output_stays() {
        let mut waiting = Pending::<(), Key, EncodedPart>::default();
        let watched = Watched::from([(Key::Info(0, 0), 1), (Key::Info(0, 1), 1000)]);
        for cycle in 0..100 {
            for part in Encoded::parts(&encoded(cycle, &[0, 1]), true, &watched) {
                waiting.show(part.key(), part, |newer, _| newer);
            }
        }
        let taken = std::iter::from_fn(|| waiting.data()).map(|part| (part.key(), part.data.cycle));
        let expected = [(Key::Snapshot, 99), (Key::Info(0, 0), 99), (Key::Info(0, 1), 0)];
        assert_eq!(taken.collect::<Vec<_>>(), expected);
    }
}
