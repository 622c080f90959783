//! Texts that are cut to a length, and texts of values.

use bica_wire::model::Plain;
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

#[test]
fn text_of_a_large_number_is_short() {
    for (number, text) in [(0.9, "0.9"), (2.0, "2"), (4_294_967_295.0, "4294967295"), (-1e300, "-1e300")] {
        assert_eq!(Plain::Number(number).to_string(), text);
    }
}
