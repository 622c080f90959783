//! Values of parameters as text.

use bica_core::Value;
use bica_core::params::{Kind, Variant};
use bica_core::refusal::Reason;

const VARIANTS: &[Variant] = &[Variant { name: "Left", doc: "" }, Variant { name: "Right", doc: "" }];
const F32: Kind = Kind::F32 { min: -1e9, max: 1e9, step: None };

#[test]
fn a_value_is_the_same_after_text() {
    for value in [0.1_f32, -0.0, 1.0, 1e9, 1.0e-7, f32::MIN_POSITIVE, 0.3 + 0.6] {
        let text = F32.text(Value::F32(value)).to_string();
        let Ok(Value::F32(back)) = F32.parse(&text) else { panic!("{text}") };
        assert_eq!(back.to_bits(), value.to_bits(), "{text}");
    }
    let cases = [
        (Kind::I32 { min: -5, max: 5, step: None }, Value::I32(-5), "-5"),
        (Kind::U32 { min: 0, max: u32::MAX, step: None }, Value::U32(u32::MAX), "4294967295"),
        (Kind::Bool, Value::Bool(true), "true"),
        (Kind::Choice { variants: VARIANTS }, Value::Choice(1), "Right"),
        (F32, Value::F32(2.0), "2.0"),
    ];
    for (kind, value, text) in cases {
        assert_eq!(kind.text(value).to_string(), text);
        assert_eq!(kind.parse(text), Ok(value));
    }
}

#[test]
fn text_that_is_no_value_is_refused_with_the_reason() {
    let wrong = |expected| Err(Reason::WrongKind { expected, found: "text" });
    assert_eq!(F32.parse("fast"), wrong("f32"));
    assert_eq!(F32.parse(""), wrong("f32"));
    assert_eq!(F32.parse("inf"), Err(Reason::NotFinite));
    let is_on: Kind = Kind::Bool;
    assert_eq!(is_on.parse("1"), wrong("bool"));
    let (count, offset): (Kind, Kind) =
        (Kind::U32 { min: 0, max: 9, step: None }, Kind::I32 { min: 0, max: 9, step: None });
    assert_eq!((count.parse("-1"), offset.parse("1.0")), (wrong("u32"), wrong("i32")));
    assert_eq!(Kind::Choice { variants: VARIANTS }.parse("left"), Err(Reason::UnknownVariant { count: 2 }));
    let (value, min, max) = (Value::F32(2e9), Value::F32(-1e9), Value::F32(1e9));
    assert_eq!(F32.parse("2e9"), Err(Reason::OutOfRange { value, min, max }));
}
