//! A call of one of the component's functions, with what its signature asks for.

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, format_ident, quote, quote_spanned};

use crate::expand::quoting::{at, placed};
use crate::language::component::model::{Argument, Function};

/// A block that lends and calls; its value is what the function returns.
pub(super) fn expand(p: &TokenStream, function: &Function) -> TokenStream {
    let name = &function.name;
    let loan = loan(p, function);
    let lent = children(function).rev().fold(quote!(()), |rest, (place, ..)| {
        let binding = binding(place);
        quote!((#binding, #rest))
    });
    let timed = function.arguments.iter().any(|argument| matches!(argument, Argument::Time(_)));
    let time = timed.then(|| quote!(let time = cycle.time::<Self>();));
    let given = function.arguments.iter().enumerate().map(|(place, argument)| match argument {
        Argument::Time(kind) => {
            let p = placed(p, at(kind));
            quote_spanned!(at(kind) => <#kind as #p::CycleTime>::of(&time))
        }
        _ => binding(place).to_token_stream(),
    });
    quote! {{
        #time
        let (this, #lent) = cycle.lend::<Self, #loan>();
        Self::#name(this #(, #given)*)
    }}
}

/// The type of the loan: nested pairs, ended by `()`.
fn loan(p: &TokenStream, function: &Function) -> TokenStream {
    children(function).rev().fold(quote!(()), |rest, (_, kind, child)| quote!((#p::#kind<#child>, #rest)))
}

/// The arguments that are lent: their places, how, and of which type.
fn children(function: &Function) -> impl DoubleEndedIterator<Item = (usize, TokenStream, TokenStream)> {
    function.arguments.iter().enumerate().filter_map(|(place, argument)| match argument {
        Argument::Time(_) => None,
        Argument::Read(child) => Some((place, quote!(Read), child.to_token_stream())),
        Argument::Write(child) => Some((place, quote!(Write), child.to_token_stream())),
        Argument::Rate(child) => Some((place, quote!(Pace), child.to_token_stream())),
        Argument::OwnRate => Some((place, quote!(Pace), quote!(Self))),
    })
}

fn binding(place: usize) -> Ident {
    format_ident!("a{place}")
}
