//! A monitor as the loop sees it.

use std::collections::VecDeque;
use std::sync::Arc;

use bica_wire::message::WatchInfo;

use super::connection::Connection;
use super::cycle_data::{CycleData, Shown, Watched};
use super::hub::Hub;
use super::outbox::{MAX_STATE, Message, Offered};

/// Largest number of information that a monitor watches.
const MAX_INFO: usize = 256;

/// A monitor as the loop sees it.
#[derive(Debug)]
pub(super) struct Watcher {
    pub(super) connection: Arc<Connection>,
    /// A snapshot in every n-th cycle; 0: none.
    pub(super) every: u16,
    pub(super) watched: Arc<Watched>,
    /// Messages that could not be handed over without waiting.
    messages: VecDeque<Message>,
    shown: Option<Shown>,
}

impl Watcher {
    pub(super) fn new(connection: Arc<Connection>) -> Self {
        Self { connection, every: 0, watched: Arc::default(), messages: VecDeque::new(), shown: None }
    }

    /// Changes how often an information is sent; returns whether there was room.
    pub(super) fn watch(&mut self, WatchInfo { component, info, every }: WatchInfo) -> bool {
        let key = (component, info);
        let watched = Arc::make_mut(&mut self.watched);
        if every == 0 {
            watched.remove(&key);
            return true;
        }
        let room = watched.len() < MAX_INFO || watched.contains_key(&key);
        if room {
            watched.insert(key, every);
        }
        room
    }

    /// Whether a snapshot is due in a cycle.
    pub(super) const fn is_due(&self, cycle: u64) -> bool {
        self.every > 0 && cycle.is_multiple_of(self.every as u64)
    }

    /// Adds a message for the lossless queue.
    pub(super) fn tell(&mut self, message: Message) {
        self.messages.push_back(message);
    }

    /// Adds data of a cycle for the latest-wins queue, if this monitor watches anything.
    pub(super) fn show(&mut self, data: &Arc<CycleData>, cycle: u64) {
        let snapshot = self.is_due(cycle);
        if snapshot || !self.watched.is_empty() {
            let (data, watched) = (Arc::clone(data), Arc::clone(&self.watched));
            self.shown = Some(Shown { data, snapshot, watched });
        }
    }

    /// Hands messages and data over, without waiting.
    pub(super) fn flush(&mut self, hub: &Hub) {
        if self.messages.is_empty() && self.shown.is_none() {
            return;
        }
        let offered = self.connection.offer(hub, &mut self.messages, &mut self.shown);
        // Data of this cycle is replaced by that of the next one; messages are kept.
        self.shown = None;
        if offered == Offered::Contended && self.messages.len() > MAX_STATE {
            self.connection.overflow(hub);
        }
    }
}
