//! Texts in messages of bounded size.

/// Returns the longest beginning of a text of at most `max` bytes that ends between two characters.
#[must_use]
pub fn truncate(text: &str, max: usize) -> &str {
    text.split_at(text.floor_char_boundary(max)).0
}

/// Splits a text into parts of at most `max` bytes, at least 4, each of whole characters; none for an empty text.
pub(crate) fn parts(text: &str, max: usize) -> impl Iterator<Item = &str> + Clone {
    let mut rest = text;
    core::iter::from_fn(move || {
        let part = truncate(rest, max);
        rest = &rest[part.len()..];
        (!part.is_empty()).then_some(part)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_bounded_and_add_up_to_the_text() {
        let text = "aé€𝄞b€".repeat(9);
        for max in 4..80 {
            assert!(parts(&text, max).all(|part| (1..=max).contains(&part.len())), "{max}");
            let mut rest = text.as_str();
            for part in parts(&text, max) {
                rest = rest.strip_prefix(part).expect("parts are consecutive");
            }
            assert_eq!(rest, "", "{max}");
        }
        assert_eq!(parts("", 4).count(), 0);
        assert_eq!(truncate("a€", 3), "a");
    }
}
