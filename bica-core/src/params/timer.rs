//! Parameters that are timers of transitions: `after = Approach::patience`.

use super::declare::equal;
use super::{Kind, Param, ParamGroup, Value};
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

/// Returns the index of the parameter `name` of the group at `place`, counted through all groups, and its default, ms.
///
/// A name that the group does not have, and a parameter that is no timer, are reported elsewhere.
#[must_use]
pub const fn timer(groups: &[ParamGroup], place: usize, name: &str) -> (u16, u32) {
    let (mut first, mut group) = (0, 0);
    while group < place {
        first += groups[group].params.len();
        group += 1;
    }
    let index = find(groups[place].params, name);
    let default =
        if index < groups[place].params.len() { groups[place].params[index].default.milliseconds() } else { None };
    match default {
        Some(ms) => ((first + index) as u16, ms),
        None => (0, 0),
    }
}

/// Stops the compiler if a parameter is neither a number of seconds nor a whole number of milliseconds. A struct with mistakes of its own,
/// which are reported already, has no parameters.
///
/// # Panics
/// If it is so.
#[track_caller]
pub const fn assert_timer(group: &ParamGroup, name: &str) {
    let index = find(group.params, name);
    if index == group.params.len() {
        return;
    }
    let wanted = match group.params[index].kind {
        Kind::F32 { .. } => "s",
        Kind::I32 { .. } | Kind::U32 { .. } => "ms",
        // What is no number does not implement `Timer`.
        Kind::Bool | Kind::Choice { .. } => return,
    };
    if let Some(unit) = group.params[index].unit
        && equal(unit, wanted)
    {
        return;
    }
    let mut text = Text::<256>::new();
    text.push("`");
    text.push(name);
    text.push("` is a timer here, and a timer has a unit: give this parameter `unit = \"");
    text.push(wanted);
    text.push("\"` (`f32` in s, whole numbers in ms)");
    panic!("{}", text.as_str());
}

/// The index of the parameter of that name; the number of parameters if there is none.
const fn find(params: &[Param], name: &str) -> usize {
    let mut index = 0;
    while index < params.len() && !equal(params[index].name, name) {
        index += 1;
    }
    index
}
