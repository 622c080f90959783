//! Decoding of packets from a stream of arbitrary bytes.

use core::fmt;

use serde::Deserialize;

use crate::crc::crc32;
use crate::message::LinkStats;
use crate::packet::{CRC_BYTES, SEQUENCE_BYTES};

/// Finds packets of up to `N` bytes in a stream of bytes. A longer packet counts as damaged.
#[derive(Clone, Debug)]
pub struct Decoder<const N: usize> {
    buffer: [u8; N],
    length: usize,
    /// Whether more bytes than the buffer holds have arrived since the last terminator.
    overrun: bool,
    expected_sequence: Option<u16>,
    stats: LinkStats,
}

/// An undamaged packet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Packet<'a> {
    bytes: &'a [u8],
    /// Number of packets missing directly before this one.
    pub missing_before: u16,
}

/// The packet is undamaged but contains no message of the expected type: the sender uses another schema.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UnknownMessage;

impl fmt::Display for UnknownMessage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("no message of this schema: compare `SCHEMA` with the schema in the robot's identity")
    }
}

impl core::error::Error for UnknownMessage {}

impl<'a> Packet<'a> {
    /// Decodes the message in the packet.
    ///
    /// # Errors
    /// [`UnknownMessage`] if the bytes are no `M`, or an `M` followed by more bytes.
    pub fn message<M: Deserialize<'a>>(&self) -> Result<M, UnknownMessage> {
        match postcard::take_from_bytes(self.bytes) {
            Ok((message, [])) => Ok(message),
            _ => Err(UnknownMessage),
        }
    }
}

/// Index of [`FromRobot::Identity`](crate::FromRobot::Identity), in every version.
const IDENTITY: u32 = 0;

impl Packet<'_> {
    /// Returns the schema in a robot's identity; `None` for another message. Unlike the message, it can be read whatever the
    /// schema is.
    #[must_use]
    pub fn identity_schema(&self) -> Option<u64> {
        let (variant, schema) = postcard::take_from_bytes::<(u32, u64)>(self.bytes).ok()?.0;
        (variant == IDENTITY).then_some(schema)
    }
}

impl<const N: usize> Decoder<N> {
    /// Creates a decoder that has received nothing yet.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            buffer: [0; N],
            length: 0,
            overrun: false,
            expected_sequence: None,
            stats: LinkStats { received: 0, damaged: 0, missing: 0 },
        }
    }

    /// Returns the packet counts since the decoder was created.
    #[must_use]
    pub const fn stats(&self) -> LinkStats {
        self.stats
    }

    /// Takes the next byte of the stream. Returns a packet if this byte terminates an undamaged one.
    pub fn push(&mut self, byte: u8) -> Option<Packet<'_>> {
        if byte != 0 {
            self.store(byte);
            return None;
        }
        let (length, overrun) = (self.length, self.overrun);
        (self.length, self.overrun) = (0, false);
        if length == 0 && !overrun {
            return None;
        }
        let Some((sequence, end)) = (!overrun).then(|| unpack(&mut self.buffer[..length])).flatten() else {
            self.stats.damaged = self.stats.damaged.wrapping_add(1);
            return None;
        };
        let missing_before = self.count(sequence);
        Some(Packet { bytes: &self.buffer[SEQUENCE_BYTES..end], missing_before })
    }

    fn store(&mut self, byte: u8) {
        match self.buffer.get_mut(self.length) {
            Some(place) => {
                *place = byte;
                self.length += 1;
            }
            None => self.overrun = true,
        }
    }

    /// Counts an undamaged packet and returns the number of packets missing before it.
    fn count(&mut self, sequence: u16) -> u16 {
        let gap = sequence.wrapping_sub(self.expected_sequence.unwrap_or(sequence));
        // A gap of half the number range or more is a step back: the sender restarted.
        let missing = if gap < 1 << 15 { gap } else { 0 };
        self.expected_sequence = Some(sequence.wrapping_add(1));
        self.stats.received = self.stats.received.wrapping_add(1);
        self.stats.missing = self.stats.missing.wrapping_add(missing.into());
        missing
    }
}

impl<const N: usize> Default for Decoder<N> {
    fn default() -> Self {
        Self::new()
    }
}

/// Decodes COBS in place and checks the CRC. Returns the sequence number and the end of the message.
fn unpack(packet: &mut [u8]) -> Option<(u16, usize)> {
    let length = cobs::decode_in_place(packet).ok()?;
    let end = length.checked_sub(CRC_BYTES).filter(|&end| end >= SEQUENCE_BYTES)?;
    let (content, crc) = packet.get(..length)?.split_at_checked(end)?;
    let &[low, high, ..] = content else { return None };
    (crc32(content).to_le_bytes() == crc).then_some((u16::from_le_bytes([low, high]), end))
}
