//! From bytes, whatever they are, to messages.

use core::fmt;

use serde::{Deserialize, Serialize};

use crate::crc::crc32;
use crate::packet::{CHECK, NUMBER};

/// Finds packets in a stream of bytes. Holds packets of up to `N` bytes; what is longer is damaged.
#[derive(Clone, Debug)]
pub struct Receiver<const N: usize> {
    room: [u8; N],
    length: usize,
    /// More came than there is room for.
    overrun: bool,
    next: Option<u16>,
    losses: Losses,
}

/// What a receiver counted since it was made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, postcard_schema::Schema)]
pub struct Losses {
    /// Packets that came whole.
    pub whole: u32,
    /// Packets that came damaged, or were noise.
    pub damaged: u32,
    /// Packets that did not come, by the gaps in their numbers; a damaged one leaves a gap too.
    pub missing: u32,
}

/// A packet that came whole.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Heard<'a> {
    bytes: &'a [u8],
    /// Packets missing right before it.
    pub missing: u16,
}

/// The packet came whole, and is no message that was asked for: the other end speaks another schema.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotUnderstood;

impl fmt::Display for NotUnderstood {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("no message of this schema: compare `SCHEMA` with the other end's greeting")
    }
}

impl core::error::Error for NotUnderstood {}

impl<'a> Heard<'a> {
    /// The message in the packet.
    ///
    /// # Errors
    /// [`NotUnderstood`] if the bytes are no `M`, or more than one.
    pub fn read<M: Deserialize<'a>>(&self) -> Result<M, NotUnderstood> {
        match postcard::take_from_bytes(self.bytes) {
            Ok((message, [])) => Ok(message),
            _ => Err(NotUnderstood),
        }
    }
}

impl<const N: usize> Receiver<N> {
    /// Has heard nothing yet.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            room: [0; N],
            length: 0,
            overrun: false,
            next: None,
            losses: Losses { whole: 0, damaged: 0, missing: 0 },
        }
    }

    /// What was counted so far.
    #[must_use]
    pub const fn losses(&self) -> Losses {
        self.losses
    }

    /// Takes the next byte of the stream; gives the packet that it ends, if that came whole.
    pub fn push(&mut self, byte: u8) -> Option<Heard<'_>> {
        if byte != 0 {
            self.keep(byte);
            return None;
        }
        let (length, overrun) = (self.length, self.overrun);
        (self.length, self.overrun) = (0, false);
        if length == 0 && !overrun {
            return None;
        }
        let Some((number, end)) = (!overrun).then(|| open(&mut self.room[..length])).flatten() else {
            self.losses.damaged = self.losses.damaged.wrapping_add(1);
            return None;
        };
        let missing = self.gap(number);
        Some(Heard { bytes: &self.room[NUMBER..end], missing })
    }

    fn keep(&mut self, byte: u8) {
        match self.room.get_mut(self.length) {
            Some(place) => {
                *place = byte;
                self.length += 1;
            }
            None => self.overrun = true,
        }
    }

    /// Notes a whole packet; how many are missing before it.
    fn gap(&mut self, number: u16) -> u16 {
        let gap = number.wrapping_sub(self.next.unwrap_or(number));
        // Half the numbers are the past: the other end began anew.
        let missing = if gap < 1 << 15 { gap } else { 0 };
        self.next = Some(number.wrapping_add(1));
        self.losses.whole = self.losses.whole.wrapping_add(1);
        self.losses.missing = self.losses.missing.wrapping_add(missing.into());
        missing
    }
}

impl<const N: usize> Default for Receiver<N> {
    fn default() -> Self {
        Self::new()
    }
}

/// Unpacks in place: the packet's number, and where its message ends.
fn open(packet: &mut [u8]) -> Option<(u16, usize)> {
    let length = cobs::decode_in_place(packet).ok()?;
    let end = length.checked_sub(CHECK).filter(|&end| end >= NUMBER)?;
    let (plain, check) = packet.get(..length)?.split_at_checked(end)?;
    let &[low, high, ..] = plain else { return None };
    (crc32(plain).to_le_bytes() == check).then_some((u16::from_le_bytes([low, high]), end))
}
