//! Arguments: links, the time, rates, parameters.

use proc_macro2::Ident;
use quote::ToTokens;
use syn::{
    Attribute, FnArg, GenericArgument, Generics, Lifetime, PathArguments, PathSegment, Signature, Type, TypePath,
    TypeReference, parse_quote,
};

use super::model::Argument;
use super::{found, role, work};
use crate::report::Report;
use crate::types::{plain, unsized_argument};
use crate::{text, types, wording};

/// Types of the language that can be no components.
const VALUES: [&str; 17] = [
    "bool", "char", "str", "f32", "f64", "u8", "u16", "u32", "u64", "u128", "usize", "i8", "i16", "i32", "i64", "i128",
    "isize",
];

/// Types of libraries: a component of such a name is written with its path.
const OF_LIBRARIES: [&str; 5] = ["String", "Instant", "Duration", "ComponentId", "Setting"];

/// Generic types of the standard library around what was meant. Without a type in angle brackets it is another type.
const WRAPPERS: [&str; 9] = ["Vec", "Box", "Option", "Result", "Rc", "Arc", "RefCell", "Mutex", "RwLock"];

/// The form that the role of a function asks for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Form {
    /// Links of both kinds.
    Step,
    /// The same, and what a transition found.
    Entry,
    /// Links that read, and a `bool`.
    Condition,
    /// No links.
    Plain,
}

/// Reads the arguments beside `self`. A wrong one is left out.
pub(crate) fn read(signature: &Signature, own: &Type, form: Form, report: &mut Report) -> Vec<Argument> {
    let mut arguments = Vec::new();
    let mut seen: Vec<String> = Vec::new();
    for input in &signature.inputs {
        let FnArg::Typed(input) = input else { continue };
        unconditional(&input.attrs, report);
        if form == Form::Plain && !is_tuned(&input.ty) && !found::is_found(&input.ty) {
            report.add(input, wording::HOOK_LINKS);
            continue;
        }
        let Some(argument) = argument(&input.ty, own, form, signature, report) else { continue };
        let place = key(&argument);
        if seen.contains(&place) {
            let problem = match argument {
                Argument::Found(_) => wording::FOUND_TWICE.to_owned(),
                Argument::Work(_) | Argument::Age(_) | Argument::Outcome(_) => wording::TWICE.to_owned(),
                _ => wording::two_links(&place),
            };
            report.add(&input.ty, problem);
        } else {
            seen.push(place);
            arguments.push(argument);
        }
    }
    arguments
}

/// What two arguments of one signature may not have in common.
fn key(argument: &Argument) -> String {
    match argument {
        Argument::Read(child) | Argument::Write(child) => text::written(child),
        Argument::Rate(child) => format!("Rate<{}>", text::written(child)),
        Argument::Age(child) => format!("Age<{}>", text::written(child)),
        Argument::Outcome(child) => format!("Outcome<{}>", text::written(child)),
        Argument::OwnRate => "Rate<Self>".to_owned(),
        Argument::Time(_) => "Time".to_owned(),
        Argument::Tuned(kind) => format!("Tuned<{}>", text::written(kind)),
        Argument::Found(_) => "Found".to_owned(),
        Argument::Work(_) => "Work".to_owned(),
    }
}

/// Reports a `cfg` of an argument.
pub(crate) fn unconditional(attributes: &[Attribute], report: &mut Report) {
    let conditions = ["cfg", "cfg_attr"];
    for attribute in attributes.iter().filter(|one| conditions.iter().any(|name| one.path().is_ident(name))) {
        report.add(attribute, wording::CONDITIONAL_ARGUMENT);
    }
}

/// Reports a lifetime that has a name.
pub(crate) fn no_lifetime(lifetime: &Lifetime, report: &mut Report) {
    if lifetime.ident != "_" {
        report.add(lifetime, wording::lifetime(&lifetime.to_string()));
    }
}

/// What an argument of a type means in some function of the component `own`; `None` if it is no input.
#[must_use]
pub fn meaning(kind: &Type, own: &Type) -> Option<Argument> {
    let as_in = |form| argument(kind, own, form, &parse_quote!(fn step()), &mut Report::default());
    as_in(Form::Entry).or_else(|| as_in(Form::Condition))
}

fn argument(kind: &Type, own: &Type, form: Form, signature: &Signature, report: &mut Report) -> Option<Argument> {
    if found::is_found(kind) {
        return found::argument(kind, form, report).map(|found| Argument::Found(Box::new(found)));
    }
    let reference = match plain(kind) {
        Type::Reference(reference) => reference,
        Type::Path(path) => return owned(path, form, report),
        Type::ImplTrait(role) => {
            report.add(role, wording::owned_role(&text::written(role)));
            return None;
        }
        other => return no_component(other, report),
    };
    let path = match plain(&reference.elem) {
        Type::Path(path) => path,
        Type::ImplTrait(role) => {
            return role::is_one_trait(role, report).then(|| link(reference, own, form, report)).flatten();
        }
        Type::TraitObject(of) => {
            report.add(&reference.elem, wording::dyn_role(&text::written(&of.bounds)));
            return None;
        }
        _ => return no_component(plain(kind), report),
    };
    let segment = path.path.segments.last()?;
    if let Some(problem) = no_value(path) {
        report.add(kind, problem);
        return None;
    }
    // Lifetimes that the function declares are reported there.
    if let Some(lifetime) = &reference.lifetime
        && signature.generics.params.is_empty()
    {
        no_lifetime(lifetime, report);
    }
    match segment.ident.to_string().as_str() {
        "Time" => time(reference, report),
        "Rate" => rate(reference, segment, own, form, report),
        "Age" => age(reference, segment, own, report),
        "Outcome" => outcome(reference, segment, form, report),
        "Tuned" => tuned(reference, segment, report),
        "Work" => work::argument(reference, segment, own, form, report),
        _ => link(reference, own, form, report),
    }
}

/// The message about an argument without `&`.
fn owned(path: &TypePath, form: Form, report: &mut Report) -> Option<Argument> {
    let written = text::written(path);
    let problem = match path.path.segments.last()?.ident.to_string().as_str() {
        "Option"
            if form == Form::Entry
                && let Some(of) = path.path.segments.last().and_then(only_type) =>
        {
            wording::owned_entry(&text::written(of))
        }
        _ if let Some(problem) = no_value(path) => problem,
        "Time" => wording::owned_time(&written),
        "Rate" => wording::owned_rate(&written),
        "Age" => wording::owned_age(&written),
        "Outcome" => wording::owned_outcome(&written),
        "Work" => wording::WORK_ARGUMENT.to_owned(),
        "Tuned" => wording::owned_tuned(&written),
        _ if form == Form::Condition => wording::owned_condition(&written),
        _ if form == Form::Entry => wording::owned_entry(&written),
        _ => wording::owned(&written),
    };
    report.add(path, problem);
    None
}

/// Whether the language has a type of that name.
pub(super) fn is_value(name: &Ident) -> bool {
    VALUES.iter().any(|value| name == value)
}

/// The message about a type that can be no component.
fn no_value(path: &TypePath) -> Option<String> {
    let (written, last) = (text::written(path), path.path.segments.last()?);
    let is_one_of = |names: &[&str]| names.iter().any(|name| last.ident == name);
    let is_of_std = ["std", "core", "alloc"].iter().any(|root| path.path.segments[0].ident == root);
    if is_one_of(&WRAPPERS) && (is_of_std || path.path.segments.len() == 1) {
        let inner = plain(only_type(last)?);
        let inner = if let Type::Reference(reference) = inner { plain(&reference.elem) } else { inner };
        // A remedy that would be refused is none.
        return Some(match inner {
            Type::Path(path) if no_value(path).is_none() => wording::wrapped(&written, &text::written(inner)),
            _ => wording::value(&written),
        });
    }
    if path.path.segments.len() > 1 {
        return is_of_std.then(|| wording::value(&written));
    }
    if is_one_of(&OF_LIBRARIES) {
        return Some(wording::value_of_library(&written));
    }
    is_one_of(&VALUES).then(|| wording::value(&written))
}

fn no_component(kind: &Type, report: &mut Report) -> Option<Argument> {
    let written = text::written(kind);
    report
        .add(kind, if let Type::Tuple(_) = kind { wording::tuple(&written) } else { wording::no_component(&written) });
    None
}

fn time(reference: &TypeReference, report: &mut Report) -> Option<Argument> {
    if reference.mutability.is_some() {
        report.add(reference, wording::time(&text::written(&reference.elem)));
        return None;
    }
    Some(Argument::Time(plain(&reference.elem).clone()))
}

/// Whether the type is called `Tuned`, borrowed or not.
fn is_tuned(kind: &Type) -> bool {
    match plain(kind) {
        Type::Reference(reference) => is_tuned(&reference.elem),
        Type::Path(path) => path.path.segments.last().is_some_and(|last| last.ident == "Tuned"),
        _ => false,
    }
}

/// Reports a `&Tuned<P>` of a type parameter: its values would be no constant of the component.
pub(super) fn concrete(argument: &Argument, generics: &Generics, report: &mut Report) {
    if let Argument::Tuned(Type::Path(path)) = argument
        && generics.type_params().any(|parameter| path.path.is_ident(&parameter.ident))
    {
        report.add(path, wording::tuned_parameter(&text::written(path)));
    }
}

fn tuned(reference: &TypeReference, segment: &PathSegment, report: &mut Report) -> Option<Argument> {
    let Some(of) = only_type(segment) else {
        report.add(segment, wording::TUNED_OF_WHAT);
        return None;
    };
    if reference.mutability.is_some() {
        report.add(reference, wording::tuned(&text::written(&reference.elem)));
        return None;
    }
    is_named(of, report).then(|| Argument::Tuned(plain(of).clone()))
}

/// Reports a `&` or a role in the angle brackets of `Tuned` or `Rate`.
fn is_named(of: &Type, report: &mut Report) -> bool {
    match plain(of) {
        Type::Reference(reference) => report.add(of, wording::name_alone(&text::written(&reference.elem))),
        Type::ImplTrait(_) => report.add(of, wording::NO_ROLE),
        _ => return true,
    }
    false
}

/// `T` of a type that is written as `Name<T>`, by any path.
pub(super) fn only_type_of<'a>(kind: &'a Type, name: &str) -> Option<&'a Type> {
    let Type::Path(path) = plain(kind) else { return None };
    path.path.segments.last().filter(|last| last.ident == name).and_then(only_type)
}

/// The type in angle brackets.
pub(super) fn only_type(segment: &PathSegment) -> Option<&Type> {
    let PathArguments::AngleBracketed(list) = &segment.arguments else { return None };
    match list.args.first() {
        Some(GenericArgument::Type(of)) => Some(of),
        _ => None,
    }
}

fn rate(
    reference: &TypeReference,
    segment: &PathSegment,
    own: &Type,
    form: Form,
    report: &mut Report,
) -> Option<Argument> {
    let Some(of) = only_type(segment) else {
        report.add(segment, wording::RATE_OF_WHAT);
        return None;
    };
    if form == Form::Condition {
        report.add(reference, wording::RATE_IN_CONDITION);
        return None;
    }
    if reference.mutability.is_none() {
        report.add(reference, wording::rate(&text::written(of)));
        return None;
    }
    is_named(of, report).then(|| if is_own(of, own) { Argument::OwnRate } else { Argument::Rate(plain(of).clone()) })
}

fn age(reference: &TypeReference, segment: &PathSegment, own: &Type, report: &mut Report) -> Option<Argument> {
    let Some(of) = only_type(segment) else {
        report.add(segment, wording::AGE_OF_WHAT);
        return None;
    };
    if reference.mutability.is_some() {
        report.add(reference, wording::age(&text::written(&reference.elem)));
        return None;
    }
    match plain(of) {
        Type::ImplTrait(role) => return role::is_one_trait(role, report).then(|| Argument::Age(of.clone())),
        Type::TraitObject(role) => report.add(of, wording::dyn_role(&text::written(&role.bounds))),
        Type::Reference(inner) => report.add(of, wording::name_alone(&text::written(&inner.elem))),
        of if is_own(of, own) => report.add(reference, wording::OWN_AGE),
        of => return Some(Argument::Age(of.clone())),
    }
    None
}

fn outcome(reference: &TypeReference, segment: &PathSegment, form: Form, report: &mut Report) -> Option<Argument> {
    let Some(of) = only_type(segment) else {
        report.add(segment, wording::OUTCOME_OF_WHAT);
        return None;
    };
    if form != Form::Condition {
        report.add(reference, wording::OUTCOME_IN_CONDITION);
        return None;
    }
    if reference.mutability.is_some() {
        report.add(reference, wording::outcome(&text::written(&reference.elem)));
        return None;
    }
    match plain(of) {
        Type::ImplTrait(role) => report.add(of, wording::role_result(&text::written(&role.bounds))),
        Type::TraitObject(role) => report.add(of, wording::role_result(&text::written(&role.bounds))),
        Type::Reference(inner) => report.add(of, wording::name_alone(&text::written(&inner.elem))),
        of => return Some(Argument::Outcome(of.clone())),
    }
    None
}

fn link(reference: &TypeReference, own: &Type, form: Form, report: &mut Report) -> Option<Argument> {
    let child = plain(&reference.elem).clone();
    if let Some(of) = unsized_argument(&child) {
        report.add(of, wording::no_size(&text::written(of)));
        return None;
    }
    if let Some(lifetime) = types::lifetimes(&child).find(|lifetime| lifetime.ident != "static") {
        report.add(lifetime, wording::LINK_BORROWS);
        return None;
    }
    if is_own(&child, own) {
        report.add(reference, wording::OWN_LINK);
        return None;
    }
    match (&reference.mutability, form) {
        (Some(token), Form::Condition) => {
            report.add(token.to_token_stream(), wording::TRANSITION_WRITES);
            None
        }
        (Some(_), _) => Some(Argument::Write(child)),
        (None, _) => Some(Argument::Read(child)),
    }
}

pub(crate) fn is_own(kind: &Type, own: &Type) -> bool {
    let written = text::written(plain(kind));
    written == "Self" || written == text::written(own)
}
