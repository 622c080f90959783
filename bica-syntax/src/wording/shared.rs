//! Messages of both macros: names, numbers.

pub(crate) const TWICE: &str = "this is written twice: remove one";
pub(crate) const EXTRA_COMMA: &str = "nothing stands before this comma: remove it";
pub(crate) const NO_SEMICOLON: &str = "commas separate these: write `,` in place of `;`";
pub(crate) const COMMA: &str = "a comma is missing before this";

pub(crate) fn unknown_key(found: &str, nearest: Option<&str>, known: &str) -> String {
    format!("there is no `{found}` here: {}", meant(nearest, known))
}

/// The end of a message about an unknown name.
pub(super) fn meant(nearest: Option<&str>, known: &str) -> String {
    nearest.map_or_else(|| format!("there is {known}"), |nearest| format!("did you mean `{nearest}`?"))
}

messages! {
    crate_form(example) = "this is the path of the framework, no text: write `{example}`";
    not_positive(key) = "`{key}` must be above zero";
    too_large(key) = "`{key}` must be finite: this number is too large for `f32`";
}

pub(crate) fn no_number(key: &str) -> String {
    let example = match key {
        "hz" => "hz = 30",
        "budget_us" => "budget_us = 40",
        "cycle_hz" => "cycle_hz: 100",
        "budget_ms" => "budget_ms: 10",
        _ => return format!("`{key}` needs a number literal"),
    };
    format!("`{key}` needs a number literal: `{example}`")
}

pub(crate) fn unit_after(key: &str, unit: &str, converted: Option<&str>) -> String {
    let of = match key.rsplit('_').next() {
        Some("us") => "microseconds",
        Some("ms") => "milliseconds",
        _ => "hertz",
    };
    let remedy = converted.map_or_else(|| format!("remove `{unit}`"), |number| format!("write `{number}`"));
    format!("`{key}` is in {of}, as its name says: {remedy}")
}

messages! {
    not_whole(key) = "`{key}` needs a whole number of milliseconds: `{key} = 1500`";
}

pub(crate) fn too_long(key: &str) -> String {
    format!("`{key}` is at most {}, which is 49 days", u32::MAX)
}
