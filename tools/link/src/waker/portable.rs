//! Waker with a flag that is checked every millisecond.

use std::io::{self, ErrorKind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use crate::stream::Stream;

/// Time between two checks of the flag.
const LOOK: Duration = Duration::from_millis(1);

/// Ends the wait of the thread that owns the other end. Cheap to clone.
#[derive(Clone, Debug)]
pub struct Waker(Arc<AtomicBool>);

/// End of a [`Waker`] that a waiting thread owns; see [`Client::poll_or_wake`](crate::Client::poll_or_wake).
#[derive(Debug)]
pub struct Wakeups(Arc<AtomicBool>);

/// Creates a waker and the end that a waiting thread owns.
///
/// # Errors
/// Only on other operating systems.
pub fn waker() -> io::Result<(Waker, Wakeups)> {
    let flag = Arc::new(AtomicBool::new(false));
    Ok((Waker(Arc::clone(&flag)), Wakeups(flag)))
}

impl Waker {
    /// Ends the present wait, or the next one.
    pub fn wake(&self) {
        self.0.store(true, Ordering::Release);
    }
}

impl Wakeups {
    /// Waits until the stream can be read (`true`), the waker was used, or the timeout is over (`false`).
    pub(crate) fn wait(&self, stream: &Stream, timeout: Duration) -> io::Result<bool> {
        let Stream::Tcp(stream) = stream else { return Ok(true) };
        let until = Instant::now() + timeout;
        stream.set_read_timeout(Some(LOOK))?;
        loop {
            match stream.peek(&mut [0]) {
                Ok(_) => return Ok(true),
                Err(error) if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut) => {}
                Err(error) => return Err(error),
            }
            if self.0.swap(false, Ordering::Acquire) || Instant::now() >= until {
                return Ok(false);
            }
        }
    }
}
