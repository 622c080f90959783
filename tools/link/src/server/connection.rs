//! A monitor's connection.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::time::Instant;

use super::counters::Counters;
use super::outbox::{Batch, Message, Outbox, Unsent};
use crate::stream::Stream;

/// Time after which the next image is sent although the last one was not taken, ms: a part may be lost on a serial line.
const IMAGE_MS: u64 = 10_000;
/// Time of the last image if no image waits to be taken.
const TAKEN: u64 = u64::MAX;
/// Number of the last image if there is none.
const NO_IMAGE: u64 = u64::MAX;

/// A monitor's connection.
#[derive(Debug)]
pub(super) struct Connection {
    pub(super) id: u64,
    /// Number of messages that wait for the loop.
    pub(super) pending: AtomicUsize,
    outbox: Outbox,
    began: Instant,
    /// Time of the last image, ms after the beginning; [`TAKEN`] if the monitor has taken it.
    image_ms: AtomicU64,
    /// Number of the last image for the monitor; [`NO_IMAGE`] without one since it began to watch images.
    image: AtomicU64,
    closed: AtomicBool,
    stream: Stream,
    counters: Arc<Counters>,
}

impl Connection {
    pub(super) fn new(id: u64, stream: Stream, counters: Arc<Counters>) -> Self {
        Self {
            id,
            pending: AtomicUsize::new(0),
            outbox: Outbox::default(),
            began: Instant::now(),
            image_ms: AtomicU64::new(TAKEN),
            image: AtomicU64::new(NO_IMAGE),
            closed: AtomicBool::new(false),
            stream,
            counters,
        }
    }

    /// Adds a message to the lossless queue. For threads that may wait, not for the loop.
    pub(super) fn push(&self, message: Message) {
        if !self.outbox.push(message) {
            self.overflow();
        }
    }

    /// Waits for data to send, see [`Outbox::take`].
    pub(super) fn take(&self, is_sending: bool) -> Option<Batch> {
        self.outbox.take(is_sending)
    }

    /// Marks the last image as taken by the monitor.
    pub(super) fn image_taken(&self) {
        self.image_ms.store(TAKEN, Ordering::Relaxed);
    }

    /// Hands over the loop's data for the monitor. If the writer is using the queues, the data stay with the loop, which never
    /// waits.
    pub(super) fn offer(&self, unsent: &mut Unsent) {
        if !self.outbox.offer(unsent) {
            self.overflow();
        }
    }

    /// Notes that the image with a number will be sent.
    pub(super) fn shows_image(&self, number: u32) {
        self.image_ms.store(self.began.elapsed().as_millis() as u64, Ordering::Relaxed);
        self.image.store(number.into(), Ordering::Relaxed);
    }

    /// Forgets the last image, because the monitor begins to watch images: the newest one is sent to it, even if it was sent
    /// before.
    pub(super) fn forget_image(&self) {
        self.image.store(NO_IMAGE, Ordering::Relaxed);
    }

    /// Returns whether an image can be sent: it is not the last one, and the monitor has taken the last one, or it took too long.
    pub(super) fn is_ready_for_image(&self, number: u32) -> bool {
        if self.image.load(Ordering::Relaxed) == u64::from(number) {
            return false;
        }
        let now = self.began.elapsed().as_millis() as u64;
        let last = self.image_ms.load(Ordering::Relaxed);
        last == TAKEN || now.saturating_sub(last) > IMAGE_MS
    }

    pub(super) fn is_closed(&self) -> bool {
        self.closed.load(Ordering::Relaxed)
    }

    pub(super) fn overflow(&self) {
        if !self.closed.load(Ordering::Relaxed) {
            self.counters.too_slow.fetch_add(1, Ordering::Relaxed);
        }
        self.close();
    }

    /// Closes the connection. Messages that wait are dropped, in both directions.
    pub(super) fn close(&self) {
        self.closed.store(true, Ordering::Relaxed);
        self.outbox.close();
        self.stream.shut_down();
    }
}
