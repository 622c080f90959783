//! JSON whose whole numbers JavaScript reads exactly.

use std::io::{self, Write};

use serde::Serialize;
use serde_json::ser::{CompactFormatter, Formatter, Serializer};

/// Largest whole number up to which JavaScript represents each one exactly.
const LARGEST: u64 = (1 << 53) - 1;

/// Formatter that writes larger whole numbers as an object, `{"$int":"9007199254740993"}`. No other value has such a field.
struct Exact;

impl Exact {
    fn write<W: Write + ?Sized>(writer: &mut W, value: i128) -> io::Result<()> {
        write!(writer, r#"{{"$int":"{value}"}}"#)
    }
}

impl Formatter for Exact {
    fn write_u64<W: Write + ?Sized>(&mut self, writer: &mut W, value: u64) -> io::Result<()> {
        if value > LARGEST { Self::write(writer, value.into()) } else { CompactFormatter.write_u64(writer, value) }
    }

    fn write_i64<W: Write + ?Sized>(&mut self, writer: &mut W, value: i64) -> io::Result<()> {
        let is_large = value.unsigned_abs() > LARGEST;
        if is_large { Self::write(writer, value.into()) } else { CompactFormatter.write_i64(writer, value) }
    }
}

/// Returns a message as JSON for a page.
pub(super) fn to_string(message: &impl Serialize) -> String {
    let mut text = Vec::with_capacity(128);
    // Serialization into memory fails only for maps with keys that are no strings, and the protocol has none.
    let written = message.serialize(&mut Serializer::with_formatter(&mut text, Exact));
    written.ok().and_then(|()| String::from_utf8(text).ok()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    #[test]
    fn numbers_that_a_page_would_round_are_objects() {
        let value = json!([u64::MAX, 1_u64 << 53, (1_u64 << 53) - 1, i64::MIN, 0.1, -3]);
        let large = [r#"{"$int":"18446744073709551615"}"#, r#"{"$int":"9007199254740992"}"#];
        let rest = ["9007199254740991", r#"{"$int":"-9223372036854775808"}"#, "0.1", "-3"];
        assert_eq!(super::to_string(&value), format!("[{},{}]", large.join(","), rest.join(",")));
    }
}
