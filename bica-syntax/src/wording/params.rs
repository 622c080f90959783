//! Messages about parameters.

// The struct.
pub(crate) const PARAMS_STRUCT: &str =
    "parameters are the named fields of a struct: write `struct Name { ... }` with at least one field";
pub(crate) const PARAMS_GENERIC: &str = "parameters have concrete types: remove this";
pub(crate) const CHECK_FORM: &str = "a rule is a `const fn` of the struct: write `check = Self::name`";

messages! {
    params_doc(name) = "`{name}` has no doc comment: write above it what these parameters adjust, `/// ...`";
    param_doc(name) = "parameter `{name}` has no doc comment: write above it what it means, `/// ...`";
}

// The fields.
pub(crate) const PARAM_FORM: &str =
    "a parameter is described by `#[param(default = 0.5, range = 0.0..=1.0)]`, and by `unit` and `step` if it has them";
pub(crate) const RANGE_FORM: &str = "a range includes both of its ends: write `a..=b`";
pub(crate) const UNIT_FORM: &str = "a unit is a text such as \"m/s\"; leave it out for a pure number";

pub(crate) fn no_param(name: &str, kind: &str) -> String {
    let example = match kind {
        "bool" => "default = false",
        "i32" | "u32" => "default = 5, range = 0..=10",
        "f32" => "default = 0.5, range = 0.0..=1.0",
        _ => "default = ...",
    };
    format!("field `{name}` is no parameter yet: add `#[param({example})]`")
}

messages! {
    no_default(name) = "parameter `{name}` has no default: add `default = ...` to its `#[param(...)]`";
}

pub(crate) fn no_range(name: &str, kind: &str) -> String {
    let example = if kind == "f32" { "0.0..=1.0" } else { "0..=10" };
    format!("`{name}` is a number without a range: add one such as `{example}`")
}

pub(crate) fn param_value(key: &str) -> String {
    let example = match key {
        "default" => "default = 0.5",
        "range" => "range = 0.0..=1.0",
        "unit" => "unit = \"m/s\"",
        _ => "step = 0.01",
    };
    format!("`{key}` needs a value: `{example}`")
}

pub(crate) fn no_kind(written: &str, instead: Option<&str>) -> String {
    match instead {
        Some(instead) => format!("`{written}` is no kind of parameter: write `{instead}`"),
        None => format!(
            "`{written}` is no kind of parameter: take `f32`, `i32`, `u32`, `bool` or an enum with \
             `#[derive(ParamEnum)]`"
        ),
    }
}

messages! {
    for_numbers(key, kind) = "`{key}` is for numbers, and `{kind}` is none: remove `{key}`";
    alias(kind, instead) = "`#[derive(Params)]` reads names and takes `{kind}` for an enum: write {instead} instead";
}

pub(crate) fn does_not_fit(number: i128, kind: &str, min: i64, max: i64) -> String {
    format!("`{number}` does not fit into `{kind}`: write a number from {min} to {max}")
}

pub(crate) fn without_point(number: i128) -> String {
    format!("a number of the type `f32` has a point: write `{number}.0`")
}

messages! {
    with_point(kind) = "a number of the type `{kind}` is whole: write one, or make the parameter an `f32`";
    choice_default(kind) = "the default of an enum is one of its variants: write `default = {kind}::Variant`";
}

// Enums.
pub(crate) const CHOICE_ENUM: &str =
    "the choices of a parameter are the variants of an enum: write `enum Name { ... }`";

pub(crate) const CHOICE_CHECK: &str =
    "a rule is for the values of a struct with `#[derive(Params)]`: move it there, or remove it";

messages! {
    variant_fields(name) = "variant `{name}` has fields, but a choice is only a name: remove them";
}

// The argument.
pub(crate) const TUNED_OF_WHAT: &str = "`Tuned` holds a struct with `#[derive(Params)]`: write `&Tuned<Name>`";

messages! {
    tuned(written) = "parameters are only read, an operator sets them: write `&{written}`";
    tuned_parameter(name) =
        "`{name}` can be any type, but the parameters of a component are fixed: write the name of a struct";
    owned_tuned(written) = "parameters are borrowed: write `&{written}`";
}
