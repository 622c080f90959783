//! What the robot says, in packets.

use bica_wire::{Encoder, FromRobot, MAX_PACKET};
use embedded_io_async::Write;

/// Speaks over a link.
pub(crate) struct Voice<W> {
    link: W,
    sender: Encoder,
    /// Where packets are made. Not in [`Self::say`]: every future around it would hold one.
    room: &'static mut [u8; MAX_PACKET],
}

impl<W: Write> Voice<W> {
    /// Has said nothing yet.
    pub(crate) const fn new(link: W, room: &'static mut [u8; MAX_PACKET]) -> Self {
        Self { link, sender: Encoder::new(), size: room }
    }

    /// Says it. What the link does not take is lost, as packets may be.
    pub(crate) async fn say(&mut self, message: &FromRobot<'_>) {
        if let Ok(packet) = self.sender.encode(message, self.room) {
            let _ = self.link.write_all(packet).await;
        }
    }
}
