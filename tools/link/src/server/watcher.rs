//! A monitor as the loop sees it.

use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::sync::Arc;

use bica_wire::message::WatchInfo;

use super::connection::Connection;
use super::hub::Hub;
use super::outbox::{Data, MAX_STATE, Message, Offered};

/// Largest number of information that a monitor watches.
const MAX_INFO: usize = 256;

/// A monitor as the loop sees it.
#[derive(Debug)]
pub(super) struct Watcher {
    pub(super) connection: Arc<Connection>,
    /// A snapshot in every n-th cycle; 0: none.
    pub(super) every: u16,
    /// Watched information, with n for every n-th cycle.
    pub(super) info: BTreeMap<(u16, u16), u16>,
    /// Information whose schema was sent.
    schemas: BTreeSet<(u16, u16)>,
    /// Messages and data that could not be handed over without waiting.
    messages: VecDeque<Message>,
    data: Vec<Data>,
}

impl Watcher {
    pub(super) fn new(connection: Arc<Connection>) -> Self {
        let (info, schemas) = (BTreeMap::new(), BTreeSet::new());
        Self { connection, every: 0, info, schemas, messages: VecDeque::new(), data: Vec::new() }
    }

    /// Changes how often an information is sent; returns whether there was room.
    pub(super) fn watch(&mut self, WatchInfo { component, info, every }: WatchInfo) -> bool {
        let key = (component, info);
        if every == 0 {
            self.info.remove(&key);
            return true;
        }
        let room = self.info.len() < MAX_INFO || self.info.contains_key(&key);
        if room {
            self.info.insert(key, every);
        }
        room
    }

    /// Whether a snapshot is due in a cycle.
    pub(super) const fn is_due(&self, cycle: u64) -> bool {
        self.every > 0 && cycle.is_multiple_of(self.every as u64)
    }

    /// Records that the schema of an information is sent; returns whether it was not before.
    pub(super) fn needs_schema(&mut self, component: u16, info: u16) -> bool {
        self.schemas.insert((component, info))
    }

    /// Adds a message for the lossless queue.
    pub(super) fn tell(&mut self, message: Message) {
        self.messages.push_back(message);
    }

    /// Adds data for the latest-wins queue.
    pub(super) fn show(&mut self, data: Data) {
        self.data.push(data);
    }

    /// Hands messages and data over, without waiting.
    pub(super) fn flush(&mut self, hub: &Hub) {
        if self.messages.is_empty() && self.data.is_empty() {
            return;
        }
        let offered = self.connection.offer(hub, &mut self.messages, &mut self.data);
        // Data of this cycle is replaced by that of the next one; messages are kept.
        self.data.clear();
        if offered == Offered::Contended && self.messages.len() > MAX_STATE {
            self.connection.overflow(hub);
        }
    }
}
