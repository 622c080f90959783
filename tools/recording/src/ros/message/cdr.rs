//! CDR, the encoding of messages (OMG DDS-RTPS, section 10: plain CDR, version 1).

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::Field;

/// Header of a message in a file: CDR with little-endian numbers.
pub const CDR_LE: [u8; 4] = [0, 1, 0, 0];

/// A message that is being encoded. A number begins at a multiple of its length.
#[derive(Clone, Debug, Default)]
pub struct Cdr(pub(super) Vec<u8>);

impl Cdr {
    fn number<const N: usize>(&mut self, bytes: [u8; N]) {
        self.0.resize(self.0.len().next_multiple_of(N), 0);
        self.0.extend(bytes);
    }

    fn length(&mut self, length: usize) {
        self.number((length as u32).to_le_bytes());
    }
}

macro_rules! numbers {
    ($($kind:ty: $name:literal),*) => {
        $(impl Field for $kind {
            fn name() -> String {
                $name.to_owned()
            }

            fn encode(&self, out: &mut Cdr) {
                out.number(self.to_le_bytes());
            }
        })*
    };
}

numbers!(i8: "int8", u16: "uint16", i16: "int16", u32: "uint32", i32: "int32");
numbers!(u64: "uint64", i64: "int64", f32: "float32", f64: "float64");

impl Field for u8 {
    fn name() -> String {
        "uint8".to_owned()
    }

    fn encode(&self, out: &mut Cdr) {
        out.0.push(*self);
    }

    /// Images are long.
    fn encode_all(values: &[Self], out: &mut Cdr) {
        out.0.extend_from_slice(values);
    }
}

impl Field for bool {
    fn name() -> String {
        "bool".to_owned()
    }

    fn encode(&self, out: &mut Cdr) {
        out.0.push((*self).into());
    }
}

impl Field for String {
    fn name() -> String {
        "string".to_owned()
    }

    /// A text ends with a byte 0, which its length contains.
    fn encode(&self, out: &mut Cdr) {
        out.length(self.len() + 1);
        out.0.extend_from_slice(self.as_bytes());
        out.0.push(0);
    }
}

impl<F: Field> Field for Vec<F> {
    fn name() -> String {
        format!("{}[]", F::name())
    }

    fn define(all: &mut BTreeMap<String, String>) {
        F::define(all);
    }

    fn encode(&self, out: &mut Cdr) {
        out.length(self.len());
        F::encode_all(self, out);
    }
}

/// A byte of ROS: encoded as a number, but another type.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Byte(pub u8);

impl Field for Byte {
    fn name() -> String {
        "byte".to_owned()
    }

    fn encode(&self, out: &mut Cdr) {
        out.0.push(self.0);
    }
}

/// Array of exactly `N` numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fixed<const N: usize>(pub [f64; N]);

impl<const N: usize> Default for Fixed<N> {
    fn default() -> Self {
        Self([0.0; N])
    }
}

impl<const N: usize> Field for Fixed<N> {
    fn name() -> String {
        format!("float64[{N}]")
    }

    fn encode(&self, out: &mut Cdr) {
        for number in &self.0 {
            number.encode(out);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Encoded, Point, PointStamped, Text};

    #[test]
    fn numbers_begin_at_multiples_of_their_lengths() {
        let mut message = PointStamped { point: Point { x: 1.0, ..Point::default() }, ..PointStamped::default() };
        message.header.frame_id = "ab".to_owned();
        let Encoded(bytes) = Encoded::from(&message);
        // Two numbers of the time, length and text with its final 0, a padding byte, three coordinates.
        assert_eq!((bytes.len(), &bytes[8..15]), (16 + 24, &[3, 0, 0, 0, b'a', b'b', 0][..]));
        assert_eq!(bytes[16..24], 1.0_f64.to_le_bytes());
    }

    #[test]
    fn a_text_has_its_end_in_its_length() {
        assert_eq!(Encoded::from(&Text { data: "x".to_owned() }).0, [2, 0, 0, 0, b'x', 0]);
    }
}
