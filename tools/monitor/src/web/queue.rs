//! Queue of what a page receives.

use std::collections::{BTreeMap, VecDeque};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use axum::extract::ws::Message;
use tokio::sync::Notify;

use crate::pages::{Frame, Key, Outbox};
use crate::protocol::ToPage;

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
        let frame = waiting.data.remove(&key);
        drop(waiting);
        frame.map(message)
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
        self.add(text(&message));
    }

    fn binary(&self, frame: Arc<[u8]>) {
        self.add(Message::Binary(frame.to_vec().into()));
    }

    fn data(&self, key: Key, frame: Frame) {
        let mut waiting = self.waiting();
        let frame = if let Some(older) = waiting.data.remove(&key) {
            frame.replacing(older)
        } else {
            waiting.order.push_back(key);
            frame
        };
        waiting.data.insert(key, frame);
        drop(waiting);
        self.changed.notify_one();
    }
}

fn text(message: &ToPage) -> Message {
    // Serialization into memory fails only for maps with keys that are no strings, and the protocol has none.
    Message::Text(serde_json::to_string(message).unwrap_or_default().into())
}

fn message(frame: Frame) -> Message {
    match frame {
        Frame::Message(message) => text(&message),
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
    use crate::pages::DataKind;
    use crate::protocol::InfoSample;

    fn next_text(queue: &Queue) -> Option<String> {
        queue.pop().map(|message| message.into_text().unwrap().to_string())
    }

    #[test]
    fn data_are_replaced_and_state_is_not() {
        let queue = Queue::default();
        let key = |kind| Key { session: 1, kind };
        let binary = |byte: u8| Frame::Binary([byte].into());
        queue.data(key(DataKind::Image), binary(1));
        queue.data(key(DataKind::Costs), binary(2));
        queue.data(key(DataKind::Image), binary(3));
        queue.state(ToPage::Closed { session: 1 });
        queue.state(ToPage::Closed { session: 2 });
        assert_eq!(next_text(&queue).unwrap(), r#"{"type":"closed","session":1}"#);
        assert_eq!(next_text(&queue).unwrap(), r#"{"type":"closed","session":2}"#);
        assert_eq!([queue.pop().unwrap().into_data()[0], queue.pop().unwrap().into_data()[0]], [3, 2]);
        assert!(queue.pop().is_none() && !queue.overflowed());
    }

    #[test]
    fn the_only_sample_of_an_output_waits_behind_many_of_others() {
        let queue = Queue::default();
        let key = Key { session: 1, kind: DataKind::Info };
        for time_us in 0..10_000 {
            let sample = InfoSample(0, usize::from(time_us > 0), time_us, serde_json::Value::Null);
            queue.data(key, Frame::of(ToPage::Info { session: 1, samples: vec![sample] }));
        }
        let message: serde_json::Value = serde_json::from_str(&next_text(&queue).unwrap()).unwrap();
        let samples = message["samples"].as_array().unwrap();
        assert!(samples.len() <= 4096, "{}", samples.len());
        assert_eq!(
            (&samples[0][1], &samples[0][2], &samples[samples.len() - 1][2]),
            (&0.into(), &0.into(), &9999.into())
        );
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
        assert_eq!(next_text(&queue), None);
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
