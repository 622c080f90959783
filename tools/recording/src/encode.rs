//! Values in the format of a recording.

use serde::Serialize;

/// Appends a value in postcard.
pub(crate) fn encode(out: &mut Vec<u8>, value: &impl Serialize) {
    // Writing into a vector does not fail, and no message has a type that postcard refuses.
    if let Ok(bytes) = postcard::to_extend(value, std::mem::take(out)) {
        *out = bytes;
    }
}
