//! Values of outputs and their schemas as bytes.

use bica_core::output::{OutputSink, OutputType};
use postcard::Serializer;
use postcard::ser_flavors::{Flavor, Slice};
use postcard_schema::schema::NamedType;
use serde::Serialize;

/// Sink that stores a value as bytes, and its schema. One type of sink does both, because each type needs a copy of all getters.
pub(super) struct OutputBytes<'a> {
    serializer: Serializer<Slice<'a>>,
    fits: bool,
    /// Schema of the value; `None` before one was taken.
    pub(super) schema: Option<&'static NamedType>,
}

impl<'a> OutputBytes<'a> {
    pub(super) fn new(room: &'a mut [u8]) -> Self {
        Self { serializer: Serializer { output: Slice::new(room) }, fits: false, schema: None }
    }

    /// Returns the bytes of the value; `None` if it is larger than the room.
    pub(super) fn finish(self) -> Option<&'a [u8]> {
        self.serializer.output.finalize().ok().filter(|_| self.fits).map(|bytes| &*bytes)
    }
}

impl OutputSink for OutputBytes<'_> {
    fn take<V: OutputType>(&mut self, value: &V) {
        self.schema = Some(V::SCHEMA);
        self.fits = value.serialize(&mut self.serializer).is_ok();
    }
}

/// A part of serialised bytes; the other bytes are dropped, so that they need no memory.
struct Part<'a> {
    /// Number of bytes before the part that are still to come.
    before: usize,
    room: &'a mut [u8],
    length: usize,
    /// Whether there are bytes after the part.
    more: bool,
}

impl Flavor for Part<'_> {
    type Output = (usize, bool);

    fn try_push(&mut self, byte: u8) -> postcard::Result<()> {
        if self.before > 0 {
            self.before -= 1;
        } else if let Some(place) = self.room.get_mut(self.length) {
            *place = byte;
            self.length += 1;
        } else {
            self.more = true;
        }
        Ok(())
    }

    fn finalize(self) -> postcard::Result<(usize, bool)> {
        Ok((self.length, self.more))
    }
}

/// Serialises the part of a schema that begins at an offset. Returns its length, and whether more follows.
pub(super) fn schema_part<S: Serialize>(schema: &S, offset: usize, room: &mut [u8]) -> (usize, bool) {
    postcard::serialize_with_flavor(schema, Part { before: offset, room, length: 0, more: false }).unwrap_or((0, false))
}
