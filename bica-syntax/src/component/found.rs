//! What a transition found, as an argument of an entry hook: `Found<T>`, or `Option<Found<T>>` in an initial state.

use syn::{FnArg, PathArguments, PathSegment, Signature, Type};

use super::arguments::{Form, only_type, only_type_of};
use super::model::Found;
use crate::report::Report;
use crate::types::{plain, unsized_argument};
use crate::{text, wording};

/// Whether a type is written as `Found`, borrowed or not, or as an `Option` of it.
pub(super) fn is_found(kind: &Type) -> bool {
    match plain(kind) {
        Type::Reference(reference) => is_found(&reference.elem),
        Type::Path(_) => last(kind).is_some() || only_type_of(kind, "Option").is_some_and(is_found),
        _ => false,
    }
}

/// Whether a function has an argument that [`is_found`].
pub(super) fn is_taken(signature: &Signature) -> bool {
    signature.inputs.iter().any(|input| matches!(input, FnArg::Typed(input) if is_found(&input.ty)))
}

/// The last name of a type that is written as `Found`, by any path.
fn last(kind: &Type) -> Option<&PathSegment> {
    let Type::Path(path) = plain(kind) else { return None };
    path.path.segments.last().filter(|last| last.ident == "Found")
}

/// Reads an argument that [`is_found`].
pub(super) fn argument(kind: &Type, form: Form, report: &mut Report) -> Option<Found> {
    if form != Form::Entry {
        report.add(kind, wording::FOUND_ELSEWHERE);
        return None;
    }
    let inner = only_type_of(kind, "Option");
    let Some(segment) = last(inner.unwrap_or(kind)) else {
        report.add(kind, wording::FOUND_BORROWED);
        return None;
    };
    let Some(of) = only_type(segment) else {
        report.add(segment, wording::FOUND_OF_WHAT);
        return None;
    };
    if let Some(all) = several(segment) {
        report.add(segment, wording::found_several(&all));
        return None;
    }
    value(of, report).then(|| Found { written: kind.clone(), of: plain(of).clone(), optional: inner.is_some() })
}

/// The types in angle brackets, if there are several.
fn several(segment: &PathSegment) -> Option<String> {
    let PathArguments::AngleBracketed(list) = &segment.arguments else { return None };
    (list.args.len() > 1).then(|| text::written(&list.args))
}

/// Reports a type that no transition can carry; returns whether it is none of these.
pub(super) fn value(of: &Type, report: &mut Report) -> bool {
    if let Type::Reference(reference) = plain(of) {
        report.add(of, wording::found_reference(&text::written(&reference.elem)));
        return false;
    }
    if let Some(part) = unsized_argument(of) {
        report.add(part, wording::no_size(&text::written(part)));
        return false;
    }
    true
}
