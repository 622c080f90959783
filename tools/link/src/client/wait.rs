//! Waiting for events and for another thread at the same time.

use std::time::{Duration, Instant};

use super::{Client, Event, HEARTBEAT};
use crate::error::Error;
use crate::waker::Wakeups;

impl Client {
    /// Waits for the next event; `None` after `timeout`, or earlier after a [`Waker::wake`](crate::Waker::wake). The timeout is
    /// rounded down to whole milliseconds: with a timeout of zero it returns the events that have arrived.
    ///
    /// # Errors
    /// [`Error::Disconnected`]; then [`reconnect`](Self::reconnect).
    pub fn poll_or_wake(&mut self, timeout: Duration, wakeups: &Wakeups) -> Result<Option<Event>, Error> {
        let until = Instant::now() + timeout;
        loop {
            let event = self.next_event()?;
            if event.is_some() {
                return Ok(event);
            }
            let left = until.saturating_duration_since(Instant::now());
            let cut = |error: std::io::Error| Error::Disconnected(error.to_string());
            if !wakeups.wait(&self.stream, left.min(HEARTBEAT)).map_err(cut)? {
                self.heartbeat()?;
                return Ok(None);
            }
            // There are bytes, so this does not wait.
            self.receive(Instant::now() + HEARTBEAT)?;
        }
    }
}
