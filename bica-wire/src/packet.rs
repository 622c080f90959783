//! From a message to a packet.

use core::fmt;

use serde::Serialize;

use crate::crc::crc32;

/// Bytes of the running number, before the message.
pub(crate) const NUMBER: usize = 2;
/// Bytes of the check, after the message.
pub(crate) const CHECK: usize = 4;

/// Room that every packet of this crate's messages fits into, bytes.
pub const MAX_PACKET: usize = 1280;

/// Makes packets, numbered.
#[derive(Clone, Debug, Default)]
pub struct Sender {
    number: u16,
}

/// A packet does not fit into the room given for it. It was not made, and leaves no gap in the numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooLarge;

impl fmt::Display for TooLarge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the packet does not fit: MAX_PACKET bytes are enough for every message of this crate")
    }
}

impl core::error::Error for TooLarge {}

impl Sender {
    /// Has sent nothing yet.
    #[must_use]
    pub const fn new() -> Self {
        Self { number: 0 }
    }

    /// Packs a message into `room`; the packet is the part that is returned.
    ///
    /// # Errors
    /// [`TooLarge`] if it does not fit.
    pub fn pack<'a>(&mut self, message: &impl Serialize, room: &'a mut [u8]) -> Result<&'a [u8], TooLarge> {
        let mut plain = [0; MAX_PACKET];
        plain[..NUMBER].copy_from_slice(&self.number.to_le_bytes());
        let length = NUMBER + postcard::to_slice(message, &mut plain[NUMBER..]).map_err(|_| TooLarge)?.len();
        let check = crc32(&plain[..length]).to_le_bytes();
        plain.get_mut(length..length + CHECK).ok_or(TooLarge)?.copy_from_slice(&check);
        let length = length + CHECK;
        if room.len() <= cobs::max_encoding_length(length) {
            return Err(TooLarge);
        }
        let end = cobs::encode(&plain[..length], room);
        room[end] = 0;
        self.number = self.number.wrapping_add(1);
        Ok(&room[..=end])
    }
}
