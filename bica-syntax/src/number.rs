//! Rates, budgets and times: number literals whose unit is in the name of their key.

use syn::{Expr, ExprLit, Lit, UnOp};

use super::report::Report;
use super::wording;

/// The suffixes that Rust gives to numbers; they change nothing here.
const TYPES: [&str; 15] =
    ["", "f32", "f64", "u8", "u16", "u32", "u64", "u128", "usize", "i8", "i16", "i32", "i64", "i128", "isize"];

/// Units that a user may write after a number, with their size in seconds or in hertz.
const UNITS: [(&str, f64); 8] =
    [("s", 1.0), ("ms", 1e-3), ("us", 1e-6), ("µs", 1e-6), ("ns", 1e-9), ("hz", 1.0), ("khz", 1e3), ("mhz", 1e6)];

/// The rate that a text of the options or of a tree gives, such as `(30)` or `30_u32`; `None` if it is no finite number above zero.
#[must_use]
pub fn hertz(text: &str) -> Option<f32> {
    positive(&syn::parse_str(text).ok()?, "hz", &mut Report::default())
}

/// A finite number above zero, whole or with a fraction; `None` with a mistake reported if it is not.
pub(crate) fn positive(value: &Expr, key: &str, report: &mut Report) -> Option<f32> {
    let problem = match literal(value) {
        Some(Literal { digits, suffix, .. }) if !TYPES.contains(&suffix.as_str()) => {
            wording::unit_after(key, &suffix, converted(&digits, &suffix, key).as_deref())
        }
        Some(Literal { digits, negative, .. }) => match digits.parse::<f32>() {
            Ok(number) if number.is_infinite() => wording::too_large(key),
            Ok(number) if number > 0.0 && !negative => return Some(number),
            Ok(_) => wording::not_positive(key),
            Err(_) => wording::no_number(key),
        },
        None => wording::no_number(key),
    };
    report.add(value, problem);
    None
}

/// A whole number of milliseconds; the message if it is none.
pub(crate) fn milliseconds(value: &Expr, key: &str) -> Result<u32, String> {
    match literal(value) {
        Some(Literal { digits, suffix, .. }) if !TYPES.contains(&suffix.as_str()) => {
            Err(wording::unit_after(key, &suffix, converted(&digits, &suffix, key).as_deref()))
        }
        Some(Literal { digits, negative: false, whole: true, .. }) => {
            digits.parse().map_err(|_| wording::too_long(key))
        }
        _ => Err(wording::not_whole(key)),
    }
}

/// The value of a literal of a whole number, also of a negative one.
pub(crate) fn whole(value: &Expr) -> Option<i128> {
    let number = literal(value).filter(|number| number.whole)?;
    let digits: i128 = number.digits.parse().ok()?;
    Some(if number.negative { -digits } else { digits })
}

/// The value of a literal of a number, also of a negative one.
pub(crate) fn value(value: &Expr) -> Option<f64> {
    let number = literal(value)?;
    let digits: f64 = number.digits.parse().ok()?;
    Some(if number.negative { -digits } else { digits })
}

/// Whether the value is a literal of a number.
pub(crate) fn is_literal(value: &Expr) -> bool {
    literal(value).is_some()
}

struct Literal {
    digits: String,
    suffix: String,
    negative: bool,
    whole: bool,
}

fn literal(value: &Expr) -> Option<Literal> {
    let plain = |digits: &str, suffix: &str, whole| {
        Some(Literal { digits: digits.to_owned(), suffix: suffix.to_owned(), negative: false, whole })
    };
    match value {
        Expr::Group(group) => literal(&group.expr),
        Expr::Paren(paren) => literal(&paren.expr),
        Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => {
            literal(&unary.expr).map(|number| Literal { negative: !number.negative, ..number })
        }
        Expr::Lit(ExprLit { lit: Lit::Int(number), .. }) => plain(number.base10_digits(), number.suffix(), true),
        Expr::Lit(ExprLit { lit: Lit::Float(number), .. }) => plain(number.base10_digits(), number.suffix(), false),
        _ => None,
    }
}

/// The number in the unit of the key, if the unit after it is known and of the same kind.
fn converted(digits: &str, suffix: &str, key: &str) -> Option<String> {
    let size = |unit: &str| UNITS.iter().find(|(name, _)| *name == unit).map(|(_, size)| *size);
    let unit = key.rsplit('_').next()?;
    let suffix = suffix.to_lowercase();
    if unit.ends_with("hz") != suffix.ends_with("hz") {
        return None;
    }
    let number = digits.parse::<f64>().ok()? * size(&suffix)? / size(unit)?;
    // Factors like 1e-3 / 1e-6 are not exact in binary.
    Some(format!("{}", (number * 1e6).round() / 1e6))
}

#[cfg(test)]
mod tests {
    use syn::parse_quote;

    use super::*;

    #[test]
    fn parentheses_and_types_change_nothing() {
        let values: [Expr; 5] =
            [parse_quote!(30), parse_quote!((30)), parse_quote!(30.0), parse_quote!(30_u32), parse_quote!(3e1f32)];
        for value in values {
            let mut report = Report::default();
            assert_eq!(positive(&value, "hz", &mut report), Some(30.0));
            assert!(report.is_empty());
        }
    }

    #[test]
    fn a_known_unit_is_converted() {
        for (digits, suffix, key, number) in [
            ("5", "ms", "budget_us", Some("5000")),
            ("2", "s", "after_ms", Some("2000")),
            ("1", "kHz", "cycle_hz", Some("1000")),
            ("250", "us", "budget_ms", Some("0.25")),
            ("3", "ms", "hz", None),
            ("3", "apples", "hz", None),
        ] {
            assert_eq!(converted(digits, suffix, key).as_deref(), number);
        }
    }

    #[test]
    fn what_is_no_finite_positive_number_is_refused() {
        let values: [Expr; 6] = [
            parse_quote!(0),
            parse_quote!(-1),
            parse_quote!(1e999),
            parse_quote!(RATE),
            parse_quote!("30"),
            parse_quote!(1kHz),
        ];
        for value in values {
            let mut report = Report::default();
            assert_eq!(positive(&value, "hz", &mut report), None);
            assert!(!report.is_empty());
        }
    }
}
