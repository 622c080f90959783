//! Values of outputs and their schemas as bytes.

use bica::info::{InfoSink, Information};
use postcard::ser_flavors::Flavor;
use postcard_schema::schema::NamedType;

/// Sink that stores a value as bytes.
pub(super) struct ValueBytes<'a> {
    pub(super) room: &'a mut [u8],
    /// Number of bytes of the value; `None` if it is larger than the room.
    pub(super) length: Option<usize>,
}

impl InfoSink for ValueBytes<'_> {
    fn take<V: Information>(&mut self, value: &V) {
        self.length = postcard::to_slice(value, self.room).ok().map(|bytes| bytes.len());
    }
}

/// Sink that stores the schema of a value.
pub(super) struct SchemaOf(pub(super) Option<&'static NamedType>);

impl InfoSink for SchemaOf {
    fn take<V: Information>(&mut self, _value: &V) {
        self.0 = Some(V::SCHEMA);
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
pub(super) fn schema_part(schema: &NamedType, offset: usize, room: &mut [u8]) -> (usize, bool) {
    postcard::serialize_with_flavor(schema, Part { before: offset, room, length: 0, more: false }).unwrap_or((0, false))
}
