//! QEMU with a firmware image, and a pipe to it.

use std::io::{Read, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use bica_wire::{FromRobot, Losses, MAX_PACKET, Receiver, Sender, ToRobot};

use crate::error::Error;

/// QEMU's name for the memory word that tells the image to speak through the pipe, and its content ("PIPE").
const JUMPER: &str = "loader,addr=0x203ffffc,data=0x45504950,data-len=4";

/// What carries the messages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Carrier {
    /// A pipe: fast, and the microcontroller's time stands still while it waits.
    Pipe,
    /// The board's serial port: a byte at a time, slow in QEMU; time goes on while the microcontroller waits.
    Serial,
}

impl Carrier {
    fn arguments(self) -> &'static [&'static str] {
        match self {
            Self::Pipe => &["-icount", "shift=0,sleep=off", "-device", JUMPER, "-serial", "null"],
            Self::Serial => &["-icount", "shift=0,sleep=on", "-serial", "stdio"],
        }
    }
}

/// A running image. It ends with this value.
#[derive(Debug)]
pub struct Emulator {
    child: Child,
    line: Line<ChildStdout, ChildStdin>,
}

impl Emulator {
    /// Starts an image; its log (defmt, not decoded) goes to a file, if one is named.
    ///
    /// # Errors
    /// [`Error::NoImage`], [`Error::NoEmulator`].
    pub fn start(image: &Path, carrier: Carrier, log: Option<&Path>) -> Result<Self, Error> {
        if !image.is_file() {
            return Err(Error::NoImage(image.to_owned()));
        }
        let log = log.map_or_else(|| "null".to_owned(), |path| format!("file:{}", path.display()));
        let mut child = Command::new("qemu-system-arm")
            .args(["-M", "mps2-an500", "-cpu", "cortex-m7", "-display", "none", "-monitor", "none"])
            .args(["-semihosting-config", "enable=on,target=native"])
            .args(carrier.arguments())
            .args(["-serial", &log])
            .arg("-kernel")
            .arg(image)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(Error::NoEmulator)?;
        let (Some(to), Some(from)) = (child.stdin.take(), child.stdout.take()) else {
            return Err(Error::Unexpected("no pipes".to_owned()));
        };
        Ok(Self { child, line: Line::new(from, to) })
    }

    /// The pipe.
    pub const fn line(&mut self) -> &mut Line<ChildStdout, ChildStdin> {
        &mut self.line
    }
}

impl Drop for Emulator {
    fn drop(&mut self) {
        // An emulator that has already ended needs no end.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// The host's end of a link.
#[derive(Debug)]
pub struct Line<R, W> {
    from: R,
    to: W,
    sender: Sender,
    receiver: Receiver<MAX_PACKET>,
    room: Vec<u8>,
    read: usize,
}

impl<R: Read, W: Write> Line<R, W> {
    /// Hears from `from`, speaks to `to`.
    pub fn new(from: R, to: W) -> Self {
        Self { from, to, sender: Sender::new(), receiver: Receiver::new(), room: Vec::new(), read: 0 }
    }

    /// What was heard and lost so far.
    pub const fn losses(&self) -> Losses {
        self.receiver.losses()
    }

    /// Says something.
    ///
    /// # Errors
    /// [`Error::Gone`].
    pub fn say(&mut self, message: &ToRobot<'_>) -> Result<(), Error> {
        let mut room = [0; MAX_PACKET];
        let packet = self.sender.pack(message, &mut room).map_err(|error| Error::Unexpected(error.to_string()))?;
        self.write(packet.to_vec().as_slice())
    }

    /// Loses a packet before it is sent: the next one has the number after it.
    pub fn lose(&mut self) {
        // A message without content always fits.
        let _ = self.sender.pack(&ToRobot::Describe, &mut [0; MAX_PACKET]);
    }

    /// Sends bytes that need not be a packet.
    ///
    /// # Errors
    /// [`Error::Gone`].
    pub fn write(&mut self, bytes: &[u8]) -> Result<(), Error> {
        self.to.write_all(bytes).and_then(|()| self.to.flush()).map_err(Error::Gone)
    }

    /// Waits until `take` takes what the robot says; what it does not take is passed over.
    ///
    /// # Errors
    /// [`Error::Gone`].
    pub fn hear<T>(&mut self, mut take: impl FnMut(FromRobot<'_>) -> Option<T>) -> Result<T, Error> {
        loop {
            while let Some(&byte) = self.room.get(self.read) {
                self.read += 1;
                let message = self.receiver.push(byte).and_then(|heard| heard.read().ok());
                if let Some(taken) = message.and_then(&mut take) {
                    return Ok(taken);
                }
            }
            self.fill()?;
        }
    }

    fn fill(&mut self) -> Result<(), Error> {
        self.room.resize(4096, 0);
        let count = self.from.read(&mut self.room).map_err(Error::Gone)?;
        self.room.truncate(count);
        self.read = 0;
        if count == 0 { Err(Error::Gone(std::io::ErrorKind::UnexpectedEof.into())) } else { Ok(()) }
    }
}
