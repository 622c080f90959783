//! A call of one of the component's functions, with what its signature asks for.

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, format_ident, quote, quote_spanned};

use super::role;
use super::tuning::Tuning;
use crate::expand::quoting::{at, placed};
use bica_syntax::component::model::{Argument, Function};

/// A block that borrows and calls; its value is what the function returns.
pub(super) fn expand(p: &TokenStream, function: &Function, tuning: &Tuning) -> TokenStream {
    let name = &function.name;
    let set = borrow_set(p, function);
    let borrowed = nested(children(p, function).map(|(place, ..)| binding(place).into_token_stream()).collect());
    let timed = function.arguments.iter().any(|argument| matches!(argument, Argument::Time(_)));
    let time = timed.then(|| quote!(let time = cycle.time::<Self>();));
    let works = function.arguments.iter().any(|argument| matches!(argument, Argument::Work(_)));
    let work = works.then(|| quote!(let mut work = cycle.work::<Self>().borrow();));
    let tuned = tuned(function);
    let told = function.arguments.iter().enumerate().filter_map(|(place, argument)| {
        let name = binding(place);
        match argument {
            Argument::Age(of) => {
                let of = role::child(p, of);
                Some(quote!(let #name = cycle.age::<#of>();))
            }
            Argument::Outcome(of) => {
                let of = role::child(p, of);
                Some(quote!(let #name = cycle.outcome::<#of>();))
            }
            _ => None,
        }
    });
    let told: TokenStream = told.collect();
    let given = function.arguments.iter().enumerate().map(|(place, argument)| match argument {
        Argument::Time(kind) => {
            let p = placed(p, at(kind));
            quote_spanned!(at(kind) => <#kind as #p::CycleTime>::of(&time))
        }
        Argument::Tuned(kind) => tuning.argument(kind),
        Argument::Age(_) | Argument::Outcome(_) => {
            let told = binding(place);
            quote!(&#told)
        }
        Argument::Found(found) => quote_spanned!(at(&found.written) => found),
        Argument::Work(written) => quote_spanned!(at(written) => &mut work),
        _ => binding(place).to_token_stream(),
    });
    quote! {{
        #time
        #tuned
        #work
        #told
        let (this, #borrowed) = cycle.borrow::<Self, #set>();
        Self::#name(this #(, #given)*)
    }}
}

/// Fetches the parameters, if the function takes any.
pub(super) fn tuned(function: &Function) -> Option<TokenStream> {
    let takes = function.arguments.iter().any(|argument| matches!(argument, Argument::Tuned(_)));
    takes.then(|| quote!(let tuned = cycle.tuned::<Self>();))
}

/// The type of what is borrowed together.
fn borrow_set(p: &TokenStream, function: &Function) -> TokenStream {
    nested(children(p, function).map(|(_, kind, child)| quote!(#p::#kind<#child>)).collect())
}

/// Pairs of pairs around the parts, as flat as possible: the compiler limits how deep types may nest.
pub(super) fn nested(mut parts: Vec<TokenStream>) -> TokenStream {
    if parts.len() < 2 {
        return parts.pop().unwrap_or_else(|| quote!(()));
    }
    let right = nested(parts.split_off(parts.len() / 2));
    let left = nested(parts);
    quote!((#left, #right))
}

/// The arguments that are borrowed: their places, how, and of which type.
fn children(
    p: &TokenStream,
    function: &Function,
) -> impl DoubleEndedIterator<Item = (usize, TokenStream, TokenStream)> {
    function.arguments.iter().enumerate().filter_map(move |(place, argument)| match argument {
        Argument::Time(_)
        | Argument::Age(_)
        | Argument::Outcome(_)
        | Argument::Tuned(_)
        | Argument::Found(_)
        | Argument::Work(_) => None,
        Argument::Read(child) => Some((place, quote!(Read), role::child(p, child))),
        Argument::Write(child) => Some((place, quote!(Write), role::child(p, child))),
        Argument::Rate(child) => Some((place, quote!(WriteRate), role::child(p, child))),
        Argument::OwnRate => Some((place, quote!(WriteRate), quote!(Self))),
    })
}

fn binding(place: usize) -> Ident {
    format_ident!("a{place}")
}
