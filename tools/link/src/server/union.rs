//! What at least one monitor watches.

use std::collections::BTreeMap;

/// Component and index of an information, and n for every n-th cycle.
pub(super) type Entry = ((u16, u16), u16);

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

    /// Information that is due in a cycle, each once, sorted.
    pub(super) fn due(&self, cycle: u64) -> impl Iterator<Item = (u16, u16)> {
        let due = self.0.keys().filter(move |(_, every)| cycle.is_multiple_of((*every).into()));
        let mut last = None;
        due.filter_map(move |&(key, _)| (last.replace(key) != Some(key)).then_some(key))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn due(union: &Union, cycle: u64) -> Vec<(u16, u16)> {
        union.due(cycle).collect()
    }

    #[test]
    fn each_information_is_due_once_however_many_watch_it() {
        let mut union = Union::default();
        for entry in [((2, 0), 1), ((1, 5), 3), ((1, 5), 2), ((1, 5), 3)] {
            union.add(entry);
        }
        assert_eq!(due(&union, 0), [(1, 5), (2, 0)]);
        assert_eq!(due(&union, 1), [(2, 0)]);
        assert_eq!(due(&union, 2), [(1, 5), (2, 0)]);
        assert_eq!(due(&union, 3), [(1, 5), (2, 0)]);
    }

    #[test]
    fn information_is_read_until_its_last_monitor_leaves() {
        let mut union = Union::default();
        union.add(((1, 5), 3));
        union.add(((1, 5), 3));
        union.add(((1, 5), 2));
        union.remove(((1, 5), 3));
        assert_eq!(due(&union, 3), [(1, 5)]);
        union.remove(((1, 5), 3));
        assert_eq!(due(&union, 3), []);
        assert_eq!(due(&union, 2), [(1, 5)]);
        union.remove(((1, 5), 2));
        union.remove(((1, 5), 2));
        assert_eq!(due(&union, 6), []);
    }
}
