//! Text written by const functions, compared with the formatting of the standard library.

use bica_core::check::Text;
use proptest::prelude::*;

fn number(number: f64) -> String {
    let mut text = Text::<64>::new();
    text.push_number(number);
    text.as_str().into()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn text_is_truncated_at_character_boundaries(pieces in prop::collection::vec(".{0,12}", 0..6)) {
        let mut text = Text::<40>::new();
        let mut whole = String::new();
        for piece in &pieces {
            text.push(piece);
            whole.push_str(piece);
        }
        let mut end = whole.len().min(40);
        while !whole.is_char_boundary(end) {
            end -= 1;
        }
        prop_assert_eq!(text.as_str(), &whole[..end]);
    }

    #[test]
    fn integers_are_formatted_as_by_the_library(value: u64) {
        let mut text = Text::<64>::new();
        text.push_whole(value);
        prop_assert_eq!(text.as_str(), value.to_string());
    }

    #[test]
    fn short_decimals_are_kept(digits in -9_999_999..=9_999_999_i64, decimals in 0..6_i32) {
        let value = digits as f64 / 10_f64.powi(decimals);
        prop_assert_eq!(number(value), if digits == 0 { "0".into() } else { value.to_string() });
    }

    #[test]
    fn long_decimals_keep_seven_digits(value in -1e9_f32..1e9, scale in -6..3_i32) {
        let value = f64::from(value) * 10_f64.powi(scale);
        let read: f64 = number(value).parse().unwrap();
        prop_assert!((read - value).abs() <= value.abs() * 0.5e-6 + 1e-15, "{} for {}", read, value);
    }
}

#[test]
fn limits_of_the_number_types_are_formatted() {
    for (value, written) in
        [(0.0, "0"), (1e17, "100000000000000000"), (1e18, "inf"), (f64::NAN, "NaN"), (1e-20, "0"), (0.999_999_96, "1")]
    {
        assert_eq!(number(value), written);
    }
    assert_eq!(number(f64::NEG_INFINITY), "-inf");
    assert_eq!(number(f64::from(0.1_f32)), "0.1");
}
