//! `#[output]`, `#[modulation]` and the calls of `#[action]`: outputs and calls for an operator.

use proc_macro2::Ident;
use syn::{Attribute, Expr, FnArg, Pat, PatType, ReturnType, Type};

use super::block::Function;
use super::model::{Modulation, Output};
use super::signature::Wanted;
use super::{arguments, attributes, driving, output_options, signature};
use crate::code::Code;
use crate::params::field::{self, Keys};
use crate::params::model::Field;
use crate::report::{Mistake, Report};
use crate::{text, wording};

/// The attributes of an argument.
const KEYS: [&str; 5] = ["range", "unit", "step", "default", "place"];

/// Names that a user may try for them.
const SYNONYMS: [(&str, &str); 8] = [
    ("min", "range"),
    ("max", "range"),
    ("limits", "range"),
    ("bounds", "range"),
    ("value", "default"),
    ("increment", "step"),
    ("param", "range"),
    ("frame", "place"),
];

/// Reads a getter.
pub(super) fn output(function: &Function, attribute: &Attribute, own: &Type, report: &mut Report) -> Option<Output> {
    let (unit, placement) = report.take(output_options::parse(attribute))?;
    let (name, doc) = described(function, "output", report);
    signature::read_operator(&function.signature, own, Wanted::Shared, report);
    for input in function.signature.inputs.iter().filter(|input| matches!(input, FnArg::Typed(_))) {
        report.add(input, wording::OUTPUT_ARGUMENTS);
    }
    match &function.signature.output {
        ReturnType::Type(_, kind) if text::written(kind) != "()" => {
            Some(Output { name, doc, unit, placement, ty: (**kind).clone() })
        }
        _ => {
            report.add(&name, wording::output_value(&text::name(&name)));
            None
        }
    }
}

/// Reads a method, and takes the attributes of its arguments off.
pub(super) fn modulation(
    function: &mut Function,
    attribute: &Attribute,
    own: &Type,
    report: &mut Report,
) -> Option<Modulation> {
    let word = report.take(attributes::modulation(attribute)).flatten();
    let (stops, drives) = (word == Some("stop"), word == Some("drives"));
    if let Some(argument) = function.signature.inputs.iter().find(|input| stops && matches!(input, FnArg::Typed(_))) {
        report.add(argument, wording::STOP_ARGUMENTS);
    }
    if let ReturnType::Type(_, kind) = &function.signature.output
        && text::written(kind) != "()"
    {
        report.add(kind, wording::returns_nothing(&text::name(&function.signature.ident)));
    }
    let called = call(function, "modulation", own, report)?;
    if drives {
        driving::check(&called.name, &called.arguments, report);
    }
    Some(Modulation { stops, drives, ..called })
}

/// Reads a method that an operator may call, whatever it returns, and takes the attributes of its arguments off.
pub(super) fn call(function: &mut Function, role: &str, own: &Type, report: &mut Report) -> Option<Modulation> {
    let (name, doc) = described(function, role, report);
    let wanted = if role == "action" { Wanted::World } else { Wanted::Exclusive };
    signature::read_operator(&function.signature, own, wanted, report);
    let mut all = Vec::new();
    for input in &mut function.signature.inputs {
        if let FnArg::Typed(input) = input {
            all.push(argument(input, report));
        }
    }
    let arguments = all.into_iter().collect::<Option<Vec<_>>>()?;
    Some(Modulation { name, doc, stops: false, drives: false, arguments })
}

/// Name and doc comment of a function, which it must have.
fn described(function: &Function, role: &str, report: &mut Report) -> (Ident, String) {
    let (name, doc) = (&function.signature.ident, text::doc(&function.attributes));
    if doc.is_empty() {
        report.add(name, wording::operator_doc(role, &text::name(name)));
    }
    for condition in function.attributes.iter().filter(|attribute| attribute.path().is_ident("cfg")) {
        report.add(condition, wording::CONDITIONAL);
    }
    (name.clone(), doc)
}

fn argument(input: &mut PatType, report: &mut Report) -> Option<Field> {
    arguments::unconditional(&input.attrs, report);
    let ours = input.attrs.extract_if(.., |one| {
        one.path().is_ident("doc") || one.path().get_ident().is_some_and(|name| nearest(name).is_some())
    });
    let ours: Vec<Attribute> = ours.collect();
    let (mut keys, mut good) = (Keys::default(), true);
    for attribute in ours.iter().filter(|attribute| !attribute.path().is_ident("doc")) {
        good &= report.take(key(attribute, &mut keys)).is_some();
    }
    let Pat::Ident(name) = &*input.pat else {
        report.add(&input.pat, wording::ARGUMENT_NAME);
        return None;
    };
    if !good {
        return None;
    }
    field::field(&name.ident, text::doc(&ours), &input.ty, keys, report)
}

fn nearest(name: &Ident) -> Option<&'static str> {
    let name = name.to_string();
    let synonym = SYNONYMS.iter().find(|(other, _)| *other == name).map(|(_, ours)| *ours);
    synonym.or_else(|| text::nearest(&name, KEYS.into_iter()))
}

/// Reports the attributes of arguments of a function that no operator calls, and takes them off.
pub(super) fn no_keys(function: &mut Function, report: &mut Report) {
    for input in &mut function.signature.inputs {
        let FnArg::Typed(input) = input else { continue };
        let is_ours =
            |one: &mut Attribute| one.path().get_ident().is_some_and(|name| KEYS.iter().any(|key| name == key));
        for attribute in input.attrs.extract_if(.., is_ours) {
            report.add(attribute.path(), wording::key_without_role(&text::written(attribute.path())));
        }
    }
}

/// `#[range(a..=b)]`, `#[unit("m")]`, `#[step(0.1)]`, `#[default(0.5)]`, `#[place("field.x")]`
fn key(attribute: &Attribute, keys: &mut Keys) -> Result<(), Mistake> {
    let written = text::written(attribute.path());
    if !KEYS.contains(&written.as_str()) {
        let meant = attribute.path().get_ident().and_then(nearest).unwrap_or_default().to_owned();
        return Err(Mistake::new(attribute.path(), Code::MisspeltAttribute { found: written, meant }));
    }
    let form = |_| syn::Error::new_spanned(attribute, wording::argument_form(&written));
    let value: Expr = attribute.parse_args().map_err(form)?;
    match written.as_str() {
        "range" => keys.range = Some(field::range(value)?),
        "unit" => keys.unit = Some(field::unit(&value)?),
        "step" => keys.step = Some(value),
        "place" => keys.place = Some(field::place(&value)?),
        _ => keys.default = Some(value),
    }
    Ok(())
}
