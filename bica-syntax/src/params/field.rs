//! One parameter: its type, and the keys of `#[param(default = ..., range = a..=b, unit = "...", step = ...)]`.

use proc_macro2::Ident;
use quote::ToTokens;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Attribute, Expr, ExprLit, ExprRange, Lit, Meta, RangeLimits, Token, Type};

use super::model::{Field, Kind, Number, NumberKind, Place};
use crate::code::Code;
use crate::comma::comma;
use crate::report::{Mistake, Report, coded};
use crate::types::plain;
use crate::{number, text, wording};

const KEYS: [&str; 4] = ["default", "range", "unit", "step"];
const KNOWN: &str = "`default`, `range`, `unit` and `step`";

/// Names that a user may try, and the key that was meant.
const SYNONYMS: [(&str, &str); 7] = [
    ("min", "range"),
    ("max", "range"),
    ("value", "default"),
    ("initial", "default"),
    ("units", "unit"),
    ("increment", "step"),
    ("resolution", "step"),
];

/// Types that can be no parameters, and the one to take instead.
const OTHER_NUMBERS: [(&str, &str); 11] = [
    ("f64", "f32"),
    ("i8", "i32"),
    ("i16", "i32"),
    ("i64", "i32"),
    ("i128", "i32"),
    ("isize", "i32"),
    ("u8", "u32"),
    ("u16", "u32"),
    ("u64", "u32"),
    ("u128", "u32"),
    ("usize", "u32"),
];
const NO_KINDS: [&str; 8] = ["String", "str", "char", "Option", "Vec", "Box", "Duration", "Instant"];

/// What stands in the attributes of a parameter.
#[derive(Default)]
pub(crate) struct Keys {
    pub(crate) default: Option<Expr>,
    pub(crate) range: Option<(Expr, Expr, ExprRange)>,
    pub(crate) unit: Option<String>,
    pub(crate) step: Option<Expr>,
    /// Only of an argument.
    pub(crate) place: Option<Place>,
}

/// Reads `#[param(...)]`; `None` with a mistake reported.
pub(crate) fn keys(attribute: &Attribute, report: &mut Report) -> Option<Keys> {
    let Meta::List(list) = &attribute.meta else {
        report.add(attribute, wording::PARAM_FORM);
        return None;
    };
    let mut keys = Keys::default();
    let mut seen: Vec<Ident> = Vec::new();
    let parsed = coded(|uncoded| {
        list.parse_args_with(|input: ParseStream| {
            while !input.is_empty() {
                one(input, &mut keys, &mut seen).map_err(&mut *uncoded)?;
                comma(input)?;
            }
            Ok(())
        })
    });
    report.take(parsed).map(|()| keys)
}

fn one(input: ParseStream, keys: &mut Keys, seen: &mut Vec<Ident>) -> Result<(), Mistake> {
    let key = input.call(Ident::parse_any).map_err(|found| syn::Error::new(found.span(), wording::PARAM_FORM))?;
    let name = key.to_string();
    if seen.contains(&key) {
        return Err(syn::Error::new(key.span(), wording::TWICE).into());
    }
    if !KEYS.contains(&name.as_str()) {
        let synonym = SYNONYMS.iter().find(|(other, _)| *other == name).map(|(_, ours)| *ours);
        let nearest = synonym.or_else(|| text::nearest(&name, KEYS.into_iter()));
        return Err(Mistake::new(key, Code::unknown_key(name, nearest, KNOWN)));
    }
    seen.push(key);
    let form = |found: syn::Error| syn::Error::new(found.span(), wording::param_value(&name));
    input.parse::<Token![=]>().map_err(form)?;
    let value: Expr = input.parse().map_err(form)?;
    match name.as_str() {
        "default" => keys.default = Some(value),
        "range" => keys.range = Some(range(value)?),
        "unit" => keys.unit = Some(unit(&value)?),
        _ => keys.step = Some(value),
    }
    Ok(())
}

/// `a..=b`
pub(crate) fn range(value: Expr) -> syn::Result<(Expr, Expr, ExprRange)> {
    match value {
        Expr::Range(range @ ExprRange { start: Some(_), end: Some(_), limits: RangeLimits::Closed(_), .. }) => {
            let (start, end) = (range.start.clone(), range.end.clone());
            match (start, end) {
                (Some(min), Some(max)) => Ok((*min, *max, range)),
                _ => Err(syn::Error::new_spanned(range, wording::RANGE_FORM)),
            }
        }
        Expr::Paren(paren) => range(*paren.expr),
        Expr::Group(group) => range(*group.expr),
        other => Err(syn::Error::new_spanned(other, wording::RANGE_FORM)),
    }
}

/// `"m/s"`
pub(crate) fn unit(value: &Expr) -> syn::Result<String> {
    match value {
        Expr::Lit(ExprLit { lit: Lit::Str(unit), .. }) if !unit.value().trim().is_empty() => Ok(unit.value()),
        _ => Err(syn::Error::new_spanned(value, wording::UNIT_FORM)),
    }
}

/// The coordinates of a place, and the variants that they are.
const AXES: [(&str, &str); 5] = [("x", "X"), ("y", "Y"), ("heading", "Heading"), ("column", "Column"), ("row", "Row")];

/// `"field.x"`
pub(crate) fn place(value: &Expr) -> syn::Result<Place> {
    let read = |text: &str| {
        let (frame, axis) = text.rsplit_once('.').filter(|(frame, _)| !frame.is_empty())?;
        let (_, variant) = AXES.into_iter().find(|(name, _)| *name == axis)?;
        Some(Place { frame: frame.to_owned(), axis: variant })
    };
    let place = match value {
        Expr::Lit(ExprLit { lit: Lit::Str(place), .. }) => read(&place.value()),
        _ => None,
    };
    place.ok_or_else(|| syn::Error::new_spanned(value, wording::PLACE_FORM))
}

/// A parameter from its parts; `None` with a mistake reported.
pub(crate) fn field(name: &Ident, doc: String, ty: &Type, keys: Keys, report: &mut Report) -> Option<Field> {
    let kind = kind(name, ty, &keys, report)?;
    Some(Field {
        name: name.clone(),
        doc,
        unit: keys.unit,
        ty: ty.clone(),
        kind,
        default: keys.default,
        place: keys.place,
    })
}

fn kind(name: &Ident, ty: &Type, keys: &Keys, report: &mut Report) -> Option<Kind> {
    let written = text::written(plain(ty));
    let Type::Path(path) = plain(ty) else {
        report.add(ty, wording::no_kind(&written, None));
        return None;
    };
    let last = path.path.segments.last().map(|segment| text::name(&segment.ident)).unwrap_or_default();
    let of = match last.as_str() {
        "f32" => NumberKind::F32,
        "i32" => NumberKind::I32,
        "u32" => NumberKind::U32,
        other => return other_kind(other, ty, keys, report),
    };
    if let Some((value, problem)) = misfit(keys, of, &last) {
        report.add(value, problem);
        return None;
    }
    let Some((min, max, _)) = keys.range.clone() else {
        report.add(name, wording::no_range(&text::name(name), &written));
        return None;
    };
    Some(Kind::Number(Box::new(Number { of, min, max, step: keys.step.clone() })))
}

/// The first literal among the keys that is no number of the type, and the message about it.
fn misfit<'k>(keys: &'k Keys, of: NumberKind, kind: &str) -> Option<(&'k Expr, String)> {
    let (min, max) = match of {
        NumberKind::I32 => (i64::from(i32::MIN), i64::from(i32::MAX)),
        NumberKind::F32 | NumberKind::U32 => (0, i64::from(u32::MAX)),
    };
    let ends = keys.range.iter().flat_map(|(min, max, _)| [min, max]);
    ends.chain(&keys.default).chain(&keys.step).find_map(|value| {
        let problem = match (number::whole(value), of) {
            (Some(number), NumberKind::F32) => wording::without_point(number),
            (Some(number), _) if number < i128::from(min) || number > i128::from(max) => {
                wording::does_not_fit(number, kind, min, max)
            }
            (None, NumberKind::I32 | NumberKind::U32) if number::is_literal(value) => wording::with_point(kind),
            _ => return None,
        };
        Some((value, problem))
    })
}

fn other_kind(last: &str, ty: &Type, keys: &Keys, report: &mut Report) -> Option<Kind> {
    let written = text::written(plain(ty));
    let instead = OTHER_NUMBERS.iter().find(|(other, _)| *other == last).map(|(_, ours)| *ours);
    if instead.is_some() || NO_KINDS.contains(&last) {
        report.add(ty, wording::no_kind(&written, instead));
        return None;
    }
    if last != "bool"
        && let Some(instead) = meant_by_alias(keys)
    {
        report.add(ty, wording::alias(&written, instead));
        return None;
    }
    let number_only = [
        keys.range.as_ref().map(|(.., range)| ("range", range.to_token_stream())),
        keys.step.as_ref().map(|step| ("step", step.to_token_stream())),
        keys.unit.as_ref().map(|_| ("unit", ty.to_token_stream())),
        keys.place.as_ref().map(|_| ("place", ty.to_token_stream())),
    ];
    let mut good = true;
    for (key, at) in number_only.into_iter().flatten() {
        report.add(at, wording::for_numbers(key, &written));
        good = false;
    }
    let kind = if last == "bool" { Kind::Bool } else { Kind::Choice };
    if let (Kind::Choice, Some(default)) = (&kind, &keys.default)
        && variant(default).is_none()
    {
        report.add(default, wording::choice_default(&written));
        good = false;
    }
    good.then_some(kind)
}

/// The type that was meant if the keys are none of an enum: its name is a type alias.
fn meant_by_alias(keys: &Keys) -> Option<&'static str> {
    match &keys.default {
        Some(Expr::Lit(ExprLit { lit: Lit::Bool(_), .. })) => Some("`bool`"),
        Some(default) if number::whole(default).is_some() => Some("`i32` or `u32`"),
        Some(default) if number::is_literal(default) => Some("`f32`"),
        default if keys.range.is_some() => {
            let is_variant = matches!(default, Some(Expr::Path(path)) if path.path.segments.len() > 1);
            (!is_variant).then_some("`f32`, `i32` or `u32`")
        }
        _ => None,
    }
}

/// The last name of a path, which is that of a variant.
#[must_use]
pub fn variant(default: &Expr) -> Option<String> {
    match default {
        Expr::Path(path) => path.path.segments.last().map(|segment| text::name(&segment.ident)),
        Expr::Group(group) => variant(&group.expr),
        Expr::Paren(paren) => variant(&paren.expr),
        _ => None,
    }
}
