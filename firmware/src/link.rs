//! Transmission of messages.

use bica_wire::{Encoder, FromRobot, MAX_PACKET};
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
        if let Ok(packet) = self.encoder.encode(message, self.buffer) {
            let _ = self.link.write_all(packet).await;
        }
    }

    /// Sends the packet that `encode` returns the length of; returns this length, or `None` without a packet.
    #[cfg(feature = "monitor")]
    pub(crate) async fn send_packet(
        &mut self,
        encode: impl FnOnce(&mut Encoder, &mut [u8]) -> Option<usize>,
    ) -> Option<usize> {
        let length = encode(&mut self.encoder, &mut *self.buffer)?;
        let _ = self.link.write_all(&self.buffer[..length]).await;
        Some(length)
    }
}
