//! Rules for declarations, checked when the program is compiled.
//!
//! Each mistake is reported once: a default or a step is not checked against a range that is itself wrong.

use super::{Kind, Param, ParamGroup, Value, Variant};
use crate::text::Text;

/// One, and what the difference of two decimal numbers may be off in `f32`.
const ROUNDED: f32 = 1.000_01;

/// Stops the compiler if the range holds no number.
///
/// # Panics
/// If it is so.
#[track_caller]
pub const fn assert_range(param: &Param) {
    if let Kind::F32 { min, max, .. } = param.kind
        && !(min.is_finite() && max.is_finite())
    {
        panic!("a range ends at finite numbers: write two of them, `a..=b`");
    }
    assert!(has_range(&param.kind), "this range is empty: write the smaller number first, `a..=b`");
}

const fn has_range(kind: &Kind) -> bool {
    match *kind {
        Kind::F32 { min, max, .. } => min.is_finite() && max.is_finite() && min <= max,
        Kind::I32 { min, max, .. } => min <= max,
        Kind::U32 { min, max, .. } => min <= max,
        Kind::Bool | Kind::Choice { .. } => true,
    }
}

/// Stops the compiler if the default is outside the range.
///
/// # Panics
/// If it is so.
#[track_caller]
pub const fn assert_default(param: &Param) {
    if !has_range(&param.kind) {
        return;
    }
    match (param.kind, param.default) {
        (Kind::F32 { min, max, .. }, Value::F32(default)) if !(default >= min && default <= max) => {
            outside(default as f64, min as f64, max as f64);
        }
        (Kind::I32 { min, max, .. }, Value::I32(default)) if default < min || default > max => {
            outside(default as f64, min as f64, max as f64);
        }
        (Kind::U32 { min, max, .. }, Value::U32(default)) if default < min || default > max => {
            outside(default as f64, min as f64, max as f64);
        }
        _ => {}
    }
}

/// Stops the compiler if the step leads nowhere, or out of the range.
///
/// # Panics
/// If it is so.
#[track_caller]
pub const fn assert_step(param: &Param) {
    let good = match param.kind {
        Kind::F32 { step: Some(step), .. } => step > 0.0 && step.is_finite(),
        Kind::I32 { step: Some(step), .. } => step > 0,
        Kind::U32 { step: Some(step), .. } => step > 0,
        _ => true,
    };
    assert!(good, "a step is a finite number above zero");
    let fits = match param.kind {
        Kind::F32 { min, max, step: Some(step) } => step <= (max - min) * ROUNDED,
        Kind::I32 { min, max, step: Some(step) } => step as i64 <= max as i64 - min as i64,
        Kind::U32 { min, max, step: Some(step) } => step as i64 <= max as i64 - min as i64,
        _ => true,
    };
    assert!(fits || !has_range(&param.kind), "this step is larger than the range: write a smaller one");
}

/// The default of an argument that declares none: the number of the range that is nearest to zero, `false`, or the first
/// variant.
#[must_use]
pub const fn natural_default(kind: &Kind) -> Value {
    match *kind {
        Kind::F32 { min, max, .. } => Value::F32(if min > 0.0 {
            min
        } else if max < 0.0 {
            max
        } else {
            0.0
        }),
        Kind::I32 { min, max, .. } => Value::I32(if min > 0 {
            min
        } else if max < 0 {
            max
        } else {
            0
        }),
        Kind::U32 { min, .. } => Value::U32(min),
        Kind::Bool => Value::Bool(false),
        Kind::Choice { .. } => Value::Choice(0),
    }
}

#[track_caller]
const fn outside(default: f64, min: f64, max: f64) {
    let mut text = Text::<128>::new();
    text.push("the default ");
    text.push_number(default);
    text.push(" is outside the range ");
    text.push_number(min);
    text.push("..=");
    text.push_number(max);
    text.push(": change one of the two");
    panic!("{}", text.as_str());
}

/// Stops the compiler if the default values break the rule of their struct.
///
/// # Panics
/// If it is so.
#[track_caller]
pub const fn assert_rule(checked: Result<(), &str>) {
    if let Err(rule) = checked {
        let mut text = Text::<256>::new();
        text.push("the default values break their rule: ");
        text.push(rule);
        panic!("{}", text.as_str());
    }
}

/// The index of the variant of that name, of an enum that is a parameter.
///
/// # Panics
/// If there is none, which stops the compiler.
#[must_use]
#[track_caller]
pub const fn variant(variants: &[Variant], name: &str) -> u32 {
    let mut index = 0;
    while index < variants.len() {
        if equal(variants[index].name, name) {
            return index as u32;
        }
        index += 1;
    }
    panic!("the default of an enum is one of its variants, by name: write `Enum::Variant`");
}

/// Stops the compiler if two parameters of one component have one name; the group at `index` is new.
///
/// # Panics
/// If it is so.
#[track_caller]
pub const fn assert_distinct_names(groups: &[ParamGroup], index: usize) {
    let mut earlier = 0;
    while earlier < index {
        if let Some(name) = common(&groups[earlier], &groups[index]) {
            let mut text = Text::<256>::new();
            text.push("two parameters of this component are called `");
            text.push(name);
            text.push("`: rename one; if both arguments mean one struct, write its path alike");
            panic!("{}", text.as_str());
        }
        earlier += 1;
    }
}

const fn common(a: &ParamGroup, b: &ParamGroup) -> Option<&'static str> {
    let mut left = 0;
    while left < a.params.len() {
        let mut right = 0;
        while right < b.params.len() {
            if equal(a.params[left].name, b.params[right].name) {
                return Some(a.params[left].name);
            }
            right += 1;
        }
        left += 1;
    }
    None
}

pub(crate) const fn equal(a: &str, b: &str) -> bool {
    let (a, b) = (a.as_bytes(), b.as_bytes());
    if a.len() != b.len() {
        return false;
    }
    let mut byte = 0;
    while byte < a.len() {
        if a[byte] != b[byte] {
            return false;
        }
        byte += 1;
    }
    true
}
