//! Data of one cycle, shared by all monitors.

use std::ops::Range;
use std::sync::Arc;

use bica::info::{InfoSink, Information};
use bica::{ComponentId, Tree};
use bica_wire::message::{InfoValue, MAX_INFO_BYTES};
use bica_wire::{ToMonitor, TooLarge};
use serde::Serialize;

use super::encoded::{Encoded, EncodedReading};
use super::extras::Extra;
use super::key::Key;
use super::snapshot::Snapshot;
use super::watcher::Watcher;

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
        let mut sink = Bytes { room: &mut self.bytes[self.used..self.used + MAX_INFO_BYTES], length: None };
        if !tree.read_info(ComponentId::new(component.into()), usize::from(info), &mut sink) {
            return;
        }
        let place = sink.length.map(|length| self.used..self.used + length);
        self.used = place.as_ref().map_or(self.used, |place| place.end);
        self.readings.push(Reading { component, info, place });
    }

    /// Encodes everything once for all monitors.
    pub(super) fn encode(&self) -> Result<Encoded, TooLarge> {
        let cycle = self.cycle;
        let (mut bytes, mut snapshot, mut readings) =
            (Vec::with_capacity(2 * self.used + 1024), Vec::new(), Vec::new());
        self.snapshot.messages(|message| append(&mut bytes, message).map(|place| snapshot.push(place)))?;
        for Reading { component, info, place } in &self.readings {
            let (component, info) = (*component, *info);
            let value = place.clone().and_then(|place| self.bytes.get(place));
            let place = append(&mut bytes, &ToMonitor::Info(InfoValue { cycle, component, info, bytes: value }))?;
            readings.push(EncodedReading { key: Key::Info(component, info), places: vec![place] });
        }
        for extra in &self.extras {
            let mut places = Vec::new();
            extra.messages(cycle, |message| append(&mut bytes, message).map(|place| places.push(place)))?;
            readings.push(EncodedReading { key: extra.key(), places });
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
    /// Length of the value; none if it has no room.
    length: Option<usize>,
}

impl InfoSink for Bytes<'_> {
    fn take<V: Information>(&mut self, value: &V) {
        self.length = postcard::to_slice(value, self.room).ok().map(|bytes| bytes.len());
    }
}
