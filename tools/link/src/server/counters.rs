//! Counts of a server.

use std::sync::atomic::{AtomicU32, AtomicUsize, Ordering};

/// Counts of a server.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LinkStats {
    /// Number of monitors now: connections that have sent a message.
    pub monitors: usize,
    /// Number of damaged packets, noise included.
    pub damaged: u32,
    /// Number of undamaged packets that contain no message of a monitor.
    pub unknown: u32,
    /// Number of connections closed because [`MAX_MONITORS`](crate::MAX_MONITORS) were open.
    pub rejected: u32,
    /// Number of connections closed because the monitor did not read its messages.
    pub too_slow: u32,
}

/// The counts, shared by all threads.
#[derive(Debug, Default)]
pub(super) struct Counters {
    /// Number of connections that have sent a message.
    pub(super) open: AtomicUsize,
    pub(super) damaged: AtomicU32,
    pub(super) unknown: AtomicU32,
    pub(super) rejected: AtomicU32,
    pub(super) too_slow: AtomicU32,
}

impl Counters {
    pub(super) fn stats(&self) -> LinkStats {
        let count = |counter: &AtomicU32| counter.load(Ordering::Relaxed);
        LinkStats {
            monitors: self.open.load(Ordering::Relaxed),
            damaged: count(&self.damaged),
            unknown: count(&self.unknown),
            rejected: count(&self.rejected),
            too_slow: count(&self.too_slow),
        }
    }
}
