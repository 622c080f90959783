//! Deserialization of `f32` arrays in a loop.
//!
//! The code that serde generates reads each element separately, which costs flash.

use core::fmt;

use serde::Deserializer;
use serde::de::{Error, SeqAccess, Visitor};

struct FloatArray<const N: usize>;

impl<'de, const N: usize> Visitor<'de> for FloatArray<N> {
    type Value = [f32; N];

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an array of numbers")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut sequence: A) -> Result<[f32; N], A::Error> {
        let mut values = [0.0; N];
        for (count, value) in values.iter_mut().enumerate() {
            *value = sequence.next_element()?.ok_or_else(|| A::Error::invalid_length(count, &self))?;
        }
        Ok(values)
    }
}

/// Reads `N` numbers.
pub(crate) fn deserialize<'de, const N: usize, D: Deserializer<'de>>(from: D) -> Result<[f32; N], D::Error> {
    from.deserialize_tuple(N, FloatArray)
}
