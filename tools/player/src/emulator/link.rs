//! The host's end of a link.

use std::io::{Read, Write};

use bica_wire::message::LinkStats;
use bica_wire::model::Invalid;
use bica_wire::{Decoder, Encoder, FromRobot, MAX_PACKET, Packet, ToRobot};

/// The host's end of a link.
#[derive(Debug)]
pub struct Link<R, W> {
    rx: Rx<R>,
    tx: Tx<W>,
}

impl<R: Read, W: Write> Link<R, W> {
    /// Creates a link that receives from `rx` and sends to `tx`.
    pub fn new(rx: R, tx: W) -> Self {
        let rx = Rx { inner: rx, decoder: Decoder::new(), buffer: Vec::new(), consumed: 0 };
        Self { rx, tx: Tx { inner: tx, encoder: Encoder::new() } }
    }

    /// Returns both directions, for use in two threads.
    pub const fn halves(&mut self) -> (&mut Rx<R>, &mut Tx<W>) {
        (&mut self.rx, &mut self.tx)
    }

    /// Returns the counts of received packets.
    pub const fn stats(&self) -> LinkStats {
        self.rx.decoder.stats()
    }

    /// Sends a message; see [`Tx::send`].
    ///
    /// # Errors
    /// If the emulator has ended.
    pub fn send(&mut self, message: &ToRobot<'_>) -> Result<(), Invalid> {
        self.tx.send(message)
    }

    /// Skips a sequence number; see [`Tx::skip`].
    pub fn skip(&mut self) {
        self.tx.skip();
    }

    /// Sends bytes; see [`Tx::write`].
    ///
    /// # Errors
    /// If the emulator has ended.
    pub fn write(&mut self, bytes: &[u8]) -> Result<(), Invalid> {
        self.tx.write(bytes)
    }

    /// Receives messages; see [`Rx::receive`].
    ///
    /// # Errors
    /// If the emulator has ended.
    pub fn receive<T>(&mut self, select: impl FnMut(FromRobot<'_>) -> Option<T>) -> Result<T, Invalid> {
        self.rx.receive(select)
    }

    /// Waits for the robot's identity and returns its schema; see [`Rx::receive_schema`].
    ///
    /// # Errors
    /// If the emulator has ended.
    pub fn receive_schema(&mut self) -> Result<u64, Invalid> {
        self.rx.receive_schema()
    }
}

/// Transmitter of messages to the robot.
#[derive(Debug)]
pub struct Tx<W> {
    inner: W,
    encoder: Encoder,
}

impl<W: Write> Tx<W> {
    /// Sends a message.
    ///
    /// # Errors
    /// If the emulator has ended.
    pub fn send(&mut self, message: &ToRobot<'_>) -> Result<(), Invalid> {
        let packet = self.encode(message)?;
        self.write(&packet)
    }

    /// Encodes a message as the next packet without sending it.
    ///
    /// # Errors
    /// If the message does not fit into a packet.
    pub fn encode(&mut self, message: &ToRobot<'_>) -> Result<Vec<u8>, Invalid> {
        let mut buffer = [0; MAX_PACKET];
        let packet = self.encoder.encode(message, &mut buffer);
        packet.map(<[u8]>::to_vec).map_err(super::unexpected)
    }

    /// Skips a sequence number, as if a packet had been lost.
    pub fn skip(&mut self) {
        // A message without content always fits.
        let _ = self.encode(&ToRobot::Describe);
    }

    /// Sends bytes, which need not be packets.
    ///
    /// # Errors
    /// If the emulator has ended.
    pub fn write(&mut self, bytes: &[u8]) -> Result<(), Invalid> {
        self.inner.write_all(bytes).and_then(|()| self.inner.flush()).map_err(|cause| super::disconnected(&cause))
    }
}

/// Receiver of messages from the robot.
#[derive(Debug)]
pub struct Rx<R> {
    inner: R,
    decoder: Decoder<MAX_PACKET>,
    buffer: Vec<u8>,
    /// Number of bytes of the buffer that are already decoded.
    consumed: usize,
}

impl<R: Read> Rx<R> {
    /// Waits for a message for which `select` returns a value. Other messages are dropped.
    ///
    /// # Errors
    /// If the emulator has ended.
    pub fn receive<T>(&mut self, mut select: impl FnMut(FromRobot<'_>) -> Option<T>) -> Result<T, Invalid> {
        self.receive_packet(|packet| packet.message().ok().and_then(&mut select))
    }

    /// Waits for the robot's identity and returns its schema, which may differ from that of this program.
    ///
    /// # Errors
    /// If the emulator has ended.
    pub fn receive_schema(&mut self) -> Result<u64, Invalid> {
        #[expect(
            clippy::redundant_closure_for_method_calls,
            reason = "the method is not general over the packet's lifetime"
        )]
        self.receive_packet(|packet| packet.identity_schema())
    }

    fn receive_packet<T>(&mut self, mut select: impl FnMut(&Packet<'_>) -> Option<T>) -> Result<T, Invalid> {
        loop {
            while let Some(&byte) = self.buffer.get(self.consumed) {
                self.consumed += 1;
                if let Some(selected) = self.decoder.push(byte).and_then(|packet| select(&packet)) {
                    return Ok(selected);
                }
            }
            self.fill()?;
        }
    }

    fn fill(&mut self) -> Result<(), Invalid> {
        self.buffer.resize(4096, 0);
        let count = self.inner.read(&mut self.buffer).map_err(|cause| super::disconnected(&cause))?;
        self.buffer.truncate(count);
        self.consumed = 0;
        if count == 0 { Err(super::disconnected(&std::io::ErrorKind::UnexpectedEof.into())) } else { Ok(()) }
    }
}
