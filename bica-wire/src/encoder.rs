//! Encoding of messages as packets.

use core::fmt;

use postcard::ser_flavors::{Cobs, Flavor, Slice};
use serde::Serialize;

use crate::crc::Crc32;

/// Encodes messages as packets and numbers them.
#[derive(Clone, Debug, Default)]
pub struct Encoder {
    next_sequence: u16,
}

/// The packet does not fit into the buffer. No packet was encoded and no sequence number was used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooLarge;

impl fmt::Display for TooLarge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the packet does not fit into the buffer: MAX_PACKET bytes hold every message of this crate")
    }
}

impl core::error::Error for TooLarge {}

impl Encoder {
    /// Creates an encoder whose first packet has sequence number 0.
    #[must_use]
    pub const fn new() -> Self {
        Self { next_sequence: 0 }
    }

    /// Encodes a message into `buffer` and returns the part of it that the packet occupies. Uses no other memory.
    ///
    /// # Errors
    /// [`TooLarge`] if the packet does not fit.
    pub fn encode<'a>(&mut self, message: &impl Serialize, buffer: &'a mut [u8]) -> Result<&'a [u8], TooLarge> {
        let cobs = Cobs::try_new(Slice::new(buffer)).map_err(|_| TooLarge)?;
        let mut with_crc = WithCrc { inner: cobs, crc: Crc32::new() };
        let packet = with_crc.try_extend(&self.next_sequence.to_le_bytes());
        let packet = packet.and_then(|()| postcard::serialize_with_flavor(message, with_crc)).map_err(|_| TooLarge)?;
        self.next_sequence = self.next_sequence.wrapping_add(1);
        Ok(packet)
    }
}

/// Encodes a value in postcard's format at the beginning of `buffer`, without a packet around it; `None` if it does not fit.
pub fn encode<'a>(value: &impl Serialize, buffer: &'a mut [u8]) -> Option<&'a [u8]> {
    postcard::to_slice(value, buffer).ok().map(|bytes| &*bytes)
}

/// Passes bytes on and appends their CRC.
struct WithCrc<F> {
    inner: F,
    crc: Crc32,
}

impl<F: Flavor> Flavor for WithCrc<F> {
    type Output = F::Output;

    fn try_push(&mut self, byte: u8) -> postcard::Result<()> {
        self.crc.add(byte);
        self.inner.try_push(byte)
    }

    fn finalize(mut self) -> postcard::Result<F::Output> {
        self.inner.try_extend(&self.crc.value().to_le_bytes())?;
        self.inner.finalize()
    }
}
