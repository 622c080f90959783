//! Texts in messages of bounded size.

/// Returns the longest beginning of a text of at most `max` bytes that ends between two characters.
#[must_use]
pub fn truncate(text: &str, max: usize) -> &str {
    // Not an index: its panic would link the formatting of texts, 3 KB, into a microcontroller's program.
    text.get(..text.floor_char_boundary(max)).unwrap_or(text)
}
