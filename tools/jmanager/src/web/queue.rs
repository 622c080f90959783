//! Queue of what a page receives.

use std::collections::{BTreeMap, VecDeque};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use axum::extract::ws::{Message, Utf8Bytes};
use tokio::sync::Notify;

use crate::protocol::ToPage;
use crate::sessions::{Frame, Key, Outbox};

/// Largest number of messages of state that wait.
const MAX_STATE: usize = 1024;
/// Largest size of the messages of state that wait, bytes; one larger message is accepted alone.
const MAX_STATE_BYTES: usize = 16 << 20;

/// Two queues of a page. State is lossless and bounded: if it is full the page is disconnected, and is right again after it has
/// connected anew. Of data only the latest frame of each kind waits, so a slow page gets fewer of them.
#[derive(Default)]
pub struct Queue {
    waiting: Mutex<Waiting>,
    changed: Notify,
}

#[derive(Default)]
struct Waiting {
    state: VecDeque<Message>,
    state_bytes: usize,
    /// Kinds of data in the order in which they are sent: a kind that is replaced keeps its place.
    order: VecDeque<Key>,
    data: BTreeMap<Key, Frame>,
    overflowed: bool,
}

impl Queue {
    /// Returns the next message; state goes first.
    #[must_use]
    pub fn pop(&self) -> Option<Message> {
        let mut waiting = self.waiting();
        if let Some(message) = waiting.state.pop_front() {
            waiting.state_bytes -= size(&message);
            return Some(message);
        }
        let key = waiting.order.pop_front()?;
        waiting.data.remove(&key).map(message)
    }

    /// Whether state was lost because the page did not read it.
    #[must_use]
    pub fn overflowed(&self) -> bool {
        self.waiting().overflowed
    }

    /// Waits until something was added.
    pub async fn changed(&self) {
        self.changed.notified().await;
    }

    fn waiting(&self) -> MutexGuard<'_, Waiting> {
        self.waiting.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn add(&self, message: Message) {
        let mut waiting = self.waiting();
        let bytes = size(&message);
        let full = waiting.state.len() >= MAX_STATE
            || (!waiting.state.is_empty() && waiting.state_bytes + bytes > MAX_STATE_BYTES);
        if full {
            waiting.overflowed = true;
            waiting.state.clear();
            waiting.state_bytes = 0;
        }
        if !waiting.overflowed {
            waiting.state_bytes += bytes;
            waiting.state.push_back(message);
        }
        drop(waiting);
        self.changed.notify_one();
    }
}

impl Outbox for Queue {
    fn state(&self, message: ToPage) {
        // Serialization into memory fails only for maps with keys that are no strings, and the protocol has none.
        self.add(Message::Text(serde_json::to_string(&message).unwrap_or_default().into()));
    }

    fn binary(&self, frame: Arc<[u8]>) {
        self.add(Message::Binary(frame.to_vec().into()));
    }

    fn data(&self, key: Key, frame: Frame) {
        let mut waiting = self.waiting();
        if waiting.data.insert(key, frame).is_none() {
            waiting.order.push_back(key);
        }
        drop(waiting);
        self.changed.notify_one();
    }
}

fn message(frame: Frame) -> Message {
    match frame {
        Frame::Text(text) => Message::Text(Utf8Bytes::from(&*text)),
        Frame::Binary(bytes) => Message::Binary(bytes.to_vec().into()),
    }
}

fn size(message: &Message) -> usize {
    match message {
        Message::Text(text) => text.len(),
        Message::Binary(bytes) => bytes.len(),
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sessions::DataKind;

    fn text(queue: &Queue) -> Option<String> {
        queue.pop().map(|message| message.into_text().unwrap().to_string())
    }

    #[test]
    fn data_are_replaced_and_state_is_not() {
        let queue = Queue::default();
        let key = |kind| Key { session: 1, kind };
        let frame = |text: &str| Frame::Text(text.into());
        queue.data(key(DataKind::Update), frame("old update"));
        queue.data(key(DataKind::Costs), frame("costs"));
        queue.data(key(DataKind::Update), frame("update"));
        queue.state(ToPage::Closed { session: 1 });
        queue.state(ToPage::Closed { session: 2 });
        assert_eq!(text(&queue).unwrap(), r#"{"type":"closed","session":1}"#);
        assert_eq!(text(&queue).unwrap(), r#"{"type":"closed","session":2}"#);
        assert_eq!(text(&queue).unwrap(), "update");
        assert_eq!(text(&queue).unwrap(), "costs");
        assert_eq!(text(&queue), None);
        assert!(!queue.overflowed());
    }

    #[test]
    fn a_page_that_does_not_read_its_state_overflows_within_bounds() {
        let queue = Queue::default();
        for session in 0..MAX_STATE as u32 {
            queue.state(ToPage::Closed { session });
        }
        assert!(!queue.overflowed());
        queue.state(ToPage::Closed { session: 0 });
        assert!(queue.overflowed());
        assert_eq!(text(&queue), None);
    }

    #[test]
    fn state_is_bounded_in_bytes() {
        let queue = Queue::default();
        queue.binary(vec![0; MAX_STATE_BYTES + 1].into());
        assert!(!queue.overflowed());
        queue.binary(vec![0; 1].into());
        assert!(queue.overflowed());
    }
}
