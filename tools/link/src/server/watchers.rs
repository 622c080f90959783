//! All monitors, and the data that at least one of them watches.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use super::cycle_data::{CycleData, Due, Watched};
use super::key::Key;
use super::watcher::{MAX_WATCHED, Watcher};
use crate::image::Image;

/// All monitors, and the data that at least one of them watches.
#[derive(Debug, Default)]
pub(super) struct Watchers {
    list: Vec<Watcher>,
    /// Data that monitors have not received since they began to watch them. They are sent when they are due, or when the world is
    /// paused.
    owed: HashMap<u64, Owed>,
}

/// Data that a monitor has not received since it began to watch them.
#[derive(Debug, Default)]
struct Owed {
    snapshot: bool,
    keys: HashSet<Key>,
}

/// Owed data that are sent to a monitor.
pub(super) struct OwedTo {
    connection: u64,
    pub(super) snapshot: bool,
    pub(super) keys: Arc<Watched>,
}

impl Watchers {
    pub(super) fn iter(&self) -> impl Iterator<Item = &Watcher> {
        self.list.iter()
    }

    pub(super) fn iter_mut(&mut self) -> impl Iterator<Item = &mut Watcher> {
        self.list.iter_mut()
    }

    pub(super) fn find(&self, connection: u64) -> Option<&Watcher> {
        self.list.iter().find(|watcher| watcher.connection.id == connection)
    }

    pub(super) fn find_mut(&mut self, connection: u64) -> Option<&mut Watcher> {
        self.list.iter_mut().find(|watcher| watcher.connection.id == connection)
    }

    pub(super) fn add(&mut self, watcher: Watcher) {
        self.list.push(watcher);
    }

    /// Sets how often a monitor gets a snapshot.
    pub(super) fn watch(&mut self, connection: u64, every: u16) {
        let Some(watcher) = self.find_mut(connection) else { return };
        if watcher.every != every {
            watcher.every = every;
            self.owed.entry(connection).or_default().snapshot = every > 0;
        }
    }

    /// Sets which images a monitor gets.
    pub(super) fn watch_images(&mut self, connection: u64, every: u16) {
        if let Some(watcher) = self.find_mut(connection) {
            watcher.images = every;
            watcher.connection.forget_image();
        }
    }

    /// Sets how often a monitor gets the data of a key; returns whether there was room.
    pub(super) fn watch_key(&mut self, connection: u64, (key, every): (Key, u16)) -> bool {
        let Some(watcher) = self.find_mut(connection) else { return true };
        let room = watcher.watched.len() < MAX_WATCHED || watcher.watched.contains_key(&key);
        if every > 0 && !room {
            return false;
        }
        let watched = Arc::make_mut(&mut watcher.watched);
        let last = if every == 0 { watched.remove(&key) } else { watched.insert(key, every) };
        let owed = &mut self.owed.entry(connection).or_default().keys;
        // Costs are those of a window, not a state.
        if every == 0 || key == Key::Costs {
            owed.remove(&key);
        } else if last != Some(every) {
            owed.insert(key);
        }
        true
    }

    /// Removes the data that were due in a sent cycle from the owed data.
    pub(super) fn settle(&mut self, cycle: u64) {
        let Self { list, owed, .. } = self;
        owed.retain(|connection, owed| {
            let Some(watcher) = list.iter().find(|one| one.connection.id == *connection) else { return false };
            owed.snapshot &= !watcher.is_due(cycle);
            owed.keys.retain(|&key| !watcher.is_key_due(key, cycle));
            owed.snapshot || !owed.keys.is_empty()
        });
    }

    /// Adds all data that were not due in the last cycle to the owed data, because no cycle follows for now.
    pub(super) fn owe_rest(&mut self, cycle: u64) {
        for watcher in &self.list {
            let owed = self.owed.entry(watcher.connection.id).or_default();
            owed.snapshot |= watcher.every > 0 && !watcher.is_due(cycle);
            let not_due = |key: &&Key| **key != Key::Costs && !watcher.is_key_due(**key, cycle);
            owed.keys.extend(watcher.watched.keys().filter(not_due));
        }
    }

    /// Adds the true state to the owed data, because it has changed between two cycles.
    pub(super) fn owe_truth(&mut self) {
        for watcher in self.list.iter().filter(|watcher| watcher.watched.contains_key(&Key::Truth)) {
            self.owed.entry(watcher.connection.id).or_default().keys.insert(Key::Truth);
        }
    }

    /// Takes the true state that monitors are owed.
    pub(super) fn take_owed_truth(&mut self) -> Vec<OwedTo> {
        let truth = Arc::new(Watched::from([(Key::Truth, 1)]));
        let Self { list, owed, .. } = self;
        let owed_to =
            |watcher: &&Watcher| owed.get_mut(&watcher.connection.id).is_some_and(|owed| owed.keys.remove(&Key::Truth));
        let list = list.iter().filter(owed_to);
        list.map(|watcher| OwedTo { connection: watcher.connection.id, snapshot: false, keys: Arc::clone(&truth) })
            .collect()
    }

    /// Takes the owed data of all monitors, except the true state.
    pub(super) fn take_owed(&mut self) -> Vec<OwedTo> {
        let Self { list, owed, .. } = self;
        let take = |watcher: &Watcher| {
            let connection = watcher.connection.id;
            let owed = owed.get_mut(&connection)?;
            let keys: Watched = owed.keys.extract_if(|key| *key != Key::Truth).map(|key| (key, 1)).collect();
            let snapshot = std::mem::take(&mut owed.snapshot);
            (snapshot || !keys.is_empty()).then(|| OwedTo { connection, snapshot, keys: Arc::new(keys) })
        };
        list.iter().filter_map(take).collect()
    }

    /// Sends what is due in a cycle to each monitor.
    pub(super) fn send(&mut self, data: &Arc<CycleData>) {
        for watcher in &mut self.list {
            let snapshot = !data.snapshot.is_empty() && watcher.is_due(data.cycle);
            if snapshot || !watcher.watched.is_empty() {
                let (data, watched) = (Arc::clone(data), Arc::clone(&watcher.watched));
                watcher.unsent.data.push_back(Due { data, snapshot, watched });
            }
        }
    }

    /// Sends owed data to their monitors.
    pub(super) fn send_owed(&mut self, data: &Arc<CycleData>, owed: Vec<OwedTo>) {
        for OwedTo { connection, snapshot, keys } in owed {
            if let Some(watcher) = self.find_mut(connection) {
                watcher.unsent.data.push_back(Due { data: Arc::clone(data), snapshot, watched: keys });
            }
        }
    }

    /// Sends an image to the monitors that get it; `stands` is whether the world stands still.
    pub(super) fn send_image(&mut self, image: &Image, stands: bool) {
        for watcher in self.list.iter_mut().filter(|watcher| watcher.wants_image(image.number, stands)) {
            watcher.connection.shows_image(image.number);
            watcher.unsent.image = Some(image.clone());
        }
    }

    /// Hands everything over to the writers.
    pub(super) fn hand_over(&mut self) {
        for Watcher { connection, unsent, .. } in self.list.iter_mut().filter(|watcher| !watcher.unsent.is_empty()) {
            connection.offer(unsent);
        }
    }

    /// Removes the disconnected monitors; returns their connections.
    pub(super) fn remove_closed(&mut self) -> Vec<u64> {
        if !self.list.iter().any(|watcher| watcher.connection.is_closed()) {
            return Vec::new();
        }
        let closed: Vec<_> = self.list.extract_if(.., |watcher| watcher.connection.is_closed()).collect();
        let forget = |watcher: Watcher| {
            self.owed.remove(&watcher.connection.id);
            watcher.connection.id
        };
        closed.into_iter().map(forget).collect()
    }

    /// Returns whether a snapshot is due for any monitor.
    pub(super) fn is_snapshot_due(&self, cycle: u64) -> bool {
        self.list.iter().any(|watcher| watcher.is_due(cycle))
    }

    /// Collects the keys that are due for any monitor, sorted, without duplicates.
    pub(super) fn find_due(&self, cycle: u64, due: &mut Vec<Key>) {
        let watched = self.list.iter().flat_map(|watcher| watcher.watched.iter());
        due.clear();
        due.extend(watched.filter(|(_, every)| cycle.is_multiple_of(u64::from(**every))).map(|(key, _)| *key));
        due.sort_unstable();
        due.dedup();
    }

    /// Returns whether the data of a key are due for any monitor.
    pub(super) fn is_due(&self, key: Key, cycle: u64) -> bool {
        self.list.iter().any(|watcher| watcher.is_key_due(key, cycle))
    }

    /// Returns whether any monitor watches the data of a key.
    pub(super) fn has(&self, key: Key) -> bool {
        self.list.iter().any(|watcher| watcher.watched.contains_key(&key))
    }

    /// Returns whether any monitor watches images, ready for the next one or not.
    pub(super) fn wants_images(&self) -> bool {
        self.list.iter().any(|watcher| watcher.images > 0)
    }
}
