//! Images from a stream, read as far as they have arrived.

use std::io::{self, ErrorKind, Read};
use std::os::unix::net::UnixStream;
use std::path::PathBuf;
use std::sync::Arc;

use super::header::{HEADER_BYTES, Header};
use super::mailbox::{Frame, Mailbox};

/// Client of the frame socket, which never waits.
pub(crate) struct Source {
    path: PathBuf,
    say: fn(&str),
    stream: Option<Arc<UnixStream>>,
    /// The image that has begun, its header first: of these bytes so many were read.
    bytes: Vec<u8>,
    filled: usize,
}

impl Source {
    pub(crate) const fn new(path: PathBuf, say: fn(&str)) -> Self {
        Self { path, say, stream: None, bytes: Vec::new(), filled: 0 }
    }

    /// The open stream; opens it if it is not. `None` if the robot's side is not ready.
    pub(crate) fn connect(&mut self) -> Option<Arc<UnixStream>> {
        if self.stream.is_none() {
            let stream = UnixStream::connect(&self.path).ok()?;
            stream.set_nonblocking(true).ok()?;
            (self.bytes, self.filled) = (vec![0; HEADER_BYTES], 0);
            self.stream = Some(Arc::new(stream));
        }
        self.stream.clone()
    }

    /// Puts the images that have arrived into the mailbox. A stream that ends or fails is closed.
    pub(crate) fn read(&mut self, mailbox: &Mailbox) {
        let Some(stream) = self.stream.clone() else { return };
        if let Err(error) = self.read_from(&stream, mailbox) {
            self.stream = None;
            if error.kind() == ErrorKind::InvalidData {
                (self.say)(&format!("the frame socket is opened again: {error}"));
            }
        }
    }

    fn read_from(&mut self, mut stream: &UnixStream, mailbox: &Mailbox) -> io::Result<()> {
        loop {
            match stream.read(&mut self.bytes[self.filled..]) {
                Ok(0) => return Err(ErrorKind::UnexpectedEof.into()),
                Ok(count) => self.filled += count,
                Err(error) if error.kind() == ErrorKind::WouldBlock => return Ok(()),
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(error) => return Err(error),
            }
            if self.filled == self.bytes.len() {
                self.advance(mailbox)?;
            }
        }
    }

    /// Goes on from a header to its pixels, and from an image to the next header.
    fn advance(&mut self, mailbox: &Mailbox) -> io::Result<()> {
        let header = self.bytes.first_chunk().map_or(Err("it is short"), Header::decode);
        let header = header
            .map_err(|why| io::Error::new(ErrorKind::InvalidData, format!("the header of a frame is wrong: {why}")))?;
        if self.filled == HEADER_BYTES {
            self.bytes.resize(HEADER_BYTES + header.pixel_bytes(), 0);
        } else {
            mailbox.put(Frame { header, taken: None, pixels: self.bytes.split_off(HEADER_BYTES) });
            self.filled = 0;
        }
        Ok(())
    }
}
