//! Messages of Protocol Buffers (<https://protobuf.dev/programming-guides/encoding>).

/// A message that is being written. A number that is zero is left out: it is the default.
#[derive(Clone, Debug, Default)]
pub(super) struct Protobuf(pub(super) Vec<u8>);

impl Protobuf {
    fn varint(&mut self, mut value: u64) -> &mut Self {
        while value >= 0x80 {
            self.0.push(value as u8 | 0x80);
            value >>= 7;
        }
        self.0.push(value as u8);
        self
    }

    fn tag(&mut self, number: u32, wire_type: u64) -> &mut Self {
        self.varint(u64::from(number) << 3 | wire_type)
    }

    pub(super) fn int(&mut self, number: u32, value: u64) -> &mut Self {
        if value == 0 { self } else { self.tag(number, 0).varint(value) }
    }

    pub(super) fn fixed32(&mut self, number: u32, value: u32) -> &mut Self {
        self.tag(number, 5).0.extend(value.to_le_bytes());
        self
    }

    pub(super) fn double(&mut self, number: u32, value: f64) -> &mut Self {
        if value != 0.0 {
            self.tag(number, 1).0.extend(value.to_le_bytes());
        }
        self
    }

    pub(super) fn doubles(&mut self, number: u32, values: &[f64]) -> &mut Self {
        let bytes: Vec<_> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
        self.bytes(number, &bytes)
    }

    pub(super) fn bytes(&mut self, number: u32, bytes: &[u8]) -> &mut Self {
        self.tag(number, 2).varint(bytes.len() as u64).0.extend_from_slice(bytes);
        self
    }

    pub(super) fn text(&mut self, number: u32, text: &str) -> &mut Self {
        self.bytes(number, text.as_bytes())
    }

    pub(super) fn nested(&mut self, number: u32, fill: impl FnOnce(&mut Self)) -> &mut Self {
        let mut inner = Self::default();
        fill(&mut inner);
        self.bytes(number, &inner.0)
    }

    pub(super) fn timestamp(&mut self, number: u32, nanoseconds: u64) -> &mut Self {
        self.nested(number, |time| {
            time.int(1, nanoseconds / 1_000_000_000).int(2, nanoseconds % 1_000_000_000);
        })
    }

    /// Adds a point, a vector or a quaternion, or a colour: numbered coordinates.
    pub(super) fn vector(&mut self, number: u32, coordinates: &[f64]) -> &mut Self {
        self.nested(number, |vector| {
            for (value, number) in coordinates.iter().zip(1..) {
                vector.double(number, *value);
            }
        })
    }
}
