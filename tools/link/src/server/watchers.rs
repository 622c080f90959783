//! All monitors, and what at least one of them watches.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::key::Key;
use super::union::Union;
use super::watcher::{MAX_WATCHED, Watcher};

/// All monitors, and what at least one of them watches.
#[derive(Debug, Default)]
pub(super) struct Watchers {
    list: Vec<Watcher>,
    union: Union,
    /// Copy of the list for the distributor, if nothing changed since.
    shared: Option<Arc<[Watcher]>>,
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
        if let Some(watcher) = self.find_mut(connection) {
            watcher.every = every;
        }
    }

    /// Sets which images a monitor gets.
    pub(super) fn watch_images(&mut self, connection: u64, every: u16) {
        if let Some(watcher) = self.find_mut(connection) {
            watcher.images = every;
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
        if let Some(last) = last {
            self.union.remove((key, last));
        }
        if every > 0 {
            self.union.add((key, every));
        }
        true
    }

    /// Removes those that are disconnected.
    pub(super) fn remove_closed(&mut self) {
        if !self.list.iter().any(|watcher| watcher.connection.is_closed()) {
            return;
        }
        self.shared = None;
        let closed: Vec<_> = self.list.extract_if(.., |watcher| watcher.connection.is_closed()).collect();
        for (&key, &every) in closed.iter().flat_map(|watcher| watcher.watched.iter()) {
            self.union.remove((key, every));
        }
    }

    /// Whether a snapshot is due for anybody.
    pub(super) fn is_snapshot_due(&self, cycle: u64) -> bool {
        self.list.iter().any(|watcher| watcher.is_due(cycle))
    }

    /// What is due for anybody, each once, sorted.
    pub(super) fn due(&self, cycle: u64) -> impl Iterator<Item = Key> {
        self.union.due(cycle)
    }

    /// Whether anybody watches it.
    pub(super) fn has(&self, key: Key) -> bool {
        self.union.has(key)
    }

    /// Whether anybody gets the image with a number.
    pub(super) fn wants_image(&self, number: u32) -> bool {
        self.list.iter().any(|watcher| watcher.wants_image(number))
    }

    /// Those of these connections that get the image with a number.
    pub(super) fn of_image(&self, number: u32, connections: &BTreeSet<u64>) -> Arc<[Watcher]> {
        let gets = |watcher: &&Watcher| connections.contains(&watcher.connection.id) && watcher.wants_image(number);
        self.list.iter().filter(gets).cloned().collect()
    }

    /// The monitors as they are now.
    pub(super) fn shared(&mut self) -> Arc<[Watcher]> {
        Arc::clone(self.shared.get_or_insert_with(|| self.list.as_slice().into()))
    }
}
