//! What at least one monitor watches.

use std::collections::BTreeMap;

use super::key::Key;

/// What is watched, and n for every n-th cycle.
pub(super) type Entry = (Key, u16);

/// Number of monitors that watch each entry.
#[derive(Debug, Default)]
pub(super) struct Union(BTreeMap<Entry, usize>);

impl Union {
    /// Adds a monitor to an entry.
    pub(super) fn add(&mut self, entry: Entry) {
        *self.0.entry(entry).or_default() += 1;
    }

    /// Removes a monitor from an entry.
    pub(super) fn remove(&mut self, entry: Entry) {
        if let Some(count) = self.0.get_mut(&entry) {
            *count -= 1;
            if *count == 0 {
                self.0.remove(&entry);
            }
        }
    }

    /// What is due in a cycle, each once, sorted.
    pub(super) fn due(&self, cycle: u64) -> impl Iterator<Item = Key> {
        let due = self.0.keys().filter(move |(_, every)| cycle.is_multiple_of((*every).into()));
        let mut last = None;
        due.filter_map(move |&(key, _)| (last.replace(key) != Some(key)).then_some(key))
    }

    /// Whether at least one monitor watches it.
    pub(super) fn has(&self, key: Key) -> bool {
        self.0.range((key, 0)..=(key, u16::MAX)).next().is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn due(union: &Union, cycle: u64) -> Vec<(u16, u16)> {
        let pair = |key| match key {
            Key::Info(component, info) => (component, info),
            other => panic!("{other:?} was not added"),
        };
        union.due(cycle).map(pair).collect()
    }

    const fn entry((component, info): (u16, u16), every: u16) -> Entry {
        (Key::Info(component, info), every)
    }

    #[test]
    fn each_information_is_due_once_however_many_watch_it() {
        let mut union = Union::default();
        for (key, every) in [((2, 0), 1), ((1, 5), 3), ((1, 5), 2), ((1, 5), 3)] {
            union.add(entry(key, every));
        }
        assert_eq!(due(&union, 0), [(1, 5), (2, 0)]);
        assert_eq!(due(&union, 1), [(2, 0)]);
        assert_eq!(due(&union, 2), [(1, 5), (2, 0)]);
        assert_eq!(due(&union, 3), [(1, 5), (2, 0)]);
    }

    #[test]
    fn information_is_read_until_its_last_monitor_leaves() {
        let mut union = Union::default();
        union.add(entry((1, 5), 3));
        union.add(entry((1, 5), 3));
        union.add(entry((1, 5), 2));
        union.remove(entry((1, 5), 3));
        assert_eq!(due(&union, 3), [(1, 5)]);
        assert!(union.has(Key::Info(1, 5)) && !union.has(Key::Info(1, 4)) && !union.has(Key::Costs));
        union.remove(entry((1, 5), 3));
        assert_eq!(due(&union, 3), []);
        assert_eq!(due(&union, 2), [(1, 5)]);
        union.remove(entry((1, 5), 2));
        assert!(!union.has(Key::Info(1, 5)));
        union.remove(entry((1, 5), 2));
        assert_eq!(due(&union, 6), []);
    }
}
