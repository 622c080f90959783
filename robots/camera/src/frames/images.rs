//! The thread that reads images.

use std::io;
use std::os::fd::AsFd;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use bica_motion::robot::CameraId;
use nix::poll::{PollFd, PollFlags, poll};

use super::mailbox::{Frame, Mailbox};
use super::source::Source;

/// Time between two attempts to connect.
const RETRY: Duration = Duration::from_millis(100);
/// Time after which a silent socket is asked whether the program ends, ms.
const WAIT: u8 = 100;

/// Images from a socket of the robot's side. Their thread ends with this value.
pub(crate) struct Socket {
    shared: Arc<Shared>,
    thread: Option<JoinHandle<()>>,
}

struct Shared {
    source: Mutex<Source>,
    mailbox: Mailbox,
    is_over: AtomicBool,
}

impl Shared {
    fn source(&self) -> std::sync::MutexGuard<'_, Source> {
        self.source.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Socket {
    /// Starts the thread, which connects to the socket, again whenever it was closed.
    ///
    /// # Errors
    /// If there is no thread.
    pub(crate) fn start(path: PathBuf, say: fn(&str)) -> io::Result<Self> {
        let source = Mutex::new(Source::new(path, say));
        let shared = Arc::new(Shared { source, mailbox: Mailbox::default(), is_over: AtomicBool::new(false) });
        let threads = Arc::clone(&shared);
        let thread = thread::Builder::new().name("frames".to_owned()).spawn(move || receive(&threads))?;
        Ok(Self { shared, thread: Some(thread) })
    }

    /// Takes the image for the map of this number, as [`Mailbox::take`] does. With `is_complete` those are read first that the robot has
    /// sent before, so that the result does not depend on the speed of the computer.
    pub(crate) fn take(&self, camera: CameraId, number: u32, is_complete: bool) -> Option<Frame> {
        if is_complete {
            self.shared.source().read(&self.shared.mailbox);
        }
        self.shared.mailbox.take(camera, number)
    }
}

impl Drop for Socket {
    fn drop(&mut self) {
        self.shared.is_over.store(true, Ordering::Relaxed);
        // A panic of it has printed its message.
        _ = self.thread.take().map(JoinHandle::join);
    }
}

fn receive(shared: &Shared) {
    while !shared.is_over.load(Ordering::Relaxed) {
        let stream = shared.source().connect();
        let Some(stream) = stream else {
            thread::sleep(RETRY);
            continue;
        };
        // An error is one of the stream, and the next read has it, too.
        _ = poll(&mut [PollFd::new(stream.as_fd(), PollFlags::POLLIN)], WAIT);
        shared.source().read(&shared.mailbox);
    }
}
