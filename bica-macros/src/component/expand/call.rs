//! A call of one of the component's functions, with what its signature asks for.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use crate::component::model::{Argument, Function};

/// A block that lends and calls; its value is what the function returns.
pub(super) fn expand(p: &TokenStream, function: &Function) -> TokenStream {
    let name = &function.name;
    let mut loan = quote!(());
    let mut lent = quote!(());
    for (place, argument) in function.arguments.iter().enumerate().rev() {
        let (kind, child) = match argument {
            Argument::Time => continue,
            Argument::Read(child) => (quote!(Read), child),
            Argument::Write(child) => (quote!(Write), child),
            Argument::Rate(child) => (quote!(Pace), child),
        };
        let binding = format_ident!("a{place}");
        loan = quote!((#p::#kind<#child>, #loan));
        lent = quote!((#binding, #lent));
    }
    let timed = function.arguments.iter().any(|argument| matches!(argument, Argument::Time));
    let time = timed.then(|| quote!(let time = cycle.time::<Self>();));
    let given = function.arguments.iter().enumerate().map(|(place, argument)| {
        let binding = format_ident!("a{place}");
        if matches!(argument, Argument::Time) { quote!(&time) } else { quote!(#binding) }
    });
    quote! {{
        #time
        let (this, #lent) = cycle.lend::<Self, #loan>();
        Self::#name(this #(, #given)*)
    }}
}
