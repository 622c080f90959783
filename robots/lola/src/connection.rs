//! The connection with LoLA's socket.

use std::io::{self, ErrorKind, Read, Write};
use std::os::unix::net::UnixStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Command};
use std::thread;
use std::time::Duration;

use crate::buffer::{Found, MapBuffer};
use crate::guard;
use crate::mistake::Mistake;
use crate::sensor_map::SensorMap;

/// Time between two attempts to connect.
const RETRY: Duration = Duration::from_millis(100);
/// Longest wait for bytes, after which the caller can ask whether the program ends.
const WAIT: Duration = Duration::from_millis(50);
/// Longest time in which an answer is sent. A robot that takes none for so long has closed its side in all but name.
pub(crate) const SEND: Duration = Duration::from_millis(500);

/// What happened on the connection.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Event {
    /// The socket was opened: the robot may have been moved. With the reason if there should be a guard, and there is none.
    Opened(Option<String>),
    /// The socket was closed, or failed.
    Closed,
    /// A valid map.
    Map(Box<SensorMap>),
    /// Bytes that are no valid map were dropped.
    Rejected(Mistake),
    /// Nothing for a while.
    Silence,
}

/// Client of LoLA's socket that opens it again whenever it was closed.
#[derive(Debug)]
pub(crate) struct Connection {
    path: PathBuf,
    /// Makes the command of a guard.
    guard: Option<fn(&Path) -> Command>,
    stream: Option<UnixStream>,
    /// The guard of the open socket.
    child: Option<Child>,
    buffer: MapBuffer,
}

impl Connection {
    /// A connection that is not open yet.
    pub(crate) fn new(path: PathBuf, guard: Option<fn(&Path) -> Command>) -> Self {
        Self { path, guard, stream: None, child: None, buffer: MapBuffer::default() }
    }

    /// The open connection of another process, with the bytes that were not yet used.
    pub(crate) fn taken_over(path: PathBuf, stream: UnixStream, buffer: MapBuffer) -> Self {
        Self { path, guard: None, stream: Some(stream), child: None, buffer }
    }

    /// The path of the socket.
    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// Waits for the next event, 100 ms at most.
    pub(crate) fn wait(&mut self) -> Event {
        let Some(stream) = &mut self.stream else { return self.open() };
        if let Some(found) = self.buffer.next_map() {
            return event(found);
        }
        let mut bytes = [0; 8192];
        match stream.read(&mut bytes) {
            Ok(count) if count > 0 => self.buffer.push(&bytes[..count]),
            Err(error) if is_idle(&error) => return Event::Silence,
            Ok(_) | Err(_) => return self.close(),
        }
        self.buffer.next_map().map_or(Event::Silence, event)
    }

    /// Whether the next valid map was received already.
    pub(crate) fn has_next(&mut self) -> bool {
        let mut bytes = [0; 8192];
        // What fails here fails again when the next map is waited for.
        if let Some(stream) = &mut self.stream
            && stream.set_nonblocking(true).is_ok()
        {
            if let Ok(count) = stream.read(&mut bytes) {
                self.buffer.push(&bytes[..count]);
            }
            _ = stream.set_nonblocking(false);
        }
        self.buffer.has_map()
    }

    /// Sends an answer. If that fails, the next event says so.
    pub(crate) fn send(&mut self, bytes: &[u8]) {
        if let Some(stream) = &mut self.stream
            && stream.write_all(bytes).is_err()
        {
            // The next read fails or ends.
            _ = stream.shutdown(std::net::Shutdown::Both);
        }
    }

    /// Closes the socket, and waits for the guard, which does the same.
    pub(crate) fn close(&mut self) -> Event {
        self.stream = None;
        if let Some(mut child) = self.child.take() {
            // A guard that cannot be waited for has ended.
            _ = child.wait();
        }
        self.buffer.clear();
        Event::Closed
    }

    /// Ends the guard, so that it does not go on with what this program has given up.
    pub(crate) fn dismiss(&mut self) {
        if let Some(child) = &mut self.child {
            // A guard that cannot be ended has ended.
            _ = child.kill();
        }
    }

    fn open(&mut self) -> Event {
        let Ok(robot) = UnixStream::connect(&self.path) else {
            thread::sleep(RETRY);
            return Event::Silence;
        };
        let guarded = self.guard.map(|command| guard::start(&robot, command(&self.path)));
        let (stream, child, reason) = match guarded {
            None => (robot, None, None),
            Some(Ok((stream, child))) => (stream, Some(child), None),
            Some(Err(error)) => (robot, None, Some(error.to_string())),
        };
        let limit = || -> io::Result<()> {
            stream.set_read_timeout(Some(WAIT))?;
            stream.set_write_timeout(Some(SEND))
        };
        if limit().is_err() {
            return Event::Silence;
        }
        (self.stream, self.child) = (Some(stream), child);
        Event::Opened(reason)
    }
}

fn event(found: Found) -> Event {
    match found {
        Found::Map(map) => Event::Map(map),
        Found::Rejected(mistake) => Event::Rejected(mistake),
    }
}

/// Whether a read ended without an error: in time, or by a signal.
pub(crate) fn is_idle(error: &io::Error) -> bool {
    matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut | ErrorKind::Interrupted)
}
