//! Texts that are cut to a length.

use bica_wire::truncate;

#[test]
fn cut_text_ends_at_a_whole_character() {
    let text = "aé€𝄞b€".repeat(9);
    for max in 0..=text.len() + 1 {
        let cut = truncate(&text, max);
        assert!(text.starts_with(cut) && cut.len() <= max, "{max}");
        let longer = text[cut.len()..].chars().next().map(char::len_utf8);
        assert!(longer.is_none_or(|next| cut.len() + next > max), "{max}");
    }
}
