//! Transmission of messages.

use bica_motion::robot::Command;
use bica_wire::message;
use bica_wire::{Encoder, FromRobot, MAX_PACKET, encode};
use embedded_io_async::Write;

/// Transmitter of messages over a link.
pub(crate) struct MessageTx<W> {
    link: W,
    encoder: Encoder,
    /// Buffer for packets. It is not a local of [`Self::send`], because every future around it would contain a copy.
    buffer: &'static mut [u8; MAX_PACKET],
}

impl<W: Write> MessageTx<W> {
    /// Creates a transmitter.
    pub(crate) const fn new(link: W, buffer: &'static mut [u8; MAX_PACKET]) -> Self {
        Self { link, encoder: Encoder::new(), buffer }
    }

    /// Sends a message. If the link fails, the packet is lost, as any packet may be.
    pub(crate) async fn send(&mut self, message: &FromRobot<'_>) {
        self.send_packet(|encoder, room| encoder.encode(message, room).ok().map(<[u8]>::len)).await;
    }

    /// Sends the command computed from the sensor values of a time, µs.
    pub(crate) async fn send_command(&mut self, time_us: u64, command: &Command) {
        self.send_packet(|encoder, room| encode_command(time_us, command, encoder, room)).await;
    }

    /// Sends the packet that `encode` returns the length of; returns this length, or `None` without a packet.
    pub(crate) async fn send_packet(
        &mut self,
        encode: impl FnOnce(&mut Encoder, &mut [u8]) -> Option<usize>,
    ) -> Option<usize> {
        let length = encode(&mut self.encoder, &mut *self.buffer)?;
        let _ = self.link.write_all(&self.buffer[..length]).await;
        Some(length)
    }
}

/// Size of an encoded command, bytes: 59 numbers and the camera.
const COMMAND_BYTES: usize = 237;

/// Encodes the packet of a command; returns its length.
pub(crate) fn encode_command(time_us: u64, command: &Command, encoder: &mut Encoder, room: &mut [u8]) -> Option<usize> {
    let mut values = [0; COMMAND_BYTES];
    let values = encode(command, &mut values)?;
    encoder.encode(&FromRobot::Command(message::Command { time_us, values }), room).ok().map(<[u8]>::len)
}
