//! The rules for signatures, which are the graph.

use proc_macro2::TokenStream;
use quote::ToTokens;
use syn::{FnArg, GenericParam, Lifetime, Receiver, ReceiverKind, ReturnType, Safety, Signature, Type, parse_quote};

use super::arguments::{self, Form};
use super::found;
use super::model::Argument;
use crate::report::Report;
use crate::types::plain;
use crate::{text, wording};

/// Reads the arguments, and `T` of a condition that returns `Option<T>`; reports what a function of that form may not have.
pub(crate) fn read(
    signature: &Signature,
    own: &Type,
    form: Form,
    report: &mut Report,
) -> (Vec<Argument>, Option<Type>) {
    no_modifiers(signature, report);
    generics(signature, wording::GENERIC_LINK, report);
    receiver(signature, own, form, report);
    let carries = output(signature, form, report);
    (arguments::read(signature, own, form, report), carries)
}

/// `T` of a condition that returns `Option<T>`.
#[must_use]
pub fn carries(signature: &Signature) -> Option<&Type> {
    let ReturnType::Type(_, kind) = &signature.output else { return None };
    arguments::only_type_of(kind, "Option")
}

/// Whether a function returns what a condition may return.
pub(super) fn is_condition(signature: &Signature) -> bool {
    output(signature, Form::Condition, &mut Report::default()).is_some()
        || matches!(&signature.output, ReturnType::Type(_, kind) if is_bool(kind))
}

/// How a function that an operator calls takes its component or world.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Wanted {
    Shared,
    Exclusive,
    /// The world, exclusively.
    World,
}

/// Reports what a function that an operator calls may not have.
pub(crate) fn read_operator(signature: &Signature, own: &Type, wanted: Wanted, report: &mut Report) {
    no_modifiers(signature, report);
    generics(signature, wording::GENERIC, report);
    let as_wanted = match signature.inputs.first() {
        Some(FnArg::Receiver(receiver)) => {
            taken(receiver, own) == if wanted == Wanted::Shared { Taken::Shared } else { Taken::Exclusive }
        }
        _ => false,
    };
    if !as_wanted {
        let name = text::name(&signature.ident);
        let problem = match wanted {
            Wanted::Shared => wording::receiver(&name, "&self"),
            Wanted::Exclusive => wording::receiver(&name, "&mut self"),
            Wanted::World => wording::world_receiver(&name),
        };
        match signature.inputs.first() {
            Some(FnArg::Receiver(receiver)) => report.add(receiver, problem),
            _ => report.add(&signature.ident, problem),
        }
    }
}

/// Reports what a function that runs beside the loop may not have.
pub(super) fn read_work(signature: &Signature, report: &mut Report) {
    no_modifiers(signature, report);
    generics(signature, wording::GENERIC, report);
}

fn no_modifiers(signature: &Signature, report: &mut Report) {
    if let Some(token) = &signature.asyncness {
        report.add(token, wording::ASYNC);
    }
    if let Safety::Unsafe(token) = &signature.safety {
        report.add(token, wording::UNSAFE);
    }
}

fn generics(signature: &Signature, problem: &str, report: &mut Report) {
    let types: TokenStream = signature
        .generics
        .params
        .pairs()
        .filter(|pair| !matches!(pair.value(), GenericParam::Lifetime(_)))
        .map(ToTokens::into_token_stream)
        .collect();
    if !types.is_empty() {
        report.add(types, problem);
    } else if !signature.generics.params.is_empty() {
        report.add(&signature.generics, wording::LIFETIMES);
    }
}

/// How a function takes the component.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Taken {
    Shared,
    Exclusive,
    Otherwise,
}

fn receiver(signature: &Signature, own: &Type, form: Form, report: &mut Report) {
    let name = text::name(&signature.ident);
    let wanted = if form == Form::Condition { "&self" } else { "&mut self" };
    let Some(FnArg::Receiver(receiver)) = signature.inputs.first() else {
        report.add(&signature.ident, wording::receiver(&name, wanted));
        return;
    };
    arguments::unconditional(&receiver.attrs, report);
    match taken(receiver, own) {
        Taken::Otherwise => report.add(receiver, wording::receiver(&name, wanted)),
        Taken::Exclusive if form == Form::Condition => report.add(receiver, wording::TRANSITION_WRITES),
        _ => {
            if let Some(lifetime) = lifetime(receiver)
                && signature.generics.params.is_empty()
            {
                arguments::no_lifetime(lifetime, report);
            }
        }
    }
}

/// Reports a function before transitions that cannot keep for them what it finds, and mends it, so that the compiler does not refuse what
/// it writes, too.
pub(super) fn writes(signature: &mut Signature, own: &Type, report: &mut Report) {
    if let Some(FnArg::Receiver(receiver)) = signature.inputs.first_mut()
        && taken(receiver, own) == Taken::Shared
    {
        report.add(&*receiver, wording::BEFORE_READS);
        *receiver = parse_quote!(&mut self);
    }
}

/// Whether a method takes `self` by reference, in any form.
pub(crate) fn borrows(receiver: &Receiver) -> bool {
    taken(receiver, &parse_quote!(Self)) != Taken::Otherwise
}

fn taken(receiver: &Receiver, own: &Type) -> Taken {
    let mutable = match &receiver.kind {
        ReceiverKind::Reference(_, _, mutable) => mutable.is_some(),
        ReceiverKind::Typed(_, kind) => match plain(kind) {
            Type::Reference(reference) if arguments::is_own(&reference.elem, own) => reference.mutability.is_some(),
            _ => return Taken::Otherwise,
        },
        _ => return Taken::Otherwise,
    };
    if mutable { Taken::Exclusive } else { Taken::Shared }
}

fn lifetime(receiver: &Receiver) -> Option<&Lifetime> {
    match &receiver.kind {
        ReceiverKind::Reference(_, lifetime, _) => lifetime.as_ref(),
        ReceiverKind::Typed(_, kind) => match plain(kind) {
            Type::Reference(reference) => reference.lifetime.as_ref(),
            _ => None,
        },
        _ => None,
    }
}

/// Checks what a function returns; `T` of a condition that returns `Option<T>`.
fn output(signature: &Signature, form: Form, report: &mut Report) -> Option<Type> {
    let name = text::name(&signature.ident);
    match (&signature.output, form) {
        (ReturnType::Type(_, kind), Form::Condition) if is_bool(kind) => {}
        (_, Form::Condition) if let Some(of) = carries(signature) => {
            return found::value(of, report).then(|| plain(of).clone());
        }
        (ReturnType::Type(_, kind), Form::Condition) => report.add(kind, wording::returns_bool(&name)),
        (ReturnType::Default, Form::Condition) => report.add(&signature.ident, wording::returns_bool(&name)),
        (ReturnType::Type(_, kind), _) if text::written(kind) != "()" => {
            report.add(kind, wording::returns_nothing(&name));
        }
        _ => {}
    }
    None
}

/// Whether a type is `bool`, by any path.
fn is_bool(kind: &Type) -> bool {
    matches!(plain(kind), Type::Path(path) if path.path.segments.last().is_some_and(|last| last.ident == "bool"))
}
