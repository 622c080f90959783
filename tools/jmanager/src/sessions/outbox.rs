//! What a page receives.

use std::sync::Arc;

use crate::protocol::{SessionId, ToPage};

/// Queue of a page. No method ever waits.
pub trait Outbox: Send + Sync {
    /// Adds a message that must not be lost. The queue is bounded: if it is full, the page is disconnected.
    fn state(&self, message: ToPage);

    /// Adds a binary frame that must not be lost, in order with [`state`](Self::state): the image that an answer needs.
    fn binary(&self, frame: Arc<[u8]>);

    /// Adds data. It replaces an older frame with the same key that was not sent yet.
    fn data(&self, key: Key, frame: Frame);
}

/// A frame of data, ready to be sent. Pages that receive the same frame share its memory.
#[derive(Clone, Debug)]
pub enum Frame {
    /// A [`ToPage`] as JSON.
    Text(Arc<str>),
    /// An [image](crate::protocol::binary).
    Binary(Arc<[u8]>),
}

impl Frame {
    /// The text frame of a message.
    #[must_use]
    pub fn of(message: &ToPage) -> Self {
        // Serialization into memory fails only for maps with keys that are no strings, and the protocol has none.
        Self::Text(serde_json::to_string(message).unwrap_or_default().into())
    }
}

/// What makes two frames of data the same: the later one replaces the earlier one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Key {
    /// Session.
    pub session: SessionId,
    /// Kind.
    pub kind: DataKind,
}

/// Kind of data.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum DataKind {
    /// [`ToPage::Update`].
    Update,
    /// [`ToPage::Info`].
    Info,
    /// [`ToPage::Conditions`] of a component.
    Conditions(usize),
    /// [`ToPage::Costs`].
    Costs,
    /// [`ToPage::Truth`].
    Truth,
    /// A watched image.
    Image,
}
