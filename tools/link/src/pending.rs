//! Queue for one of many clients.

use std::collections::{HashMap, VecDeque};
use std::hash::Hash;

/// Largest number of messages that wait. A client that leaves more unread is disconnected.
const MAX_MESSAGES: usize = 1024;
/// Largest size of the messages that wait, bytes; one larger message is accepted alone.
const MAX_BYTES: usize = 16 << 20;

/// Queue for one of many clients: messages `M`, none of which is lost silently, and the newest data `D` of each key.
///
/// A client that does not read its messages overflows and is disconnected; after it has connected again, it is up to date. A slow
/// client gets data less often. So no client delays another one, and the memory for each client is bounded.
#[derive(Debug)]
pub struct Pending<M, K, D> {
    messages: VecDeque<(M, usize)>,
    bytes: usize,
    overflowed: bool,
    /// Keys in the order in which their data is sent: data that is replaced keeps its place.
    order: VecDeque<K>,
    data: HashMap<K, D>,
}

impl<M, K, D> Default for Pending<M, K, D> {
    fn default() -> Self {
        let (messages, order) = (VecDeque::new(), VecDeque::new());
        Self { messages, bytes: 0, overflowed: false, order, data: HashMap::new() }
    }
}

impl<M, K: Copy + Eq + Hash, D> Pending<M, K, D> {
    /// Adds a message of a size in bytes that must not be lost; returns whether there was room. Without room all messages are dropped:
    /// the client is to be disconnected.
    pub fn push(&mut self, message: M, bytes: usize) -> bool {
        let is_full =
            self.messages.len() >= MAX_MESSAGES || (!self.messages.is_empty() && self.bytes + bytes > MAX_BYTES);
        if is_full {
            (self.overflowed, self.bytes) = (true, 0);
            self.messages.clear();
        }
        if !self.overflowed {
            self.bytes += bytes;
            self.messages.push_back((message, bytes));
        }
        !self.overflowed
    }

    /// Adds data. If older data with the same key was not taken yet, `replacing` combines the newer and the older data.
    pub fn show(&mut self, key: K, data: D, replacing: impl FnOnce(D, D) -> D) {
        let data = if let Some(older) = self.data.remove(&key) {
            replacing(data, older)
        } else {
            self.order.push_back(key);
            data
        };
        self.data.insert(key, data);
    }

    /// Takes the oldest message.
    pub fn message(&mut self) -> Option<M> {
        let (message, bytes) = self.messages.pop_front()?;
        self.bytes -= bytes;
        Some(message)
    }

    /// Takes the data that has waited for the longest time.
    pub fn data(&mut self) -> Option<D> {
        self.data.remove(&self.order.pop_front()?)
    }

    /// Returns the number of messages that wait.
    #[must_use]
    pub fn messages(&self) -> usize {
        self.messages.len()
    }

    /// Returns whether nothing waits.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.messages.is_empty() && self.order.is_empty()
    }

    /// Returns whether messages were dropped because the client did not read them.
    #[must_use]
    pub const fn overflowed(&self) -> bool {
        self.overflowed
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const NEWER: fn(u32, u32) -> u32 = |newer, _| newer;

    #[test]
    fn data_are_replaced_and_messages_are_not() {
        let mut pending = Pending::default();
        for (key, data) in [('a', 1), ('b', 2), ('a', 3)] {
            pending.show(key, data, NEWER);
        }
        assert!(pending.push("one", 3) && pending.push("two", 3));
        assert_eq!([pending.message(), pending.message(), pending.message()], [Some("one"), Some("two"), None]);
        assert_eq!([pending.data(), pending.data(), pending.data()], [Some(3), Some(2), None]);
        assert!(pending.is_empty() && !pending.overflowed());
    }

    #[test]
    fn client_that_does_not_read_overflows_in_bounds() {
        let mut pending = Pending::<usize, (), ()>::default();
        assert!((0..MAX_MESSAGES).all(|message| pending.push(message, 0)));
        assert!(!pending.push(0, 0) && pending.overflowed());
        assert_eq!(pending.message(), None);
        let mut pending = Pending::<usize, (), ()>::default();
        assert!(pending.push(0, MAX_BYTES + 1));
        assert!(!pending.push(0, 1));
    }
}
