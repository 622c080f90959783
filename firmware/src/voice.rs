//! What the robot says, in packets.

use bica_wire::{FromRobot, MAX_PACKET, Sender};
use embedded_io_async::Write;

/// Speaks over a link.
pub(crate) struct Voice<W> {
    link: W,
    sender: Sender,
}

impl<W: Write> Voice<W> {
    /// Has said nothing yet.
    pub(crate) const fn new(link: W) -> Self {
        Self { link, sender: Sender::new() }
    }

    /// Says it. What the link does not take is lost, as packets may be.
    pub(crate) async fn say(&mut self, message: &FromRobot<'_>) {
        let mut room = [0; MAX_PACKET];
        if let Ok(packet) = self.sender.pack(message, &mut room) {
            let _ = self.link.write_all(packet).await;
        }
    }
}
