//! The signature is the graph: its rules.

use syn::{FnArg, Receiver, ReceiverKind, ReturnType, Safety, Signature, Type};

use super::arguments;
use super::model::Argument;
use crate::language::report::Report;
use crate::language::{text, wording};

/// What is asked of a signature.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Form {
    /// Links of both kinds.
    Step,
    /// Links that read, and a `bool`.
    Condition,
    /// No links.
    Plain,
}

/// Reads the arguments and reports what a function of that form may not have.
pub(crate) fn read(signature: &Signature, own: &Type, form: Form, report: &mut Report) -> Vec<Argument> {
    if let Some(token) = &signature.asyncness {
        report.add(token, wording::ASYNC);
    }
    if let Safety::Unsafe(token) = &signature.safety {
        report.add(token, wording::UNSAFE);
    }
    if !signature.generics.params.is_empty() {
        report.add(&signature.generics, wording::GENERIC);
    }
    receiver(signature, form, report);
    output(signature, form, report);
    arguments::read(signature, own, form, report)
}

fn receiver(signature: &Signature, form: Form, report: &mut Report) {
    let name = signature.ident.to_string();
    let wanted = if form == Form::Condition { "&self" } else { "&mut self" };
    match signature.inputs.first() {
        Some(FnArg::Receiver(receiver)) if fits(receiver, form) => {}
        Some(FnArg::Receiver(receiver)) if fits(receiver, Form::Step) => {
            report.add(receiver, wording::TRANSITION_WRITES);
        }
        Some(FnArg::Receiver(receiver)) => report.add(receiver, wording::receiver(&name, wanted)),
        _ => report.add(&signature.ident, wording::receiver(&name, wanted)),
    }
}

fn fits(receiver: &Receiver, form: Form) -> bool {
    match &receiver.kind {
        ReceiverKind::Reference(_, _, mutable) => mutable.is_none() || form != Form::Condition,
        _ => false,
    }
}

fn output(signature: &Signature, form: Form, report: &mut Report) {
    let name = signature.ident.to_string();
    match (&signature.output, form) {
        (ReturnType::Type(_, kind), Form::Condition) if text::written(kind) == "bool" => {}
        (ReturnType::Type(_, kind), Form::Condition) => report.add(kind, wording::returns_bool(&name)),
        (ReturnType::Default, Form::Condition) => report.add(&signature.ident, wording::returns_bool(&name)),
        (ReturnType::Type(_, kind), _) if text::written(kind) != "()" => {
            report.add(kind, wording::returns_nothing(&name));
        }
        _ => {}
    }
}
