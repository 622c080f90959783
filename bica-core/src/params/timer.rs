//! Parameters that are timers of transitions: `after = Approach::patience`.

use super::declare::equal;
use super::{Kind, ParamGroup, Value};
use crate::text::Text;

/// A number that can be the timer of a transition.
#[diagnostic::on_unimplemented(
    message = "a timer is a number, and this parameter is a `{Self}`",
    label = "no number",
    note = "make it an `f32` with `unit = \"s\"`, or a `u32` with `unit = \"ms\"`"
)]
pub trait Timer: Copy {
    /// Returns the time, ms.
    fn milliseconds(self) -> u32;
}

impl Timer for f32 {
    #[inline]
    fn milliseconds(self) -> u32 {
        of_seconds(self)
    }
}

impl Timer for i32 {
    #[inline]
    fn milliseconds(self) -> u32 {
        self.max(0).unsigned_abs()
    }
}

impl Timer for u32 {
    #[inline]
    fn milliseconds(self) -> u32 {
        self
    }
}

impl Value {
    /// Returns the time of a timer of this value, ms: seconds of an `f32`, rounded, and milliseconds of a whole number. A negative one is
    /// zero. `None` if it is no number.
    #[must_use]
    pub const fn milliseconds(self) -> Option<u32> {
        match self {
            Self::F32(seconds) => Some(of_seconds(seconds)),
            Self::U32(ms) => Some(ms),
            Self::I32(ms) => Some(if ms < 0 { 0 } else { ms.unsigned_abs() }),
            Self::Bool(_) | Self::Choice(_) => None,
        }
    }
}

#[inline]
const fn of_seconds(seconds: f32) -> u32 {
    (seconds * 1e3 + 0.5) as u32
}

/// Returns the index of the parameter `name` of the group at `place`, counted through all groups, and its default, ms. A parameter without
/// that name is reported by the compiler, as the struct has no such field.
///
/// # Panics
/// If it is neither a number of seconds nor a whole number of milliseconds, which stops the compiler.
#[must_use]
#[track_caller]
pub const fn timer(groups: &[ParamGroup], place: usize, name: &str) -> (u16, u32) {
    let (mut first, mut group) = (0, 0);
    while group < place {
        first += groups[group].params.len();
        group += 1;
    }
    let (params, mut index) = (groups[place].params, 0);
    while index < params.len() && !equal(params[index].name, name) {
        index += 1;
    }
    assert!(index < params.len(), "this field is no parameter: add `#[param(...)]` to it");
    let (unit, fits) = match params[index].kind {
        Kind::F32 { .. } => ("s", is(params[index].unit, "s")),
        _ => ("ms", is(params[index].unit, "ms")),
    };
    if let (true, Some(ms)) = (fits, params[index].default.milliseconds()) {
        return ((first + index) as u16, ms);
    }
    let mut text = Text::<256>::new();
    text.push("`");
    text.push(name);
    text.push("` is a timer here, and a timer has a unit: give this parameter `unit = \"");
    text.push(unit);
    text.push("\"` (`f32` in s, whole numbers in ms)");
    panic!("{}", text.as_str());
}

const fn is(unit: Option<&str>, wanted: &str) -> bool {
    match unit {
        Some(unit) => equal(unit, wanted),
        None => false,
    }
}
