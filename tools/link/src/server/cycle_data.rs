//! Data of one cycle, shared by all monitors.

use std::collections::HashMap;
use std::ops::Range;
use std::sync::Arc;

use bica_wire::message::{MAX_OUTPUT_BYTES, OutputValue};
use bica_wire::{ToMonitor, TooLarge};

use super::extras::Extra;
use super::key::Key;
use super::snapshot::Snapshot;
use super::view::View;
use crate::frame::Packets;

/// Watched data, with n for every n-th cycle.
pub(super) type Watched = HashMap<Key, u16>;

/// Largest number of cycles whose memory is kept.
const MAX_KEPT: usize = 16;

/// Data of one cycle that at least one monitor watches. The loop fills it once for all monitors.
#[derive(Clone, Debug, Default)]
pub(super) struct CycleData {
    pub(super) cycle: u64,
    pub(super) snapshot: Snapshot,
    readings: Vec<Reading>,
    pub(super) extras: Vec<Extra>,
    /// Values of all readings in postcard's format, and room for one more.
    bytes: Vec<u8>,
    /// Number of bytes that values occupy.
    used: usize,
}

#[derive(Clone, Debug)]
struct Reading {
    component: u16,
    output: u16,
    /// Place of the value in the bytes; none if it is too large.
    place: Option<Range<usize>>,
}

impl CycleData {
    /// Removes the contents; the memory is kept.
    fn begin(&mut self, cycle: u64) {
        self.cycle = cycle;
        self.snapshot.clear();
        self.readings.clear();
        self.extras.clear();
        self.used = 0;
    }

    /// Returns whether there is nothing to send.
    pub(super) const fn is_empty(&self) -> bool {
        self.snapshot.is_empty() && self.readings.is_empty() && self.extras.is_empty()
    }

    /// Reads an output.
    pub(super) fn read(&mut self, tree: &impl View, component: u16, output: u16) {
        // The room bounds the time that a large value takes.
        if self.bytes.len() < self.used + MAX_OUTPUT_BYTES {
            self.bytes.resize(2 * (self.used + MAX_OUTPUT_BYTES), 0);
        }
        let room = &mut self.bytes[self.used..self.used + MAX_OUTPUT_BYTES];
        let Some(length) = tree.output(component, output, room) else { return };
        let place = length.ok().map(|length| self.used..self.used + length);
        self.used = place.as_ref().map_or(self.used, |place| place.end);
        self.readings.push(Reading { component, output, place });
    }
}

/// Memory of the data of cycles, which is used again once no monitor needs it.
#[derive(Debug, Default)]
pub(super) struct CyclePool(Vec<Arc<CycleData>>);

impl CyclePool {
    /// Fills the data of a cycle; none if there is nothing to send.
    pub(super) fn fill(&mut self, cycle: u64, fill: impl FnOnce(&mut CycleData)) -> Option<Arc<CycleData>> {
        let free = self.0.iter_mut().position(|data| Arc::get_mut(data).is_some());
        let mut data = free.map_or_else(Arc::default, |free| self.0.swap_remove(free));
        // There is no other reference to it, so this copies nothing.
        let filled = Arc::make_mut(&mut data);
        filled.begin(cycle);
        fill(filled);
        if self.0.len() < MAX_KEPT {
            self.0.push(Arc::clone(&data));
        }
        (!data.is_empty()).then_some(data)
    }
}

/// Data of a cycle, and the part that is due for a monitor.
#[derive(Debug)]
pub(super) struct Due {
    pub(super) data: Arc<CycleData>,
    pub(super) snapshot: bool,
    pub(super) watched: Arc<Watched>,
}

impl Due {
    /// Returns the due values.
    pub(super) fn parts(&self) -> impl Iterator<Item = Part> {
        let Self { data, snapshot, watched } = self;
        let is_due =
            |part: &Part| watched.get(&part.key()).is_some_and(|&every| data.cycle.is_multiple_of(every.into()));
        let part = |value| Part { data: Arc::clone(data), value };
        let readings = (0..data.readings.len()).map(Value::Reading);
        let values = readings.chain((0..data.extras.len()).map(Value::Extra));
        snapshot.then_some(Value::Snapshot).map(part).into_iter().chain(values.map(part).filter(is_due))
    }
}

/// Place of a value in the data of a cycle.
#[derive(Clone, Copy, Debug)]
enum Value {
    Snapshot,
    Reading(usize),
    Extra(usize),
}

/// A value in the data of a cycle.
#[derive(Debug)]
pub(super) struct Part {
    data: Arc<CycleData>,
    value: Value,
}

impl Part {
    pub(super) fn key(&self) -> Key {
        match self.value {
            Value::Snapshot => Key::Snapshot,
            Value::Reading(index) => Key::Output(self.data.readings[index].component, self.data.readings[index].output),
            Value::Extra(index) => self.data.extras[index].key(),
        }
    }

    #[cfg(test)]
    pub(super) fn cycle(&self) -> u64 {
        self.data.cycle
    }

    /// Appends the packets.
    pub(super) fn frame(&self, packets: &mut Packets) -> Result<(), TooLarge> {
        let data = &*self.data;
        match self.value {
            Value::Snapshot => data.snapshot.messages(|message| packets.push(message)),
            Value::Reading(index) => {
                let Reading { component, output, place } = &data.readings[index];
                let bytes = place.clone().and_then(|place| data.bytes.get(place));
                packets.push(&ToMonitor::Output(OutputValue {
                    cycle: data.cycle,
                    component: *component,
                    output: *output,
                    bytes,
                }))
            }
            Value::Extra(index) => data.extras[index].messages(data.cycle, |message| packets.push_extra(message)),
        }
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// Data of a cycle with the values of outputs.
    pub(in crate::server) fn data(cycle: u64, outputs: &[u16]) -> Arc<CycleData> {
        let reading = |&output: &u16| Reading { component: 0, output, place: None };
        Arc::new(CycleData { cycle, readings: outputs.iter().map(reading).collect(), ..CycleData::default() })
    }

    #[test]
    fn memory_of_a_cycle_is_used_again() {
        let mut pool = CyclePool::default();
        let mut last = None;
        for cycle in 0..100 {
            last = pool.fill(cycle, |data| data.readings.push(Reading { component: 0, output: 0, place: None }));
        }
        assert_eq!(last.unwrap().cycle, 99);
        assert_eq!(pool.0.len(), 2, "one is filled while the last one is sent");
    }
}
