//! Arguments: links, the time, rates.

use quote::ToTokens;
use syn::{FnArg, GenericArgument, PathArguments, PathSegment, Signature, Type, TypeReference};

use super::model::Argument;
use super::signature::Form;
use crate::report::Report;
use crate::{text, wording};

/// Reads the arguments beside `self`.
pub(crate) fn read(signature: &Signature, own: &Type, form: Form, report: &mut Report) -> Vec<Argument> {
    let mut arguments = Vec::new();
    let mut seen: Vec<String> = Vec::new();
    for input in &signature.inputs {
        let FnArg::Typed(input) = input else { continue };
        if form == Form::Plain {
            report.add(input, wording::HOOK_LINKS);
            continue;
        }
        let Some(argument) = argument(&input.ty, own, form, report) else { continue };
        let place = text::written(&input.ty).replace("&mut ", "&");
        if seen.contains(&place) {
            report.add(&input.ty, wording::two_links(place.trim_start_matches('&')));
        } else {
            seen.push(place);
            arguments.push(argument);
        }
    }
    arguments
}

fn argument(kind: &Type, own: &Type, form: Form, report: &mut Report) -> Option<Argument> {
    let reference = match plain(kind) {
        Type::Reference(reference) => reference,
        Type::Path(_) => return complain(report, kind, wording::owned(&text::written(kind))),
        _ => return complain(report, kind, wording::no_component(&text::written(kind))),
    };
    let Type::Path(path) = plain(&reference.elem) else {
        return complain(report, &reference.elem, wording::no_component(&text::written(&reference.elem)));
    };
    let segment = path.path.segments.last()?;
    match segment.ident.to_string().as_str() {
        "Time" if reference.mutability.is_some() => complain(report, kind, wording::TIME),
        "Time" => Some(Argument::Time),
        "Rate" => rate(reference, segment, form, report),
        _ => link(reference, own, form, report),
    }
}

/// The type without the invisible brackets that a `macro_rules` macro puts around it.
fn plain(mut kind: &Type) -> &Type {
    while let Type::Group(group) = kind {
        kind = &group.elem;
    }
    kind
}

fn complain<T>(report: &mut Report, at: &impl ToTokens, message: impl std::fmt::Display) -> Option<T> {
    report.add(at, message);
    None
}

fn rate(reference: &TypeReference, segment: &PathSegment, form: Form, report: &mut Report) -> Option<Argument> {
    if reference.mutability.is_none() {
        return complain(report, reference, wording::RATE);
    }
    if form == Form::Condition {
        return complain(report, &reference.mutability, wording::TRANSITION_WRITES);
    }
    match &segment.arguments {
        PathArguments::AngleBracketed(list) => match list.args.first() {
            Some(GenericArgument::Type(of)) => Some(Argument::Rate(of.clone())),
            _ => complain(report, segment, wording::RATE_OF_WHAT),
        },
        _ => complain(report, segment, wording::RATE_OF_WHAT),
    }
}

fn link(reference: &TypeReference, own: &Type, form: Form, report: &mut Report) -> Option<Argument> {
    let child = plain(&reference.elem).clone();
    let written = text::written(&child);
    if written == "Self" || written == text::written(own) {
        return complain(report, &child, wording::OWN_LINK);
    }
    match &reference.mutability {
        Some(token) if form == Form::Condition => complain(report, token, wording::TRANSITION_WRITES),
        Some(_) => Some(Argument::Write(child)),
        None => Some(Argument::Read(child)),
    }
}
