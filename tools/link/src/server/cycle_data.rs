//! Data of one cycle, shared by all monitors.

use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::ops::Range;
use std::sync::Arc;

use bica::info::{InfoSink, Information};
use bica::{ComponentId, Tree};
use bica_wire::message::{InfoSchema, InfoValue, MAX_INFO_BYTES, SCHEMA_PART_BYTES};
use bica_wire::{ToMonitor, TooLarge};
use postcard_schema::schema::NamedType;

use super::snapshot::Snapshot;
use crate::frame::Packets;

/// Watched information, component and index, with n for every n-th cycle.
pub(super) type Watched = BTreeMap<(u16, u16), u16>;

/// Data of one cycle: what at least one monitor watches.
#[derive(Debug)]
pub(super) struct CycleData {
    cycle: u64,
    pub(super) snapshot: Option<Snapshot>,
    readings: Vec<Reading>,
    /// Values of all readings in postcard's format.
    bytes: Vec<u8>,
}

#[derive(Debug)]
struct Reading {
    component: u16,
    info: u16,
    schema: &'static NamedType,
    /// Place of the value in the bytes; none if it is too large.
    place: Option<Range<usize>>,
}

/// Data of one cycle for one monitor.
#[derive(Debug)]
pub(super) struct Shown {
    pub(super) data: Arc<CycleData>,
    /// Whether the snapshot is due for this monitor.
    pub(super) snapshot: bool,
    pub(super) watched: Arc<Watched>,
}

impl CycleData {
    pub(super) const fn new(cycle: u64, snapshot: Option<Snapshot>) -> Self {
        Self { cycle, snapshot, readings: Vec::new(), bytes: Vec::new() }
    }

    /// Whether there is nothing to send.
    pub(super) const fn is_empty(&self) -> bool {
        self.snapshot.is_none() && self.readings.is_empty()
    }

    /// Reads an information.
    pub(super) fn read<T: Tree>(&mut self, tree: &T, component: u16, info: u16) {
        let mut sink = Bytes { bytes: &mut self.bytes, taken: None };
        tree.read_info(ComponentId::new(component.into()), info.into(), &mut sink);
        let Some((schema, place)) = sink.taken else { return };
        self.readings.push(Reading { component, info, schema, place });
    }

    fn encode(&self, reading: &Reading, packets: &mut Packets) -> Result<(), TooLarge> {
        let bytes = reading.place.clone().and_then(|place| self.bytes.get(place));
        let (cycle, component, info) = (self.cycle, reading.component, reading.info);
        packets.push(&ToMonitor::Info(InfoValue { cycle, component, info, bytes }))
    }
}

/// Appends a value in postcard's format.
struct Bytes<'a> {
    bytes: &'a mut Vec<u8>,
    /// Schema and place of the value.
    taken: Option<(&'static NamedType, Option<Range<usize>>)>,
}

impl InfoSink for Bytes<'_> {
    fn take<V: Information>(&mut self, value: &V) {
        // The buffer bounds the time that a large value takes.
        let place = postcard::to_slice(value, &mut [0; MAX_INFO_BYTES]).ok().map(|bytes| {
            let start = self.bytes.len();
            self.bytes.extend_from_slice(bytes);
            start..self.bytes.len()
        });
        self.taken = Some((V::SCHEMA, place));
    }
}

/// Appends the newest snapshot and the newest value of each information; `schemas` are those that were sent.
pub(super) fn encode(
    shown: &VecDeque<Shown>,
    schemas: &mut BTreeSet<(u16, u16)>,
    packets: &mut Packets,
) -> Result<(), TooLarge> {
    let mut snapshots = shown.iter().rev().filter(|shown| shown.snapshot);
    if let Some(snapshot) = snapshots.find_map(|shown| shown.data.snapshot.as_ref()) {
        snapshot.encode(packets)?;
    }
    let mut sent = BTreeSet::new();
    for Shown { data, watched, .. } in shown.iter().rev() {
        for reading in &data.readings {
            let key = (reading.component, reading.info);
            let is_due = watched.get(&key).is_some_and(|&every| data.cycle.is_multiple_of(every.into()));
            if !is_due || (shown.len() > 1 && !sent.insert(key)) {
                continue;
            }
            if schemas.insert(key) {
                push_schema(reading, packets)?;
            }
            data.encode(reading, packets)?;
        }
    }
    Ok(())
}

fn push_schema(reading: &Reading, packets: &mut Packets) -> Result<(), TooLarge> {
    let (component, info) = (reading.component, reading.info);
    let bytes = postcard::to_stdvec(reading.schema).map_err(|_| TooLarge)?;
    let parts = bytes.chunks(SCHEMA_PART_BYTES);
    let last = parts.len() - 1;
    for (index, bytes) in parts.enumerate() {
        packets.push(&ToMonitor::InfoSchema(InfoSchema { component, info, last: index == last, bytes }))?;
    }
    Ok(())
}
