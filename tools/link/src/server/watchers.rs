//! All monitors, and what at least one of them watches.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use super::key::Key;
use super::watcher::{MAX_WATCHED, Watcher};

/// All monitors, and what at least one of them watches.
#[derive(Debug, Default)]
pub(super) struct Watchers {
    list: Vec<Watcher>,
    /// Copy of the list for the distributor, if nothing changed since.
    shared: Option<Arc<[Watcher]>>,
    /// What monitors have not got since they watch it. It is sent when it is due, or when the world is paused.
    owed: HashMap<u64, Owed>,
}

/// What a monitor has not got since it watches it.
#[derive(Debug, Default)]
struct Owed {
    snapshot: bool,
    keys: HashSet<Key>,
}

impl Watchers {
    pub(super) fn iter(&self) -> impl Iterator<Item = &Watcher> {
        self.list.iter()
    }

    pub(super) fn find(&self, connection: u64) -> Option<&Watcher> {
        self.list.iter().find(|watcher| watcher.connection.id == connection)
    }

    fn find_mut(&mut self, connection: u64) -> Option<&mut Watcher> {
        self.shared = None;
        self.list.iter_mut().find(|watcher| watcher.connection.id == connection)
    }

    pub(super) fn add(&mut self, watcher: Watcher) {
        self.shared = None;
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

    /// Sets how often a monitor gets something; returns whether there was room.
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

    /// A cycle was sent: what was due in it is not owed any more.
    pub(super) fn settle(&mut self, cycle: u64) {
        let Self { list, owed, .. } = self;
        owed.retain(|connection, owed| {
            let Some(watcher) = list.iter().find(|one| one.connection.id == *connection) else { return false };
            owed.snapshot &= !watcher.is_due(cycle);
            owed.keys.retain(|&key| !watcher.is_key_due(key, cycle));
            owed.snapshot || !owed.keys.is_empty()
        });
    }

    /// No cycle follows for now: everything that was not due in the last one is owed.
    pub(super) fn owe_rest(&mut self, cycle: u64) {
        for watcher in &self.list {
            let owed = self.owed.entry(watcher.connection.id).or_default();
            owed.snapshot |= watcher.every > 0 && !watcher.is_due(cycle);
            let not_due = |key: &&Key| **key != Key::Costs && !watcher.is_key_due(**key, cycle);
            owed.keys.extend(watcher.watched.keys().filter(not_due));
        }
    }

    /// The true state has changed between two cycles.
    pub(super) fn owe_truth(&mut self) {
        for watcher in self.list.iter().filter(|watcher| watcher.watched.contains_key(&Key::Truth)) {
            self.owed.entry(watcher.connection.id).or_default().keys.insert(Key::Truth);
        }
    }

    /// The monitors that are owed the true state, and nothing else; they are owed it no more.
    pub(super) fn take_owed_truth(&mut self) -> Arc<[Watcher]> {
        let Self { list, owed, .. } = self;
        let owed_to =
            |watcher: &&Watcher| owed.get_mut(&watcher.connection.id).is_some_and(|owed| owed.keys.remove(&Key::Truth));
        let only = |watcher: &Watcher| watcher.only(false, [Key::Truth]);
        list.iter().filter(owed_to).map(only).collect()
    }

    /// What is owed but the true state, as monitors that watch just that in each cycle; it is owed no more.
    pub(super) fn take_owed(&mut self) -> Arc<[Watcher]> {
        let Self { list, owed, .. } = self;
        let take = |watcher: &Watcher| {
            let owed = owed.get_mut(&watcher.connection.id)?;
            let keys: Vec<Key> = owed.keys.extract_if(|key| *key != Key::Truth).collect();
            let snapshot = std::mem::take(&mut owed.snapshot);
            (snapshot || !keys.is_empty()).then(|| watcher.only(snapshot, keys))
        };
        list.iter().filter_map(take).collect()
    }

    /// Removes those that are disconnected; returns their connections.
    pub(super) fn remove_closed(&mut self) -> Vec<u64> {
        if !self.list.iter().any(|watcher| watcher.connection.is_closed()) {
            return Vec::new();
        }
        self.shared = None;
        let closed: Vec<_> = self.list.extract_if(.., |watcher| watcher.connection.is_closed()).collect();
        let forget = |watcher: Watcher| {
            self.owed.remove(&watcher.connection.id);
            watcher.connection.id
        };
        closed.into_iter().map(forget).collect()
    }

    /// Whether a snapshot is due for anybody.
    pub(super) fn is_snapshot_due(&self, cycle: u64) -> bool {
        self.list.iter().any(|watcher| watcher.is_due(cycle))
    }

    /// Finds what is due for anybody, each once, sorted.
    pub(super) fn find_due(&self, cycle: u64, due: &mut Vec<Key>) {
        let watched = self.list.iter().flat_map(|watcher| watcher.watched.iter());
        due.clear();
        due.extend(watched.filter(|(_, every)| cycle.is_multiple_of(u64::from(**every))).map(|(key, _)| *key));
        due.sort_unstable();
        due.dedup();
    }

    /// Whether something is due for anybody.
    pub(super) fn is_due(&self, key: Key, cycle: u64) -> bool {
        self.list.iter().any(|watcher| watcher.is_key_due(key, cycle))
    }

    /// Whether anybody watches it.
    pub(super) fn has(&self, key: Key) -> bool {
        self.list.iter().any(|watcher| watcher.watched.contains_key(&key))
    }

    /// Those that get the image with a number, in a world that `stands` still or does not.
    pub(super) fn of_image(&self, number: u32, stands: bool) -> Arc<[Watcher]> {
        self.list.iter().filter(|watcher| watcher.wants_image(number, stands)).cloned().collect()
    }

    /// Whether somebody watches images, ready for the next one or not.
    pub(super) fn wants_images(&self) -> bool {
        self.list.iter().any(|watcher| watcher.images > 0)
    }

    /// The monitors as they are now.
    pub(super) fn shared(&mut self) -> Arc<[Watcher]> {
        Arc::clone(self.shared.get_or_insert_with(|| self.list.as_slice().into()))
    }
}
