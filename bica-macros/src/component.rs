//! `#[component]`: parse → check → expand.

use proc_macro2::TokenStream;
use quote::ToTokens;
use syn::{FnArg, Type};

use crate::expand::component as expand;
use crate::expand::quoting::{at, settled};
use bica_syntax::component::block::{Block, Item};
use bica_syntax::component::parse::{Parsed, parse};
use bica_syntax::component::{check, work};
use bica_syntax::report::Report;

/// Expands `#[component(options)] item`.
pub(crate) fn run(options: TokenStream, item: &TokenStream) -> TokenStream {
    let mut report = Report::default();
    let mut component = match parse(options, item, &mut report) {
        Parsed::Component(component) => component,
        Parsed::Misplaced { item, of } => return expand::misplaced(&item, of.as_deref(), &report),
    };
    // Behind an `impl` of the user's text, the compiler offers an unknown type in angle brackets as a parameter of the block. It
    // offers none in generated code, and two different messages are both shown.
    component.block.header.impl_token.span = at(&component.block.header.impl_token);
    match check::check(&component, &mut report) {
        Some(behaviour) if report.is_empty() => {
            settle(&mut component.block);
            expand::expand(&component, &behaviour)
        }
        _ => {
            // Without the function of work, which may be the mistake, `Work<Self>` would be a further one.
            component.block.items.retain(|item| !matches!(item, Item::Function(one) if work::is_taken(&one.signature)));
            expand::stub(&component, &report)
        }
    }
}

/// Children that are no types are mistakes in the signatures and in generated code: see [`settled`].
fn settle(block: &mut Block) {
    for item in &mut block.items {
        let Item::Function(function) = item else { continue };
        for argument in &mut function.signature.inputs {
            if let FnArg::Typed(argument) = argument
                && let Type::Reference(reference) = &mut *argument.ty
                && names_a_child(&reference.elem)
            {
                *reference.elem = Type::Verbatim(settled(&reference.elem.to_token_stream()));
            }
        }
    }
}

fn names_a_child(kind: &Type) -> bool {
    let last = if let Type::Path(path) = kind { path.path.segments.last() } else { None };
    last.is_some_and(|last| ["Time", "Tuned", "Work"].iter().all(|other| last.ident != other))
}
