//! Writer of `MessagePack` maps.

use rmp::encode::{self, buffer::ByteBuf};

/// Writer of one map. Memory takes every byte, so nothing can fail.
pub(crate) struct Writer(ByteBuf);

impl Writer {
    /// A map of this number of entries.
    pub(crate) fn new(entries: u32) -> Self {
        let mut bytes = ByteBuf::with_capacity(1024);
        _ = encode::write_map_len(&mut bytes, entries);
        Self(bytes)
    }

    fn array(&mut self, key: &str, length: usize) {
        _ = encode::write_str(&mut self.0, key);
        _ = encode::write_array_len(&mut self.0, length as u32);
    }

    pub(crate) fn floats(&mut self, key: &str, values: &[f32]) {
        self.array(key, values.len());
        for &value in values {
            _ = encode::write_f32(&mut self.0, value);
        }
    }

    /// Numbers up to 127.
    pub(crate) fn small(&mut self, key: &str, values: &[u8]) {
        self.array(key, values.len());
        for &value in values {
            _ = encode::write_pfix(&mut self.0, value & 0x7f);
        }
    }

    pub(crate) fn texts(&mut self, key: &str, values: &[&str]) {
        self.array(key, values.len());
        for value in values {
            _ = encode::write_str(&mut self.0, value);
        }
    }

    pub(crate) fn finish(self) -> Vec<u8> {
        self.0.into_vec()
    }
}
