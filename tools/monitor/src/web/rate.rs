//! Limit of the rate of a page's messages.

use std::time::{Duration, Instant};

/// Largest burst, messages.
const BURST: f64 = 300.0;
/// Sustained rate, messages/s.
const PER_SECOND: f64 = 150.0;

/// Token bucket: each message takes one token, and time refills them.
pub(crate) struct Rate {
    left: f64,
    last: Instant,
}

impl Rate {
    pub(crate) const fn new(now: Instant) -> Self {
        Self { left: BURST, last: now }
    }

    /// Counts a message; returns whether it is within the limit.
    pub(crate) fn allows(&mut self, now: Instant) -> bool {
        let passed = now.saturating_duration_since(self.last);
        self.last = now;
        self.left = (self.left + passed.min(Duration::from_secs(10)).as_secs_f64() * PER_SECOND).min(BURST) - 1.0;
        self.left >= 0.0
    }
}
