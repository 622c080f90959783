//! `#[work]`, a function that runs beside the loop, and `&mut Work<Self>`, by which the component begins its jobs.

use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::ToTokens;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Attribute, Expr, FnArg, Meta, PathSegment, ReturnType, Signature, Token, Type, TypeReference};

use super::arguments::{Form, is_own, only_type, only_type_of};
use super::block;
use super::model::{Argument, Component, Work};
use super::signature;
use crate::code::Code;
use crate::report::{Mistake, Report, coded};
use crate::types::plain;
use crate::{number, text, wording};

/// The words of the attribute.
const KEYS: [&str; 2] = ["takes_ms", "slices"];

/// Names that a user may try for the time.
const SYNONYMS: [&str; 7] = ["ms", "time_ms", "takes", "takes_us", "takes_s", "duration_ms", "budget_ms"];

/// Reads a function with the attribute; `None` with the mistakes reported if it cannot be one.
pub(super) fn read(function: &block::Function, attribute: &Attribute, report: &mut Report) -> Option<Work> {
    let (takes_ms, slices) = report.take(time(attribute))?;
    let signature = &function.signature;
    let mistakes = report.mistakes().len();
    signature::read_work(signature, report);
    let inputs: Vec<(Ident, Type)> = inputs(signature, report);
    let output = output(signature, report);
    let (inputs, output) = if slices {
        sliced(signature, &inputs, &output?, report)?
    } else {
        for (_, kind) in &inputs {
            report_borrowed(kind, report);
        }
        (inputs, output?)
    };
    (report.mistakes().len() == mistakes).then(|| Work {
        name: signature.ident.clone(),
        doc: text::doc(&function.attributes),
        takes_ms,
        slices,
        inputs,
        output,
    })
}

/// `takes_ms = 200, slices`
fn time(attribute: &Attribute) -> Result<(u32, bool), Mistake> {
    let form = |at: &dyn ToTokens| Mistake::from(syn::Error::new_spanned(at.to_token_stream(), wording::WORK_FORM));
    let Meta::List(list) = &attribute.meta else { return Err(form(attribute)) };
    let (mut takes_ms, mut slices) = (None, false);
    coded(|uncoded| {
        list.parse_args_with(|input: ParseStream| {
            while !input.is_empty() {
                let key = Ident::parse_any(input).map_err(|found| syn::Error::new(found.span(), wording::WORK_FORM))?;
                match text::name(&key).as_str() {
                    "takes_ms" if takes_ms.is_none() => takes_ms = Some(milliseconds(input)?),
                    "slices" if !slices => slices = true,
                    "takes_ms" | "slices" => return Err(syn::Error::new(key.span(), wording::TWICE)),
                    other => return Err(uncoded(unknown(&key, other))),
                }
                if !input.is_empty() {
                    let comma = input.parse::<Token![,]>();
                    comma.map_err(|found| syn::Error::new(found.span(), wording::WORK_FORM))?;
                }
            }
            Ok(())
        })
    })?;
    takes_ms.map(|ms| (ms, slices)).ok_or_else(|| form(attribute))
}

fn unknown(key: &Ident, written: &str) -> Mistake {
    let nearest = if SYNONYMS.contains(&written) { Some("takes_ms") } else { text::nearest(written, KEYS.into_iter()) };
    Mistake::new(key, Code::unknown_key(written, nearest, "`takes_ms` and `slices`"))
}

/// `= 200`
fn milliseconds(input: ParseStream) -> syn::Result<u32> {
    let missing = |found: syn::Error| syn::Error::new(found.span(), wording::not_whole("takes_ms"));
    input.parse::<Token![=]>().map_err(missing)?;
    let value: Expr = input.parse().map_err(missing)?;
    match number::milliseconds(&value, "takes_ms") {
        Ok(0) => Err(syn::Error::new_spanned(&value, wording::not_positive("takes_ms"))),
        Ok(ms) => Ok(ms),
        Err(problem) => Err(syn::Error::new_spanned(&value, problem)),
    }
}

/// The arguments, each with a name for generated code.
fn inputs(signature: &Signature, report: &mut Report) -> Vec<(Ident, Type)> {
    let mut inputs = Vec::new();
    for input in &signature.inputs {
        match input {
            FnArg::Receiver(receiver) => report.add(receiver, wording::WORK_RECEIVER),
            FnArg::Typed(input) => {
                super::arguments::unconditional(&input.attrs, report);
                let name = match &*input.pat {
                    syn::Pat::Ident(name) => name.ident.clone(),
                    other => Ident::new(&format!("a{}", inputs.len()), syn::spanned::Spanned::span(other)),
                };
                inputs.push((name, (*input.ty).clone()));
            }
        }
    }
    inputs
}

/// The type that it returns; reports a function that returns nothing.
fn output(signature: &Signature, report: &mut Report) -> Option<Type> {
    match &signature.output {
        ReturnType::Type(_, kind) if text::written(kind) != "()" => {
            report_borrowed(kind, report);
            Some((**kind).clone())
        }
        _ => {
            report.add(&signature.ident, wording::work_returns(&text::name(&signature.ident)));
            None
        }
    }
}

/// The state and the result of `fn(state: &mut S) -> Option<T>`.
fn sliced(
    signature: &Signature,
    inputs: &[(Ident, Type)],
    output: &Type,
    report: &mut Report,
) -> Option<(Vec<(Ident, Type)>, Type)> {
    let form = wording::slices_form(&text::name(&signature.ident));
    let Some(result) = only_type_of(output, "Option") else {
        report.add(output, form);
        return None;
    };
    if let [(name, Type::Reference(TypeReference { mutability: Some(_), elem, .. }))] = inputs {
        report_borrowed(elem, report);
        return Some((vec![(name.clone(), (**elem).clone())], result.clone()));
    }
    let first = inputs.first().map(|(_, kind)| kind.to_token_stream());
    report.add(first.unwrap_or_else(|| signature.ident.to_token_stream()), form);
    None
}

/// Reports a type that a slot cannot store for longer than a call.
fn report_borrowed(kind: &Type, report: &mut Report) {
    if let Type::Reference(reference) = plain(kind)
        && reference.lifetime.as_ref().is_none_or(|lifetime| lifetime.ident != "static")
    {
        report.add(kind, wording::work_borrows(&text::written(&owned_form(&reference.elem))));
    } else if borrows(kind.to_token_stream()) {
        report.add(kind, wording::work_borrows_inside(&text::written(kind)));
    }
}

/// The type to write in place of a reference to `kind`.
fn owned_form(kind: &Type) -> TokenStream {
    match plain(kind) {
        Type::Slice(slice) => {
            let of = &slice.elem;
            quote::quote!([#of; N])
        }
        Type::Path(path) if path.path.is_ident("str") => quote::quote!(&'static str),
        other => other.to_token_stream(),
    }
}

/// Gives a result that is borrowed, which is reported, a lifetime, so that the compiler does not ask for one, too.
pub(super) fn without_borrowed(signature: &mut Signature) {
    if let ReturnType::Type(_, kind) = &mut signature.output
        && let Type::Reference(reference) = &mut **kind
    {
        reference.lifetime.get_or_insert_with(|| syn::parse_quote!('static));
    }
}

/// Whether a type contains a reference, unless it has a lifetime with a name, or `impl`.
fn borrows(kind: TokenStream) -> bool {
    let mut tokens = kind.into_iter().peekable();
    while let Some(token) = tokens.next() {
        let is_borrowed = match token {
            TokenTree::Punct(mark) if mark.as_char() == '&' => {
                !matches!(tokens.peek(), Some(TokenTree::Punct(next)) if next.as_char() == '\'')
            }
            TokenTree::Ident(word) => word == "impl",
            TokenTree::Group(group) => borrows(group.stream()),
            _ => false,
        };
        if is_borrowed {
            return true;
        }
    }
    false
}

/// Reads an argument whose type is called `Work`.
pub(super) fn argument(
    reference: &TypeReference,
    segment: &PathSegment,
    own: &Type,
    form: Form,
    report: &mut Report,
) -> Option<Argument> {
    let problem = match only_type(segment) {
        Some(of) if !is_own(of, own) => wording::work_of_another(&text::written(of)),
        _ if form == Form::Condition => wording::WORK_IN_CONDITION.to_owned(),
        Some(_) if reference.mutability.is_some() => return Some(Argument::Work((*reference.elem).clone())),
        _ => wording::WORK_ARGUMENT.to_owned(),
    };
    report.add(reference, problem);
    None
}

/// Whether a function takes a `Work`, also a wrong one.
#[must_use]
pub fn is_taken(signature: &Signature) -> bool {
    signature.inputs.iter().any(|input| match input {
        FnArg::Typed(input) => names_work(&input.ty),
        FnArg::Receiver(_) => false,
    })
}

fn names_work(kind: &Type) -> bool {
    match plain(kind) {
        Type::Reference(reference) => names_work(&reference.elem),
        Type::Path(path) => path.path.segments.last().is_some_and(|last| last.ident == "Work"),
        _ => false,
    }
}

/// Reports work that nothing begins, and an argument without work.
pub(super) fn check(component: &Component, report: &mut Report) {
    let taken = component.functions().flat_map(|function| &function.arguments).find_map(|argument| match argument {
        Argument::Work(written) => Some(written),
        _ => None,
    });
    match (&component.work, taken) {
        (None, Some(written)) => report.add(written, wording::WORK_WITHOUT_FUNCTION),
        // A wrong argument has its own message.
        (Some(work), None) if !component.block.functions().any(|function| is_taken(&function.signature)) => {
            report.add(&work.name, wording::work_never_begun(&text::name(&work.name)));
        }
        _ => {}
    }
}
