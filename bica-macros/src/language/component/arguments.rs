//! Arguments: links, the time, rates.

use syn::{FnArg, GenericArgument, PathArguments, PathSegment, Signature, Type, TypeReference};

use super::model::Argument;
use super::signature::Form;
use crate::language::report::Report;
use crate::language::{text, wording};

/// Reads the arguments beside `self`. One with a mistake still counts as the link that it was meant to be.
pub(crate) fn read(signature: &Signature, own: &Type, form: Form, report: &mut Report) -> Vec<Argument> {
    let mut arguments = Vec::new();
    let mut seen: Vec<String> = Vec::new();
    for input in &signature.inputs {
        let FnArg::Typed(input) = input else { continue };
        if form == Form::Plain {
            report.add(input, wording::HOOK_LINKS);
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
        Type::Path(_) => {
            report.add(kind, wording::owned(&text::written(kind)));
            return Some(Argument::Write(kind.clone()));
        }
        _ => return no_component(kind, report),
    };
    let Type::Path(path) = plain(&reference.elem) else { return no_component(&reference.elem, report) };
    let segment = path.path.segments.last()?;
    if let (Some(token), Form::Condition) = (&reference.mutability, form) {
        report.add(token, wording::TRANSITION_WRITES);
    }
    match segment.ident.to_string().as_str() {
        "Time" => {
            if reference.mutability.is_some() {
                report.add(kind, wording::TIME);
            }
            Some(Argument::Time)
        }
        "Rate" => rate(reference, segment, own, report),
        _ => link(reference, own, report),
    }
}

fn no_component(kind: &Type, report: &mut Report) -> Option<Argument> {
    report.add(kind, wording::no_component(&text::written(kind)));
    None
}

/// The type without the invisible brackets that a `macro_rules` macro puts around it.
fn plain(mut kind: &Type) -> &Type {
    while let Type::Group(group) = kind {
        kind = &group.elem;
    }
    kind
}

fn rate(reference: &TypeReference, segment: &PathSegment, own: &Type, report: &mut Report) -> Option<Argument> {
    if reference.mutability.is_none() {
        report.add(reference, wording::RATE);
    }
    if let PathArguments::AngleBracketed(list) = &segment.arguments
        && let Some(GenericArgument::Type(of)) = list.args.first()
    {
        return Some(if is_own(of, own) { Argument::OwnRate } else { Argument::Rate(of.clone()) });
    }
    report.add(segment, wording::RATE_OF_WHAT);
    None
}

fn link(reference: &TypeReference, own: &Type, report: &mut Report) -> Option<Argument> {
    let child = plain(&reference.elem).clone();
    if is_own(&child, own) {
        report.add(&child, wording::OWN_LINK);
        return None;
    }
    Some(if reference.mutability.is_some() { Argument::Write(child) } else { Argument::Read(child) })
}

fn is_own(kind: &Type, own: &Type) -> bool {
    let written = text::written(kind);
    written == "Self" || written == text::written(own)
}
