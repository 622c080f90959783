//! From a message to a packet.

use core::fmt;

use postcard::ser_flavors::{Cobs, Flavor, Slice};
use serde::Serialize;

use crate::crc::Crc32;

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

    /// Packs a message into `room`; the packet is the part that is returned. Needs no other memory.
    ///
    /// # Errors
    /// [`TooLarge`] if it does not fit.
    pub fn pack<'a>(&mut self, message: &impl Serialize, room: &'a mut [u8]) -> Result<&'a [u8], TooLarge> {
        let stuffed = Cobs::try_new(Slice::new(room)).map_err(|_| TooLarge)?;
        let mut checked = Checked { to: stuffed, crc: Crc32::new() };
        let packed = checked.try_extend(&self.number.to_le_bytes());
        let packed = packed.and_then(|()| postcard::serialize_with_flavor(message, checked)).map_err(|_| TooLarge)?;
        self.number = self.number.wrapping_add(1);
        Ok(packed)
    }
}

/// Lets bytes pass, and their check after them.
struct Checked<F> {
    to: F,
    crc: Crc32,
}

impl<F: Flavor> Flavor for Checked<F> {
    type Output = F::Output;

    fn try_push(&mut self, byte: u8) -> postcard::Result<()> {
        self.crc.add(byte);
        self.to.try_push(byte)
    }

    fn finalize(mut self) -> postcard::Result<F::Output> {
        self.to.try_extend(&self.crc.value().to_le_bytes())?;
        self.to.finalize()
    }
}
