//! Messages with the data of one cycle, shared by all monitors.

use std::collections::HashMap;
use std::ops::Range;
use std::sync::Arc;

use bica_wire::{FromRobot, TooLarge};

use super::key::Key;
use crate::frame::Packets;

/// What is watched, with n for every n-th cycle.
pub(super) type Watched = HashMap<Key, u16>;

/// Messages with the data of one cycle.
#[derive(Debug, Default)]
pub(super) struct Encoded {
    pub(super) cycle: u64,
    /// Places of the messages of the snapshot; none if it is due for nobody.
    pub(super) snapshot: Vec<Range<usize>>,
    pub(super) readings: Vec<EncodedReading>,
    pub(super) bytes: Vec<u8>,
}

impl Encoded {
    /// Whether there is a snapshot: the true state of a cycle comes alone.
    pub(super) const fn has_snapshot(&self) -> bool {
        !self.snapshot.is_empty()
    }
}

/// Messages of something that is watched.
#[derive(Debug)]
pub(super) struct EncodedReading {
    pub(super) key: Key,
    /// Places of its messages.
    pub(super) places: Vec<Range<usize>>,
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

    /// Appends the packets.
    pub(super) fn frame(&self, packets: &mut Packets) -> Result<(), TooLarge> {
        let data = &self.data;
        let Some(index) = self.reading else {
            return data.snapshot.iter().try_for_each(|place| packets.push_encoded(&data.bytes[place.clone()]));
        };
        let EncodedReading { key, places } = &data.readings[index];
        places.iter().try_for_each(|place| {
            let bytes = &data.bytes[place.clone()];
            match key {
                Key::Info(..) => packets.push_encoded(bytes),
                _ => packets.push_robot(&FromRobot::MonitorExtra(bytes)),
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pending::Pending;

    /// Data of a cycle with the values of these outputs.
    fn encoded(cycle: u64, outputs: &[u16]) -> Arc<Encoded> {
        let reading = |&info: &u16| EncodedReading { key: Key::Info(0, info), places: Vec::new() };
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
