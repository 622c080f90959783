//! Queue of messages to a page.

use std::sync::{Arc, Mutex};

use axum::extract::ws::Message;
use bica_link::Pending;
use tokio::sync::Notify;

use crate::pages::{Frame, Key, Outbox, lock};
use crate::protocol::ToPage;

/// Messages that wait for a page, with the same rules as those of a link's server for its monitors.
#[derive(Default)]
pub struct Queue {
    waiting: Mutex<Pending<Message, Key, Frame>>,
    changed: Notify,
}

impl Queue {
    /// Returns the next message; state precedes data.
    #[must_use]
    pub fn pop(&self) -> Option<Message> {
        let mut waiting = lock(&self.waiting);
        if let Some(message) = waiting.message() {
            return Some(message);
        }
        let frame = waiting.data();
        drop(waiting);
        frame.map(message)
    }

    /// Returns whether state was lost because the page did not read it.
    #[must_use]
    pub fn overflowed(&self) -> bool {
        lock(&self.waiting).overflowed()
    }

    /// Waits until something was added.
    pub async fn changed(&self) {
        self.changed.notified().await;
    }

    fn add(&self, message: Message, bytes: usize) {
        // The socket checks for an overflow.
        lock(&self.waiting).push(message, bytes);
        self.changed.notify_one();
    }
}

impl Outbox for Queue {
    fn state(&self, message: ToPage) {
        let text = text(&message);
        let bytes = text.len();
        self.add(Message::Text(text.into()), bytes);
    }

    fn binary(&self, frame: Arc<[u8]>) {
        self.add(Message::Binary(frame.to_vec().into()), frame.len());
    }

    fn data(&self, key: Key, frame: Frame) {
        lock(&self.waiting).show(key, frame, Frame::replacing);
        self.changed.notify_one();
    }
}

fn text(message: &ToPage) -> String {
    super::numbers::to_string(message)
}

fn message(frame: Frame) -> Message {
    match frame {
        Frame::Message(message) => Message::Text(text(&message).into()),
        Frame::Binary(bytes) => Message::Binary(bytes.to_vec().into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pages::DataKind;
    use crate::protocol::OutputSample;

    fn next_text(queue: &Queue) -> Option<String> {
        queue.pop().map(|message| message.into_text().unwrap().to_string())
    }

    #[test]
    fn only_sample_of_an_output_is_kept_among_others() {
        let queue = Queue::default();
        let key = Key { session: 1, kind: DataKind::Output };
        for time_us in 0..10_000 {
            let sample = OutputSample(0, usize::from(time_us > 0), time_us, serde_json::Value::Null);
            queue.data(key, Frame::of(ToPage::Output { session: 1, samples: vec![sample] }));
        }
        let message: serde_json::Value = serde_json::from_str(&next_text(&queue).unwrap()).unwrap();
        let samples = message["samples"].as_array().unwrap();
        assert!(samples.len() <= 4096, "{}", samples.len());
        assert_eq!(
            (&samples[0][1], &samples[0][2], &samples[samples.len() - 1][2]),
            (&0.into(), &0.into(), &9999.into())
        );
    }
}
