//! Texts in messages of bounded size.

/// Returns the longest beginning of a text of at most `max` bytes that ends between two characters.
#[must_use]
pub fn truncate(text: &str, max: usize) -> &str {
    text.split_at(text.floor_char_boundary(max)).0
}
