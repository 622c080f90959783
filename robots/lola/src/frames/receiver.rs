//! The thread that reads images.

use std::io::{self, ErrorKind, Read};
use std::os::unix::net::UnixStream;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use super::header::{HEADER_BYTES, Header};
use super::mailbox::{Frame, Mailbox};

/// Time between two attempts to connect, and after which a silent socket is asked whether the program ends.
const RETRY: Duration = Duration::from_millis(100);

/// Reader of images. Its thread ends with this value.
pub(crate) struct Receiver {
    is_over: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Receiver {
    /// Starts the thread, which connects to the socket, again whenever it was closed, and puts images into the mailbox.
    ///
    /// # Errors
    /// If there is no thread.
    pub(crate) fn start(path: PathBuf, mailbox: Arc<Mailbox>, say: fn(&str)) -> io::Result<Self> {
        let is_over = Arc::new(AtomicBool::new(false));
        let ends = Arc::clone(&is_over);
        let thread = thread::Builder::new().name("frames".to_owned()).spawn(move || {
            while !ends.load(Ordering::Relaxed) {
                match receive(&path, &mailbox, &ends) {
                    // The robot's side is not ready, or has closed the socket.
                    Err(error) if error.kind() != ErrorKind::InvalidData => {}
                    Err(error) => say(&format!("the frame socket is opened again: {error}")),
                    Ok(()) => return,
                }
                thread::sleep(RETRY);
            }
        })?;
        Ok(Self { is_over, thread: Some(thread) })
    }
}

impl Drop for Receiver {
    fn drop(&mut self) {
        self.is_over.store(true, Ordering::Relaxed);
        // A panic of it has printed its message.
        _ = self.thread.take().map(JoinHandle::join);
    }
}

/// Reads images until the end of the program.
fn receive(path: &Path, mailbox: &Mailbox, ends: &AtomicBool) -> io::Result<()> {
    let mut stream = UnixStream::connect(path)?;
    stream.set_read_timeout(Some(RETRY))?;
    let mut bytes = [0; HEADER_BYTES];
    while fill(&mut stream, &mut bytes, ends)? {
        let header = Header::decode(&bytes)
            .map_err(|why| io::Error::new(ErrorKind::InvalidData, format!("the header of a frame is wrong: {why}")))?;
        let mut pixels = vec![0; header.pixel_bytes()];
        if !fill(&mut stream, &mut pixels, ends)? {
            break;
        }
        mailbox.put(Frame { header, pixels });
    }
    Ok(())
}

/// Fills the buffer; returns false if the program ends before.
fn fill(stream: &mut UnixStream, mut buffer: &mut [u8], ends: &AtomicBool) -> io::Result<bool> {
    while !buffer.is_empty() {
        if ends.load(Ordering::Relaxed) {
            return Ok(false);
        }
        match stream.read(buffer) {
            Ok(0) => return Err(ErrorKind::UnexpectedEof.into()),
            Ok(count) => buffer = &mut buffer[count..],
            Err(error) if is_idle(&error) => {}
            Err(error) => return Err(error),
        }
    }
    Ok(true)
}

/// Whether a read ended without an error: in time, or by a signal.
fn is_idle(error: &io::Error) -> bool {
    matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut | ErrorKind::Interrupted)
}
