//! Samples of outputs.

use std::collections::{BTreeMap, VecDeque};

use serde_json::Value;

/// Memory of a sample besides its value, bytes.
const SAMPLE_BYTES: usize = 32;

/// Samples of one output. A value that did not change is stored once.
#[derive(Debug, Default)]
struct Samples {
    /// Time, µs, and value in postcard's format; empty if it is too large.
    changes: VecDeque<(u64, Box<[u8]>)>,
    /// Time of the newest sample, µs, also if its value did not change.
    last_us: u64,
    /// Whether the next sample is stored even if it did not change.
    interrupted: bool,
}

/// Samples of all outputs.
#[derive(Debug, Default)]
pub(crate) struct OutputStore {
    all: BTreeMap<(usize, usize), Samples>,
    bytes: usize,
}

impl OutputStore {
    /// Adds a sample; times do not decrease.
    pub(crate) fn push(&mut self, component: usize, output: usize, time_us: u64, value: &[u8]) {
        let samples = self.all.entry((component, output)).or_default();
        samples.last_us = time_us;
        let is_new = samples.changes.back().is_none_or(|(_, last)| **last != *value);
        if std::mem::take(&mut samples.interrupted) || is_new {
            self.bytes += SAMPLE_BYTES + value.len();
            samples.changes.push_back((time_us, value.into()));
        }
    }

    /// Begins a gap: stores the newest sample of each output, and the next one, also if the value did not change, because nothing
    /// is known between them.
    pub(super) fn interrupt(&mut self) {
        for samples in self.all.values_mut() {
            samples.interrupted = true;
            let last = samples.changes.back().filter(|(time, _)| *time < samples.last_us);
            if let Some(value) = last.map(|(_, value)| value.clone()) {
                self.bytes += SAMPLE_BYTES + value.len();
                samples.changes.push_back((samples.last_us, value));
            }
        }
    }

    /// Returns time, µs, and value of the last stored sample that is not later.
    pub(crate) fn at(&self, component: usize, output: usize, time_us: u64) -> Option<(u64, &[u8])> {
        let changes = &self.all.get(&(component, output))?.changes;
        let end = changes.partition_point(|(time, _)| *time <= time_us);
        changes.get(end.checked_sub(1)?).map(|(time, value)| (*time, &**value))
    }

    /// Returns the samples of an interval: the value at its beginning, the changes in it, and the value at its end; thinned to at
    /// most `points`. Thinning keeps the smallest and the largest number of each part; of other values it keeps the last one.
    pub(crate) fn series(
        &self,
        component: usize,
        output: usize,
        from_us: u64,
        until_us: u64,
        points: usize,
        decode: impl Fn(&[u8]) -> Value,
    ) -> Vec<(u64, Value)> {
        let Some(samples) = self.all.get(&(component, output)) else { return Vec::new() };
        let changes = &samples.changes;
        let begin = changes.partition_point(|(time, _)| *time < from_us);
        let end = changes.partition_point(|(time, _)| *time <= until_us).max(begin);
        let before = begin.checked_sub(1).map(|index| (from_us, decode(&changes[index].1)));
        let inside = changes.range(begin..end).map(|(time, value)| (*time, decode(value)));
        let mut all: Vec<(u64, Value)> = before.into_iter().chain(inside).collect();
        let last = samples.last_us.min(until_us);
        if let Some((time, value)) = all.last().filter(|(time, _)| *time < last).cloned() {
            debug_assert!(time < last);
            all.push((last, value));
        }
        thin(all, points)
    }

    /// Returns time, component, index and value of the changes after a time and up to another one, in the order of time. If an
    /// output did not change up to its last sample, or up to `until_us`, its value is repeated at that time. Without `after_us` the
    /// first value of each output may be older than the history.
    pub(super) fn part(
        &self,
        after_us: Option<u64>,
        last_us: u64,
        until_us: u64,
    ) -> Vec<(u64, usize, usize, Box<[u8]>)> {
        let mut part = Vec::new();
        for (&(component, output), samples) in &self.all {
            let changes = &samples.changes;
            let begin = after_us.map_or(0, |after| changes.partition_point(|(time, _)| *time <= after));
            let inside = changes.range(begin..).take_while(|(time, _)| *time <= last_us);
            part.extend(inside.map(|(time, value)| (*time, component, output, value.clone())));
            let end = samples.last_us.min(until_us);
            let index = changes.partition_point(|(time, _)| *time <= end).checked_sub(1);
            let newest = index.and_then(|index| changes.get(index)).filter(|(time, _)| *time < end);
            if let Some((_, value)) = newest.filter(|_| end <= last_us && after_us.is_none_or(|after| end > after)) {
                part.push((end, component, output, value.clone()));
            }
        }
        part.sort_by_key(|(time, ..)| *time);
        part
    }

    pub(super) fn evict(&mut self, horizon: u64) {
        for samples in self.all.values_mut() {
            // The last value before the horizon is the value at the horizon.
            while samples.changes.get(1).is_some_and(|(time, _)| *time <= horizon) {
                if let Some((_, value)) = samples.changes.pop_front() {
                    self.bytes -= SAMPLE_BYTES + value.len();
                }
            }
        }
    }

    /// Returns the memory of all samples, bytes.
    pub(crate) const fn bytes(&self) -> usize {
        self.bytes
    }
}

fn thin(all: Vec<(u64, Value)>, points: usize) -> Vec<(u64, Value)> {
    let points = points.max(2);
    if all.len() <= points {
        return all;
    }
    let part = all.len().div_ceil((points / 2).max(1));
    let mut thinned = Vec::with_capacity(points);
    for part in all.chunks(part) {
        let number = |index: usize| part[index].1.as_f64();
        if part.iter().any(|(_, value)| !value.is_number()) {
            thinned.extend(part.last().cloned());
            continue;
        }
        let by = |a: &usize, b: &usize| number(*a).partial_cmp(&number(*b)).unwrap_or(std::cmp::Ordering::Equal);
        let (low, high) = ((0..part.len()).min_by(by), (0..part.len()).max_by(by));
        let mut both: Vec<usize> = low.into_iter().chain(high).collect();
        both.sort_unstable();
        both.dedup();
        thinned.extend(both.into_iter().map(|index| part[index].clone()));
    }
    thinned
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    /// Values between two times.
    fn series(store: &OutputStore, from_us: u64, until_us: u64, points: usize) -> Vec<(u64, Value)> {
        store.series(1, 2, from_us, until_us, points, |value| json!(value[0]))
    }

    fn store(values: &[(u64, u8)]) -> OutputStore {
        let mut store = OutputStore::default();
        for &(time, value) in values {
            store.push(1, 2, time, &[value]);
        }
        store
    }

    #[test]
    fn the_last_sample_that_is_not_later_is_found() {
        let store = store(&[(10, 1), (20, 1), (30, 2)]);
        assert_eq!(store.at(1, 2, 9), None);
        assert_eq!(store.at(1, 2, 29), Some((10, &[1][..])));
        assert_eq!(store.at(1, 2, 30), Some((30, &[2][..])));
        assert_eq!(store.at(1, 3, 30), None);
    }

    #[test]
    fn series_has_the_values_at_both_ends() {
        let store = store(&[(10, 1), (20, 2), (30, 3), (40, 3)]);
        assert_eq!(series(&store, 15, 25, 10), [(15, json!(1)), (20, json!(2)), (25, json!(2))]);
        assert_eq!(series(&store, 0, 99, 10), [(10, json!(1)), (20, json!(2)), (30, json!(3)), (40, json!(3))]);
    }

    #[test]
    fn a_peak_survives_thinning() {
        let values: Vec<_> = (0..1000).map(|time| (time, if time == 777 { 50 } else { (time % 2) as u8 })).collect();
        let series = series(&store(&values), 0, 999, 20);
        assert!(series.len() <= 20, "{}", series.len());
        assert!(series.contains(&(777, json!(50))));
    }

    #[test]
    fn memory_is_freed_up_to_the_horizon() {
        let mut store = store(&[(10, 1), (20, 2), (30, 3)]);
        let before = store.bytes();
        store.evict(25);
        assert_eq!(store.at(1, 2, 25), Some((20, &[2][..])));
        assert_eq!(store.at(1, 2, 15), None);
        assert_eq!(store.bytes(), before - SAMPLE_BYTES - 1);
    }
}
