//! Encoding of messages whose large data is transferred separately.
//!
//! The bytes of a text or byte string of [`MIN_BLOB`] bytes or more are removed from the encoded message; its length stays. The
//! removed bytes of a message, concatenated in order, are its *blobs*. Sequences are never removed, whatever their length.

use core::iter;

use bica_core::Format;
use postcard::de_flavors;
use postcard::ser_flavors::{ExtendFlavor, Flavor};
use postcard::{Deserializer, Error};
use serde::{Deserialize, Serialize};

/// Minimum length of a text or byte string that is removed from a message, bytes.
pub const MIN_BLOB: usize = 128;

/// Encodes a message at the end of `out`, without its blobs. Calls `take` for each blob with its bytes and the number of bytes of
/// the message that precede it. The rest of a [`Blob`](bica_core::Blob), its format and its frame, begins at this position.
///
/// Returns `None` if the message has a type that postcard refuses, such as a sequence of unknown length.
pub fn encode<E: Extend<u8>>(message: &impl Serialize, out: E, mut take: impl FnMut(usize, &[u8])) -> Option<E> {
    let flavor = TakeBlobs { inner: ExtendFlavor::new(out), position: 0, take: &mut take };
    postcard::serialize_with_flavor(message, flavor).ok()
}

/// Decodes a message with its blobs. If the blobs are absent or have too few bytes, the remaining texts and byte strings of
/// [`MIN_BLOB`] bytes or more are empty.
///
/// Returns `None` if the bytes are no such message.
#[must_use]
pub fn decode<'a, T: Deserialize<'a>>(message: &'a [u8], blobs: &'a [u8]) -> Option<T> {
    let mut deserializer = Deserializer::from_flavor(WithBlobs { message, blobs });
    let value = T::deserialize(&mut deserializer).ok()?;
    deserializer.finalize().ok()?.is_empty().then_some(value)
}

/// Reads the format and frame of a blob from the bytes that follow it in a message. A long text is not followed by them; its
/// format is [`Other`](Format::Other).
#[must_use]
pub fn described(rest: &[u8]) -> (Format<'_>, &str) {
    postcard::take_from_bytes(rest).map_or((Format::Other { media_type: "" }, ""), |(described, _)| described)
}

/// Removes blobs and passes the other bytes on. It calls the receiver of blobs through a pointer, because blobs are few: each
/// type then has one function that serialises it, not one for each receiver.
struct TakeBlobs<'t, F> {
    inner: F,
    /// Number of bytes passed on.
    position: usize,
    take: &'t mut dyn FnMut(usize, &[u8]),
}

impl<F: Flavor> Flavor for TakeBlobs<'_, F> {
    type Output = F::Output;

    fn try_push(&mut self, byte: u8) -> postcard::Result<()> {
        self.position += 1;
        self.inner.try_push(byte)
    }

    fn try_extend(&mut self, bytes: &[u8]) -> postcard::Result<()> {
        if bytes.len() >= MIN_BLOB {
            (self.take)(self.position, bytes);
            return Ok(());
        }
        self.position += bytes.len();
        self.inner.try_extend(bytes)
    }

    fn finalize(self) -> postcard::Result<F::Output> {
        self.inner.finalize()
    }
}

/// Source of a message and its blobs.
struct WithBlobs<'de> {
    message: &'de [u8],
    blobs: &'de [u8],
}

impl<'de> de_flavors::Flavor<'de> for WithBlobs<'de> {
    type Remainder = &'de [u8];
    type Source = iter::Empty<u8>;

    fn pop(&mut self) -> postcard::Result<u8> {
        let (first, rest) = self.message.split_first().ok_or(Error::DeserializeUnexpectedEnd)?;
        self.message = rest;
        Ok(*first)
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.message.len())
    }

    fn try_take_n(&mut self, count: usize) -> postcard::Result<&'de [u8]> {
        if count >= MIN_BLOB {
            let (taken, rest) = self.blobs.split_at_checked(count).unwrap_or_default();
            self.blobs = rest;
            return Ok(taken);
        }
        let (taken, rest) = self.message.split_at_checked(count).ok_or(Error::DeserializeUnexpectedEnd)?;
        self.message = rest;
        Ok(taken)
    }

    fn finalize(self) -> postcard::Result<&'de [u8]> {
        Ok(self.message)
    }
}
