//! The host's end of a link.

use std::io::{Read, Write};

use bica_wire::{FromRobot, Losses, MAX_PACKET, Receiver, Sender, ToRobot};

use crate::error::Error;

/// The host's end of a link.
#[derive(Debug)]
pub struct Line<R, W> {
    ear: Ear<R>,
    mouth: Mouth<W>,
}

impl<R: Read, W: Write> Line<R, W> {
    /// Hears from `from`, speaks to `to`.
    pub fn new(from: R, to: W) -> Self {
        let ear = Ear { from, receiver: Receiver::new(), room: Vec::new(), read: 0 };
        Self { ear, mouth: Mouth { to, sender: Sender::new() } }
    }

    /// Both directions, for two threads.
    pub const fn halves(&mut self) -> (&mut Ear<R>, &mut Mouth<W>) {
        (&mut self.ear, &mut self.mouth)
    }

    /// What was heard and lost so far.
    pub const fn losses(&self) -> Losses {
        self.ear.receiver.losses()
    }

    /// [`Mouth::say`].
    ///
    /// # Errors
    /// [`Error::Gone`].
    pub fn say(&mut self, message: &ToRobot<'_>) -> Result<(), Error> {
        self.mouth.say(message)
    }

    /// [`Mouth::lose`].
    pub fn lose(&mut self) {
        self.mouth.lose();
    }

    /// [`Mouth::write`].
    ///
    /// # Errors
    /// [`Error::Gone`].
    pub fn write(&mut self, bytes: &[u8]) -> Result<(), Error> {
        self.mouth.write(bytes)
    }

    /// [`Ear::hear`].
    ///
    /// # Errors
    /// [`Error::Gone`].
    pub fn hear<T>(&mut self, take: impl FnMut(FromRobot<'_>) -> Option<T>) -> Result<T, Error> {
        self.ear.hear(take)
    }
}

/// Speaks to the robot.
#[derive(Debug)]
pub struct Mouth<W> {
    to: W,
    sender: Sender,
}

impl<W: Write> Mouth<W> {
    /// Says something.
    ///
    /// # Errors
    /// [`Error::Gone`].
    pub fn say(&mut self, message: &ToRobot<'_>) -> Result<(), Error> {
        let packet = self.pack(message)?;
        self.write(&packet)
    }

    /// The packet of a message, numbered as the next one. It is not sent.
    ///
    /// # Errors
    /// [`Error::Unexpected`] if the message does not fit into a packet.
    pub fn pack(&mut self, message: &ToRobot<'_>) -> Result<Vec<u8>, Error> {
        let mut room = [0; MAX_PACKET];
        let packet = self.sender.pack(message, &mut room);
        packet.map(<[u8]>::to_vec).map_err(|error| Error::Unexpected(error.to_string()))
    }

    /// Loses a packet before it is sent: the next one has the number after it.
    pub fn lose(&mut self) {
        // A message without content always fits.
        let _ = self.pack(&ToRobot::Describe);
    }

    /// Sends bytes that need not be a packet.
    ///
    /// # Errors
    /// [`Error::Gone`].
    pub fn write(&mut self, bytes: &[u8]) -> Result<(), Error> {
        self.to.write_all(bytes).and_then(|()| self.to.flush()).map_err(Error::Gone)
    }
}

/// Hears the robot.
#[derive(Debug)]
pub struct Ear<R> {
    from: R,
    receiver: Receiver<MAX_PACKET>,
    room: Vec<u8>,
    read: usize,
}

impl<R: Read> Ear<R> {
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
