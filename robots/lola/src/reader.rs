//! Reader of `MessagePack` values of one expected type.

use rmp::Marker;
use rmp::decode::{self, Bytes, RmpRead, ValueReadError, bytes::BytesReadError};

use crate::mistake::{Mistake, Undecoded};

/// Longest key, bytes.
const LONGEST_KEY: usize = 64;
/// Deepest nesting in the value of an unknown key.
const DEEPEST: u32 = 4;

type Read<T> = Result<T, Undecoded>;

/// Reader of the values of one map.
pub(crate) struct Reader<'a>(Bytes<'a>);

impl<'a> Reader<'a> {
    pub(crate) const fn new(bytes: &'a [u8]) -> Self {
        Self(Bytes::new(bytes))
    }

    /// Number of bytes that were read.
    pub(crate) const fn position(&self) -> usize {
        self.0.position() as usize
    }

    /// Number of entries of a map.
    pub(crate) fn map(&mut self) -> Read<u32> {
        decode::read_map_len(&mut self.0).map_err(or(Mistake::NoMap))
    }

    /// The next key.
    pub(crate) fn key(&mut self) -> Read<&'a str> {
        let length = decode::read_str_len(&mut self.0).map_err(or(Mistake::NoKey))? as usize;
        if length > LONGEST_KEY {
            return Err(Mistake::NoKey.into());
        }
        let bytes = self.take(length)?;
        core::str::from_utf8(bytes).map_err(|_| Mistake::NoKey.into())
    }

    /// An array of finite numbers, each a `float32`.
    pub(crate) fn floats<const N: usize>(&mut self, key: &'static str) -> Read<[f32; N]> {
        self.array(key, N)?;
        let mut values = [0.0_f32; N];
        for value in &mut values {
            *value = decode::read_f32(&mut self.0).map_err(or(Mistake::Type { key }))?;
        }
        if values.iter().all(|value| value.is_finite()) { Ok(values) } else { Err(Mistake::NotFinite { key }.into()) }
    }

    /// An array of small numbers, each a positive fixint.
    pub(crate) fn small<const N: usize>(&mut self, key: &'static str) -> Read<[u8; N]> {
        self.array(key, N)?;
        let mut values = [0; N];
        for value in &mut values {
            *value = decode::read_pfix(&mut self.0).map_err(or(Mistake::Type { key }))?;
        }
        Ok(values)
    }

    /// An array of Booleans.
    pub(crate) fn booleans<const N: usize>(&mut self, key: &'static str) -> Read<[bool; N]> {
        self.array(key, N)?;
        let mut values = [false; N];
        for value in &mut values {
            *value = decode::read_bool(&mut self.0).map_err(or(Mistake::Type { key }))?;
        }
        Ok(values)
    }

    /// An array of texts.
    pub(crate) fn texts<const N: usize>(&mut self, key: &'static str) -> Read<[&'a [u8]; N]> {
        self.array(key, N)?;
        let mut texts = [&[][..]; N];
        for text in &mut texts {
            let length = decode::read_str_len(&mut self.0).map_err(or(Mistake::Type { key }))?;
            *text = self.take(length as usize)?;
        }
        Ok(texts)
    }

    fn array(&mut self, key: &'static str, expected: usize) -> Read<()> {
        let found = decode::read_array_len(&mut self.0).map_err(or(Mistake::Type { key }))?;
        if found as usize == expected { Ok(()) } else { Err(Mistake::Length { key, expected, found }.into()) }
    }

    /// Reads past a value of any type.
    pub(crate) fn skip(&mut self) -> Read<()> {
        self.skip_within(DEEPEST)
    }

    fn skip_within(&mut self, depth: u32) -> Read<()> {
        let marker = decode::read_marker(&mut self.0).map_err(|_| Undecoded::Incomplete)?;
        let (bytes, values) = match marker {
            Marker::FixPos(_) | Marker::FixNeg(_) | Marker::Null | Marker::False | Marker::True => (0, 0),
            Marker::U8 | Marker::I8 => (1, 0),
            Marker::U16 | Marker::I16 => (2, 0),
            Marker::U32 | Marker::I32 | Marker::F32 => (4, 0),
            Marker::U64 | Marker::I64 | Marker::F64 => (8, 0),
            Marker::FixStr(length) => (usize::from(length), 0),
            Marker::Str8 | Marker::Bin8 => (self.number(1)?, 0),
            Marker::Str16 | Marker::Bin16 => (self.number(2)?, 0),
            Marker::FixArray(length) => (0, usize::from(length)),
            Marker::Array16 => (0, self.number(2)?),
            Marker::FixMap(length) => (0, 2 * usize::from(length)),
            Marker::Map16 => (0, 2 * self.number(2)?),
            // Longer values do not fit into a map of LoLA, and extensions do not occur.
            _ => return Err(Mistake::Unknown.into()),
        };
        self.take(bytes)?;
        if values > 0 && depth == 0 {
            return Err(Mistake::Unknown.into());
        }
        (0..values).try_for_each(|_| self.skip_within(depth - 1))
    }

    /// A length in one or two bytes, the most significant one first.
    fn number(&mut self, bytes: usize) -> Read<usize> {
        Ok(self.take(bytes)?.iter().fold(0, |number, &byte| number << 8 | usize::from(byte)))
    }

    fn take(&mut self, count: usize) -> Read<&'a [u8]> {
        let taken = self.0.remaining_slice().get(..count).ok_or(Undecoded::Incomplete)?;
        for _ in 0..count {
            self.0.read_u8().map_err(|_| Undecoded::Incomplete)?;
        }
        Ok(taken)
    }
}

/// A type that does not fit is this mistake; anything else means that bytes are missing.
fn or(mistake: Mistake) -> impl FnOnce(ValueReadError<BytesReadError>) -> Undecoded {
    move |error| match error {
        ValueReadError::TypeMismatch(_) => Undecoded::Wrong(mistake),
        _ => Undecoded::Incomplete,
    }
}
