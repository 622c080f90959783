//! Queue of messages to a page.

use std::collections::HashSet;
use std::sync::Arc;

use crate::protocol::{OutputSample, SessionId, ToPage};

/// Queue of messages to a page. No method blocks.
pub trait Outbox: Send + Sync {
    /// Adds a message that must not be lost. The queue is bounded: if it is full, the page is disconnected.
    fn state(&self, message: ToPage);

    /// Adds a binary frame that must not be lost, in order with [`state`](Self::state): the image that belongs to an answer.
    fn binary(&self, frame: Arc<[u8]>);

    /// Adds data. The frame [replaces](Frame::replacing) an older one with the same key that was not sent yet.
    fn data(&self, key: Key, frame: Frame);
}

/// Largest number of samples, and of changes, in a frame.
const MAX_ENTRIES: usize = 4096;

/// A frame of data. Pages that receive the same frame share its memory.
#[derive(Clone, Debug)]
pub enum Frame {
    /// A message.
    Message(Arc<ToPage>),
    /// An [image](crate::protocol::binary).
    Binary(Arc<[u8]>),
}

impl Frame {
    /// Returns the frame of a message.
    #[must_use]
    pub fn of(message: ToPage) -> Self {
        Self::Message(Arc::new(message))
    }

    /// Returns the frame that replaces `older`, which was not sent. Samples and changes of the older one are kept.
    #[must_use]
    pub fn replacing(mut self, older: Self) -> Self {
        if let (Self::Message(newer), Self::Message(older)) = (&mut self, older) {
            match (Arc::make_mut(newer), Arc::unwrap_or_clone(older)) {
                (ToPage::Output { samples, .. }, ToPage::Output { samples: mut all, .. }) => {
                    all.append(samples);
                    limit_samples(&mut all);
                    *samples = all;
                }
                (ToPage::Update { changes, .. }, ToPage::Update { changes: mut all, .. }) => {
                    all.append(changes);
                    all.drain(..all.len().saturating_sub(MAX_ENTRIES));
                    *changes = all;
                }
                _ => {}
            }
        }
        self
    }
}

/// Drops all but the newest sample of each output if there are too many.
fn limit_samples(samples: &mut Vec<OutputSample>) {
    if samples.len() > MAX_ENTRIES {
        let mut seen = HashSet::new();
        samples.reverse();
        samples.retain(|&OutputSample(component, output, ..)| seen.insert((component, output)));
        samples.reverse();
    }
}

/// Key of a data frame. A later frame replaces an earlier one with the same key.
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
    /// [`ToPage::Output`].
    Output,
    /// [`ToPage::Conditions`] of a component.
    Conditions(usize),
    /// [`ToPage::Costs`].
    Costs,
    /// [`ToPage::Truth`].
    Truth,
    /// A watched image.
    Image,
}
