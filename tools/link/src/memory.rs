//! Links inside a process.

use std::collections::VecDeque;
use std::io;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use crate::stream::Stream;

/// Address in this process at which a server accepts clients. Clones are the same address. No other program reaches it.
#[derive(Clone, Debug, Default)]
pub struct Memory(Arc<Shared>);

#[derive(Debug, Default)]
struct Shared {
    state: Mutex<State>,
    changed: Condvar,
}

#[derive(Debug, Default)]
struct State {
    is_served: bool,
    /// Server's ends of connections that were not accepted yet.
    waiting: VecDeque<Stream>,
}

impl PartialEq for Memory {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Eq for Memory {}

impl Memory {
    /// Waits until a server accepts clients here; returns whether it does within `timeout`.
    #[must_use]
    pub fn is_served_within(&self, timeout: Duration) -> bool {
        let until = Instant::now() + timeout;
        let mut state = self.lock();
        while !state.is_served && Instant::now() < until {
            state = self.wait(state, until.saturating_duration_since(Instant::now()));
        }
        state.is_served
    }

    pub(crate) fn connect(&self, timeout: Duration) -> io::Result<Stream> {
        if !self.is_served_within(timeout) {
            return Err(io::Error::new(io::ErrorKind::NotFound, "the program in this process does not run"));
        }
        let (own, other) = Stream::pair()?;
        self.lock().waiting.push_back(other);
        self.0.changed.notify_all();
        Ok(own)
    }

    /// Begins to accept clients.
    pub(crate) fn serve(&self) {
        self.lock().is_served = true;
        self.0.changed.notify_all();
    }

    /// Returns the next client; none after `timeout`.
    pub(crate) fn accept(&self, timeout: Duration) -> Option<Stream> {
        let mut state = self.lock();
        if state.waiting.is_empty() {
            state = self.wait(state, timeout);
        }
        state.waiting.pop_front()
    }

    /// Accepts no more clients; those that wait are disconnected.
    pub(crate) fn close(&self) {
        *self.lock() = State::default();
    }

    fn lock(&self) -> MutexGuard<'_, State> {
        self.0.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn wait<'a>(&'a self, state: MutexGuard<'a, State>, timeout: Duration) -> MutexGuard<'a, State> {
        self.0.changed.wait_timeout(state, timeout).unwrap_or_else(PoisonError::into_inner).0
    }
}
