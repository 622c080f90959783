//! Waker with a pair of sockets: a client waits for two files at once.

use std::io::{self, Read as _, Write as _};
use std::os::fd::AsFd as _;
use std::os::unix::net::UnixStream;
use std::sync::Arc;
use std::time::Duration;

use nix::errno::Errno;
use nix::poll::{PollFd, PollFlags, PollTimeout, poll};

use crate::stream::Stream;

/// Ends the wait of the thread that owns the other end. Cheap to clone.
#[derive(Clone, Debug)]
pub struct Waker(Arc<UnixStream>);

/// End of a [`Waker`] that a waiting thread owns; see [`Client::poll_or_wake`](crate::Client::poll_or_wake).
#[derive(Debug)]
pub struct Wakeups(UnixStream);

/// Creates a waker and the end that a waiting thread owns.
///
/// # Errors
/// If the process has too many open files.
pub fn waker() -> io::Result<(Waker, Wakeups)> {
    let (sender, receiver) = UnixStream::pair()?;
    sender.set_nonblocking(true)?;
    receiver.set_nonblocking(true)?;
    Ok((Waker(Arc::new(sender)), Wakeups(receiver)))
}

impl Waker {
    /// Ends the present wait, or the next one.
    pub fn wake(&self) {
        // If the buffer is full, the thread wakes anyway; if the other end is dropped, no thread waits.
        let _ = (&*self.0).write(&[1]);
    }
}

impl Wakeups {
    /// Waits until the stream can be read (`true`), the waker was used, or the timeout is over (`false`). The timeout is rounded
    /// down to whole milliseconds.
    pub(crate) fn wait(&self, stream: &Stream, timeout: Duration) -> io::Result<bool> {
        let readable = |fd| PollFd::new(fd, PollFlags::POLLIN);
        let mut ends = [readable(stream.as_fd()), readable(self.0.as_fd())];
        match poll(&mut ends, PollTimeout::try_from(timeout).unwrap_or(PollTimeout::MAX)) {
            Ok(_) => {}
            Err(Errno::EINTR) => return Ok(false),
            Err(error) => return Err(error.into()),
        }
        let [is_readable, is_woken] = ends.map(|end| end.any().unwrap_or(true));
        if is_woken {
            // What remains ends the next wait, too.
            let _ = (&self.0).read(&mut [0; 256]);
        }
        Ok(is_readable)
    }
}
